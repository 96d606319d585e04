//! A page that a command writes.

use std::path::{Path, PathBuf};

use meshmend::formats::Document;
use meshmend::report::CheckDocument;
use meshmend::{CheckReport, Rules};
use meshmend_report::{Entry, EntryOptions, Page};

use crate::console::Console;
use crate::failure::Failure;
use crate::render::printable;
use crate::streams::{name, output_name, write_with};

/// How many items each list of a page has, unless the command line says otherwise.
pub(crate) const USUAL_LIMIT: usize = 1000;

/// What a page on some files is called, unless it is said.
pub(crate) fn title(said: Option<&str>, files: &[PathBuf]) -> String {
    match (said, files) {
        (Some(said), _) => said.to_owned(),
        (None, [file]) => {
            file.file_name().map_or_else(|| name(file), |name| name.to_string_lossy().into_owned())
        }
        _ => format!("{} files", files.len()),
    }
}

/// A page, and what of meshes is put into it.
pub(crate) struct PageFile {
    pub(crate) page: Page,
    pub(crate) options: EntryOptions,
}

impl PageFile {
    pub(crate) fn of(title: &str, rules: Rules, options: EntryOptions) -> Self {
        let mut page = Page::titled(title);
        page.rules = rules;
        PageFile { page, options }
    }

    /// Adds entries that were made.
    pub(crate) fn add(&mut self, entries: Result<Vec<Entry>, serde_json::Error>) -> Result<(), Failure> {
        self.page.entries.extend(entries.map_err(|error| Failure::unwritable("report", error))?);
        Ok(())
    }

    /// Adds a part of a file with the report on it. A part without one is sealed, and only named.
    pub(crate) fn add_part(
        &mut self,
        (file, document, number): (&Path, &Document, usize),
        report: Option<&CheckReport>,
        limit: usize,
    ) -> Result<(), Failure> {
        let part = &document.parts[number];
        let Some(report) = report else {
            let reason = part.seal().unwrap_or_default();
            self.page.entries.push(Entry::without(&name(file), reason).of_part(part.title()));
            return Ok(());
        };
        let shown = CheckDocument {
            file: Some(name(file)),
            format: Some(document.variant),
            notes: document.notes.clone(),
            ..CheckDocument::new(report.clone(), limit)
        };
        let entry = Entry::of_check(&name(file), (&part.mesh, report), &shown, &self.options);
        self.add(
            entry.map(|entry| vec![if document.is_whole() { entry } else { entry.of_part(part.title()) }]),
        )
    }

    /// Adds a file that could not be read or checked.
    pub(crate) fn add_failure(&mut self, file: &Path, failure: &Failure) {
        self.page.entries.push(Entry::without(&name(file), &failure.message));
    }

    pub(crate) fn write(&self, path: &Path, console: &mut Console<'_>) -> Result<(), Failure> {
        write_with(path, console, |out| self.page.write(out))?;
        console.write(&format!(
            "{}: {}\n",
            output_name(path),
            match self.page.entries.len() {
                1 => "1 mesh".to_owned(),
                count => format!("{count} meshes"),
            }
        ))
    }

    /// A line for each mesh.
    pub(crate) fn told(&self) -> String {
        let line = |entry: &Entry| format!("{}: {}\n", printable(&entry.title()), printable(entry.verdict()));
        self.page.entries.iter().map(line).collect()
    }
}
