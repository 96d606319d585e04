//! How soon work stops when it is told to: the longest stretch of processor time between two looks at its watch.

use std::ops::ControlFlow;
use std::path::Path;
use std::sync::{Arc, Mutex, PoisonError};

use cpu_time::ProcessTime;
use meshmend::mesh::{Progress, Watch};
use meshmend::{
    CheckOptions, Distance, GeometryOptions, Plan, PolygonMesh, ReadOptions, Session, View, check, read,
    write,
};
use serde::{Deserialize, Serialize};

use crate::failure::Failure;
use crate::inputs::{Content, Folder, Form, Input, Order, load};
use crate::rows::{own_process, told};

/// The longest stretch of some work.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub(crate) struct Stretch {
    /// What was done.
    pub(crate) work: String,
    /// How often there was a look.
    pub(crate) looks: u64,
    /// Processor time of all threads between two looks, in seconds.
    pub(crate) longest: f64,
    /// The step at whose look it began, and at which look of that step in a row.
    pub(crate) after: String,
    /// Processor time of the whole work, in seconds.
    pub(crate) total: f64,
}

/// What is watched.
struct Work {
    name: &'static str,
    content: Content,
    what: What,
}

enum What {
    /// A file that is read.
    Reading(Form),
    /// A mesh in memory, of which something is asked or made.
    OnMesh(fn(&PolygonMesh, &Watch) -> Result<(), Failure>),
    /// A mesh in memory that is written.
    Writing(Form),
}

const WORK: &[Work] = &[
    reading("read-obj", Form::Obj),
    reading("read-off", Form::Off),
    reading("read-ply", Form::PlyBinary),
    reading("read-ply-ascii", Form::PlyAscii),
    reading("read-stl", Form::StlBinary),
    reading("read-stl-ascii", Form::StlAscii),
    reading("read-glb", Form::Glb),
    Work { name: "check", content: Content::Dirty, what: What::OnMesh(checked) },
    Work { name: "check-soup", content: Content::Soup, what: What::OnMesh(checked) },
    Work { name: "check-geometry", content: Content::Finned, what: What::OnMesh(with_geometry) },
    Work { name: "repair", content: Content::Dirty, what: What::OnMesh(repaired) },
    Work { name: "repair-soup", content: Content::Soup, what: What::OnMesh(repaired) },
    Work { name: "repair-near", content: Content::Jittered, what: What::OnMesh(welded_near) },
    Work { name: "repair-pinched", content: Content::Pinched, what: What::OnMesh(repaired) },
    Work { name: "repair-all", content: Content::SmallSquares, what: What::OnMesh(in_full) },
    Work { name: "repair-all-soup", content: Content::Soup, what: What::OnMesh(in_full) },
    writing("write-obj", Form::Obj),
    writing("write-ply", Form::PlyBinary),
    writing("write-stl", Form::StlBinary),
    writing("write-glb", Form::Glb),
];

const fn reading(name: &'static str, form: Form) -> Work {
    Work { name, content: Content::Indexed, what: What::Reading(form) }
}

const fn writing(name: &'static str, form: Form) -> Work {
    Work { name, content: Content::Indexed, what: What::Writing(form) }
}

/// Work that only needs somebody who watches it.
type Task<'a> = Box<dyn Fn(&Watch) -> Result<(), Failure> + 'a>;

impl What {
    /// The form of the file in which the input is.
    fn form(&self) -> Form {
        match self {
            What::Reading(form) => *form,
            _ => Form::PlyBinary,
        }
    }

    /// What is done, with its input in memory where it is a mesh.
    fn task<'a>(&'a self, file: &'a Path, scratch: &'a Path) -> Result<Task<'a>, Failure> {
        Ok(match self {
            What::Reading(_) => Box::new(|watch| {
                read(file, &ReadOptions::default().with_watch(watch))?;
                Ok(())
            }),
            What::OnMesh(run) => {
                let mesh = load(file)?;
                Box::new(move |watch| run(&mesh, watch))
            }
            What::Writing(form) => {
                let mesh = load(file)?;
                let output = scratch.join(format!("watched.{}", form.extension()));
                Box::new(move |watch| {
                    write(&output, &mesh, &form.options().with_watch(watch))?;
                    Ok(())
                })
            }
        })
    }
}

fn checked(mesh: &PolygonMesh, watch: &Watch) -> Result<(), Failure> {
    let options = CheckOptions::default().with_view(View::Welded(Distance::Exact)).with_watch(watch);
    check(mesh, &options)?;
    Ok(())
}

fn with_geometry(mesh: &PolygonMesh, watch: &Watch) -> Result<(), Failure> {
    let geometry = GeometryOptions::all();
    check(mesh, &CheckOptions::default().with_geometry(geometry).with_watch(watch))?;
    Ok(())
}

fn repaired(mesh: &PolygonMesh, watch: &Watch) -> Result<(), Failure> {
    by_plan("", mesh, watch)
}

fn welded_near(mesh: &PolygonMesh, watch: &Watch) -> Result<(), Failure> {
    by_plan(&format!("[weld]\ndistance = {{ absolute = {} }}", crate::inputs::JITTER), mesh, watch)
}

/// A repair with every pass that is off unless it is asked for.
fn in_full(mesh: &PolygonMesh, watch: &Watch) -> Result<(), Failure> {
    const ALL: &str = "passes = ['weld', 'clean', 'orient', 'heal', 'split', 'fill', 'triangulate', 'slivers', 'drop', \
                       'outward', 'compact', 'verify']\n[fill]\nloops = 'all'\n[drop]\ninternal = 'remove-components'\n";
    by_plan(ALL, mesh, watch)
}

fn by_plan(text: &str, mesh: &PolygonMesh, watch: &Watch) -> Result<(), Failure> {
    let plan = Plan::from_toml(text)?;
    plan.pipeline().run_in(Session::begin(mesh).with_watch(watch))?;
    Ok(())
}

/// What has been seen of looks so far.
struct Seen {
    start: ProcessTime,
    last: f64,
    after: &'static str,
    /// How many looks in a row were at that step.
    in_row: u64,
    stretch: Stretch,
}

impl Seen {
    fn look(&mut self, step: &'static str) {
        let now = self.start.elapsed().as_secs_f64();
        if now - self.last > self.stretch.longest {
            self.stretch.longest = now - self.last;
            self.stretch.after = format!("{}, look {}", self.after, self.in_row);
        }
        self.in_row = if self.after == step { self.in_row + 1 } else { 1 };
        (self.last, self.after) = (now, step);
        self.stretch.looks += 1;
    }
}

/// Watches one piece of work, in this process.
pub(crate) fn measure(name: &str, file: &Path, scratch: &Path) -> Result<Stretch, Failure> {
    let found = WORK.iter().find(|work| work.name == name);
    let work = found.ok_or_else(|| Failure::NoSuchOperation(name.to_owned()))?;
    let task = work.what.task(file, scratch)?;
    let stretch = Stretch { work: name.to_owned(), looks: 0, longest: 0.0, after: String::new(), total: 0.0 };
    let seen = Seen { start: ProcessTime::now(), last: 0.0, after: "the start", in_row: 0, stretch };
    let seen = Arc::new(Mutex::new(seen));
    let told = seen.clone();
    let watch = Watch::new(move |at: Progress| {
        told.lock().unwrap_or_else(PoisonError::into_inner).look(at.step);
        ControlFlow::Continue(())
    });
    task(&watch)?;
    let mut seen = seen.lock().unwrap_or_else(PoisonError::into_inner);
    seen.look("the end");
    Ok(Stretch { total: seen.last, ..seen.stretch.clone() })
}

/// Watches all work, each in a process of its own, and tells each stretch when it is known.
pub(crate) fn stretches(
    (order, faces, threads): (Order, usize, usize),
    folder: &Folder,
    mut tell: impl FnMut(&Stretch) -> Result<(), Failure>,
) -> Result<(), Failure> {
    for work in WORK {
        let file = folder.file(&Input { content: work.content, order, faces }, work.what.form())?;
        let mut child = own_process(threads)?;
        child.args(["measure-stops", work.name]).arg(&file).arg(folder.path());
        tell(&told(child, work.name)?)?;
    }
    Ok(())
}

impl Stretch {
    /// As a line of a table in Markdown.
    pub(crate) fn line(&self) -> String {
        let Stretch { work, looks, longest, after, total } = self;
        format!("| {work} | {looks} | {:.0} | {after} | {:.0} |", longest * 1e3, total * 1e3)
    }
}

/// The head of the table.
pub(crate) const HEAD: &str =
    "| work | looks | longest stretch, ms of processor time | it began at | all, ms |\n|---|--:|--:|---|--:|";
