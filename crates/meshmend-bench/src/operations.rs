//! What is measured: each operation with its input, what it does, and the figures that show that it was done right.

mod files;
mod geometry;
mod meshes;

use std::collections::BTreeMap;
use std::path::Path;

use meshmend::PolygonMesh;

use crate::failure::Failure;
use crate::inputs::{Content, Form, Input, Known, Order, load};

/// Figures of a result, by name.
pub(crate) type Figures = BTreeMap<String, u64>;

/// Looks at what an operation made, after its time was taken.
pub(crate) type Answer = Box<dyn FnOnce() -> Result<Figures, Failure>>;

/// What is measured.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Operation {
    /// What it is called in commands and reports.
    pub(crate) name: &'static str,
    /// What its input is.
    pub(crate) content: Content,
    pub(crate) work: Work,
    /// The figures of a right answer.
    expected: fn(&Known) -> Figures,
}

/// What an operation is given.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Work {
    /// A mesh that is in memory.
    OnMesh(fn(&PolygonMesh) -> Result<Answer, Failure>),
    /// A mesh that is in memory, to be written.
    Writing(Form),
    /// A file, and where another one may be written.
    OnFile(Form, fn(&Path, &Path) -> Result<Answer, Failure>),
}

/// An operation that has all it needs; it may be done again, but what the mesh remembers is not made anew.
pub(crate) type Task = Box<dyn Fn() -> Result<Answer, Failure>>;

/// Everything that is measured.
pub(crate) const OPERATIONS: &[Operation] = &[
    Operation {
        name: "weld",
        content: Content::Soup,
        work: Work::OnMesh(meshes::weld),
        expected: |known| figures([("vertices", known.mended_vertices)]),
    },
    Operation {
        name: "weld-tolerance",
        content: Content::Jittered,
        work: Work::OnMesh(meshes::weld_with_tolerance),
        expected: |known| figures([("vertices", known.mended_vertices)]),
    },
    Operation {
        name: "connectivity",
        content: Content::Indexed,
        work: Work::OnMesh(meshes::connectivity),
        expected: |known| figures([("edges", known.edges)]),
    },
    Operation {
        name: "edges",
        content: Content::Holes,
        work: Work::OnMesh(meshes::edges),
        expected: known_edges,
    },
    Operation {
        name: "edges-pinched",
        content: Content::Pinched,
        work: Work::OnMesh(meshes::edges),
        expected: known_edges,
    },
    Operation {
        name: "report",
        content: Content::Indexed,
        work: Work::OnMesh(meshes::report),
        expected: |known| figures([("edges", known.edges), ("components", 1), ("genus", 1)]),
    },
    Operation {
        name: "orient",
        content: Content::Flipped,
        work: Work::OnMesh(meshes::orient),
        expected: |known| figures([("faces", known.mended_faces), ("inconsistent_edges", 0)]),
    },
    Operation {
        name: "split",
        content: Content::Pinched,
        work: Work::OnMesh(meshes::split),
        expected: |known| {
            figures([("faces", known.faces), ("non_manifold_edges", 0), ("non_manifold_vertices", 0)])
        },
    },
    Operation {
        name: "clean",
        content: Content::Dirty,
        work: Work::OnMesh(meshes::clean),
        expected: |known| figures([("vertices", known.mended_vertices), ("faces", known.mended_faces)]),
    },
    Operation {
        name: "intersections",
        content: Content::Indexed,
        work: Work::OnMesh(geometry::intersections),
        expected: |_| figures([("crossing_faces", 0)]),
    },
    Operation {
        name: "intersections-crossed",
        content: Content::Finned,
        work: Work::OnMesh(geometry::intersections),
        expected: |known| figures([("crossing_faces", known.crossing_faces)]),
    },
    Operation {
        name: "fill-12",
        content: Content::SmallSquares,
        work: Work::OnMesh(geometry::fill),
        expected: |_| figures([("boundary_edges", 0), ("non_manifold_edges", 0)]),
    },
    Operation {
        name: "fill-32",
        content: Content::LargeSquares,
        work: Work::OnMesh(geometry::fill),
        expected: |_| figures([("boundary_edges", 0), ("non_manifold_edges", 0)]),
    },
    Operation {
        name: "generators",
        content: Content::Indexed,
        work: Work::OnMesh(meshes::generators),
        expected: |_| figures([("generators", 2)]),
    },
    Operation {
        name: "cut",
        content: Content::Indexed,
        work: Work::OnMesh(meshes::cut),
        expected: |known| {
            figures([("faces", known.faces), ("euler_characteristic", 1), ("boundary_loops", 1)])
        },
    },
    Operation {
        name: "process-ply",
        content: Content::Dirty,
        work: Work::OnFile(Form::PlyBinary, files::process),
        expected: mended,
    },
    Operation {
        name: "process-stl",
        content: Content::Soup,
        work: Work::OnFile(Form::StlBinary, files::process),
        expected: mended,
    },
    reading("read-ply", Form::PlyBinary),
    reading("read-ply-ascii", Form::PlyAscii),
    reading("read-obj", Form::Obj),
    reading("read-off", Form::Off),
    Operation { expected: read_soup, ..reading("read-stl", Form::StlBinary) },
    Operation {
        name: "read-stl-welded",
        content: Content::Indexed,
        work: Work::OnFile(Form::StlBinary, files::read_welded),
        expected: read_whole,
    },
    Operation { expected: read_soup, ..reading("read-stl-ascii", Form::StlAscii) },
    reading("read-glb", Form::Glb),
    writing("write-ply", Form::PlyBinary),
    writing("write-ply-ascii", Form::PlyAscii),
    writing("write-obj", Form::Obj),
    writing("write-off", Form::Off),
    writing("write-glb", Form::Glb),
    Operation { expected: read_soup, ..writing("write-stl", Form::StlBinary) },
    Operation { expected: read_soup, ..writing("write-stl-ascii", Form::StlAscii) },
];

const fn reading(name: &'static str, form: Form) -> Operation {
    Operation {
        name,
        content: Content::Indexed,
        work: Work::OnFile(form, files::read_file),
        expected: read_whole,
    }
}

const fn writing(name: &'static str, form: Form) -> Operation {
    Operation { name, content: Content::Indexed, work: Work::Writing(form), expected: read_whole }
}

impl Operation {
    /// The operation with a name.
    pub(crate) fn named(name: &str) -> Result<&'static Self, Failure> {
        let found = OPERATIONS.iter().find(|operation| operation.name == name);
        found.ok_or_else(|| Failure::NoSuchOperation(name.to_owned()))
    }

    /// The operations with these names, all if there is none.
    pub(crate) fn all_named(names: &[String]) -> Result<Vec<&'static Self>, Failure> {
        if names.is_empty() {
            Ok(OPERATIONS.iter().collect())
        } else {
            names.iter().map(|name| Self::named(name)).collect()
        }
    }

    /// Its input in some order and size.
    pub(crate) fn input(&self, order: Order, faces: usize) -> Input {
        Input { content: self.content, order, faces }
    }

    /// In which form its input is kept.
    pub(crate) fn form(&self) -> Form {
        match self.work {
            Work::OnFile(form, _) => form,
            Work::OnMesh(_) | Work::Writing(_) => Form::PlyBinary,
        }
    }

    /// The figures of a right answer.
    pub(crate) fn expected(&self, input: &Input) -> Figures {
        (self.expected)(&input.known())
    }

    /// The operation with its input in memory, or with the file to read; what it writes goes into a folder.
    pub(crate) fn prepared(&self, file: &Path, scratch: &Path) -> Result<Task, Failure> {
        let (file, scratch) = (file.to_owned(), scratch.to_owned());
        Ok(match self.work {
            Work::OnFile(_, work) => Box::new(move || work(&file, &scratch)),
            Work::OnMesh(work) => {
                let mesh = load(&file)?;
                Box::new(move || work(&mesh))
            }
            Work::Writing(form) => {
                let mesh = load(&file)?;
                Box::new(move || files::write_file(&mesh, form, &scratch))
            }
        })
    }
}

fn figures<const N: usize>(named: [(&str, u64); N]) -> Figures {
    named.into_iter().map(|(name, value)| (name.to_owned(), value)).collect()
}

fn known_edges(known: &Known) -> Figures {
    figures([("boundary_edges", known.boundary_edges), ("non_manifold_edges", known.non_manifold_edges)])
}

fn mended(known: &Known) -> Figures {
    figures([
        ("vertices", known.mended_vertices),
        ("faces", known.mended_faces),
        ("inconsistent_edges", 0),
        ("non_manifold_edges", 0),
    ])
}

fn read_whole(known: &Known) -> Figures {
    figures([("vertices", known.mended_vertices), ("faces", known.faces)])
}

fn read_soup(known: &Known) -> Figures {
    figures([("vertices", 3 * known.faces), ("faces", known.faces)])
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::inputs::Folder;

    #[test]
    fn every_operation_gives_the_right_answer_in_either_order() {
        let folder = Folder::temporary().unwrap();
        for operation in OPERATIONS {
            for order in [Order::Mesh, Order::Shuffled] {
                let input = operation.input(order, 5_000);
                let file = folder.file(&input, operation.form()).unwrap();
                let answer = operation.prepared(&file, folder.path()).unwrap()().unwrap();
                assert_eq!(answer().unwrap(), operation.expected(&input), "{} {order:?}", operation.name);
            }
        }
    }

    #[test]
    fn names_are_unique_and_lead_back() {
        let mut names: Vec<&str> = OPERATIONS.iter().map(|operation| operation.name).collect();
        assert!(names.iter().all(|name| Operation::named(name).is_ok_and(|found| found.name == *name)));
        names.sort_unstable();
        names.dedup();
        assert_eq!(names.len(), OPERATIONS.len());
        assert!(matches!(Operation::named("spleen"), Err(Failure::NoSuchOperation(_))));
    }
}
