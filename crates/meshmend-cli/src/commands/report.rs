//! `meshmend report`: a page on meshes, with the meshes in it.

use std::path::{Path, PathBuf};
use std::time::SystemTime;

use clap::Args;
use humantime::format_rfc3339_seconds;
use meshmend::files::{FileRepair, FileTarget, Judged, PartChoice, WholeChecks};
use meshmend::formats::Document;
use meshmend::{CheckOptions, DefectKind, Format, View, WriteOptions, check};
use meshmend_report::{Entry, EntryOptions};

use crate::Program;
use crate::batch::listed;
use crate::commands::check::status_of;
use crate::console::Console;
use crate::failure::{Failure, Status};
use crate::format_words;
use crate::gate_words;
use crate::outputs::{Content, Files};
use crate::pages::{self, PageFile, USUAL_LIMIT};
use crate::repair_words::RepairWords;
use crate::streams::{self, InputWords, is_stream, name, reserve};

/// Write a page on meshes: what was wrong, where, what a repair does and what it leaves, with the meshes in 3D
///
/// The page is one file. It opens in any browser and asks no network for anything. The meshes are not changed.
#[derive(Debug, Args)]
pub(crate) struct Report {
    /// The files to report on; a folder stands for all meshes in it, and patterns such as `parts/*.stl` are understood
    #[arg(required = true, value_name = "IN")]
    pub(super) files: Vec<PathBuf>,
    /// The page to write, usually named `.html`; `-` is standard output
    #[arg(short, long, value_name = "PAGE")]
    output: PathBuf,
    /// Show what is wrong, and repair nothing
    #[arg(long)]
    check_only: bool,
    /// What the page is called [default: the name of the file]
    #[arg(long, value_name = "TITLE")]
    title: Option<String>,
    /// Say on the page when it was made; without, the same meshes give the same bytes
    #[arg(long)]
    date: bool,
    /// A mesh of more faces is shown by its defects, what is round them, and its shape
    #[arg(long, value_name = "N", default_value_t = EntryOptions::default().max_faces)]
    max_faces: usize,
    #[command(flatten)]
    from: InputWords,
    /// The format that the result of a repair would be written in, which tells what that loses [default: that of the input]
    #[arg(long = "to", value_name = "FORMAT", value_parser = format_words::format)]
    to: Option<Format>,
    /// Only the part of this name or number, in file order from 0; may be given several times
    #[arg(long = "part", value_name = "NAME")]
    parts: Vec<String>,
    #[command(flatten)]
    pub(super) words: RepairWords,
}

impl Report {
    pub(crate) fn run(self, program: &Program, console: &mut Console<'_>) -> Result<Status, Failure> {
        let repair = self.repair(program)?;
        let files = self.listed()?;
        let inputs = Files::default().reading("--plan", self.words.policies.plan_file(), Content::Plan);
        let inputs = inputs.reading_meshes(files.iter().map(PathBuf::as_path));
        inputs.writing("--output", Some(&self.output), Content::Report).check()?;
        reserve(&self.output, streams::Report::Text, console)?;

        let options = EntryOptions::default().with_max_faces(self.max_faces);
        let title = pages::title(self.title.as_deref(), &files);
        let mut page = PageFile::of(&title, program.rules, options);
        if self.date {
            page.page.date = Some(format_rfc3339_seconds(SystemTime::now()).to_string());
        }
        let mut status = Status::Done;
        for file in &files {
            if console.is_closed() {
                break;
            }
            let added = match self.check_only {
                true => self.add_checked(file, &repair, program, &mut page, console),
                false => self.add_repaired(file, &repair, &mut page, console),
            };
            status = status.and(match added {
                Ok(status) => status,
                Err(failure) if failure.status == Status::Usage => return Err(failure),
                Err(failure) => {
                    console.complain(&failure);
                    page.add_failure(file, &failure);
                    failure.status
                }
            });
        }
        let told = page.told();
        page.write(&self.output, console)?;
        console.write(&told)?;
        Ok(status)
    }

    /// The files that are named, and those in folders.
    fn listed(&self) -> Result<Vec<PathBuf>, Failure> {
        let mut files = Vec::new();
        for word in &self.files {
            if is_stream(word) || word.is_file() {
                files.push(word.clone());
            } else {
                files.extend(listed(word, Path::new(""))?.into_iter().map(|file| file.path));
            }
        }
        if files.is_empty() {
            return Err(Failure::usage("no mesh was found"));
        }
        Ok(files)
    }

    /// How files are repaired. What is wrong with the command line is told before anything is read.
    fn repair(&self, program: &Program) -> Result<FileRepair, Failure> {
        let mut repair = self.words.repair_showing(USUAL_LIMIT, program.rules)?;
        repair.parts = PartChoice::of(self.parts.clone());
        repair.judged = Judged::BeforeAndAfter;
        repair.checks = WholeChecks::Kept;
        Ok(repair)
    }

    fn add_repaired(
        &self,
        file: &Path,
        repair: &FileRepair,
        page: &mut PageFile,
        console: &mut Console<'_>,
    ) -> Result<Status, Failure> {
        let progress = console.progress(repair.plan.passes.len() + 4);
        progress.step(&format!("read {}", name(file)));
        let document = self.from.read_document(file, console)?;
        let target = self.target(&document);
        let repaired = repair.run(&name(file), document, Some(&target), &progress.watch())?;
        progress.step("draw");
        page.add(Entry::of_repair(&name(file), &repaired, &page.options))?;
        drop(progress);
        Ok(gate_words::judged(&name(file), repaired.failing(), true, console))
    }

    /// The output that would be written.
    fn target(&self, document: &Document) -> FileTarget {
        let options = WriteOptions::of(self.to.unwrap_or(document.format));
        FileTarget::new(String::new(), options.with_shell(document.shell.clone())).rehearsed()
    }

    fn add_checked(
        &self,
        file: &Path,
        repair: &FileRepair,
        program: &Program,
        page: &mut PageFile,
        console: &mut Console<'_>,
    ) -> Result<Status, Failure> {
        let progress = console.progress(2);
        progress.step(&format!("read {}", name(file)));
        let document = self.from.read_document(file, console)?;
        progress.step(&format!("check {}", name(file)));
        let options = CheckOptions::default().with_kernels(program.kernels).with_rules(program.rules);
        let options = options.with_geometry(repair.geometry);
        let fail_on: Vec<DefectKind> = repair.gate.defects();
        let mut status = Status::Done;
        for number in repair.parts.chosen(&document)? {
            let part = &document.parts[number];
            if part.seal().is_some() {
                page.add_part((file, &document, number), None, repair.limit)?;
                continue;
            }
            let options = options.clone().with_view(View::usual_for_part(document.format, part));
            let report =
                check(&part.mesh, &options).map_err(|error| Failure::of_pass(&name(file), &error))?;
            status = status.and(status_of(&report, &fail_on));
            page.add_part((file, &document, number), Some(&report.listing(&fail_on)), repair.limit)?;
        }
        Ok(status)
    }
}
