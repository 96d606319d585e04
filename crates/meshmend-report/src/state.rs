//! A mesh as it was or is, with what is to be seen on it.

use std::collections::BTreeMap;

use meshmend::{CheckReport, PolygonMesh};
use serde::Serialize;

use crate::EntryOptions;
use crate::loops::LoopData;
use crate::marks::{Marks, faces_near};
use crate::mesh::MeshData;
use crate::pictures::pictures;
use crate::thinned::thinned;

/// A mesh as it was or is, with what is to be seen on it.
#[derive(Clone, Debug, Serialize)]
pub(crate) struct State {
    mesh: MeshData,
    /// The shape of all of it, where `mesh` has only a part.
    #[serde(skip_serializing_if = "Option::is_none")]
    shape: Option<MeshData>,
    marks: BTreeMap<&'static str, Marks>,
    loops: LoopData,
    /// Still pictures, as URIs of their data.
    pictures: Vec<String>,
}

impl State {
    /// A mesh as stored, with a report on it, and positions about a point: the same for states that are to be compared.
    pub(crate) fn of(
        (stored, report): (&PolygonMesh, &CheckReport),
        origin: [f64; 3],
        options: &EntryOptions,
    ) -> Self {
        let is_whole = report.mesh.faces().face_count() <= options.max_faces;
        let (mesh, shape) = if is_whole {
            (MeshData::whole(stored, report, origin), None)
        } else {
            let near = faces_near(report, options.max_faces);
            (
                MeshData::part(stored, report, &near, origin),
                Some(thinned(&report.mesh, options.max_faces, origin)),
            )
        };
        State {
            mesh,
            shape,
            marks: Marks::of(report),
            loops: LoopData::of(report, stored.counts().vertices),
            pictures: pictures(&report.mesh),
        }
    }
}
