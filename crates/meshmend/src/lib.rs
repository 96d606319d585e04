//! Finds, explains and mends what is wrong with polygon meshes.
//!
//! # The main job
//!
//! ```
//! # let folder = std::env::temp_dir().join(format!("meshmend-tour-{}", std::process::id()));
//! # std::fs::create_dir_all(&folder)?;
//! # let (input, output) = (folder.join("broken.obj"), folder.join("mended.ply"));
//! # std::fs::write(&input, "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nf 1 2 3\nf 4 5 6\n")?;
//! use meshmend::{ReadOptions, WriteOptions, read, repair, write};
//!
//! let file = read(&input, &ReadOptions::default())?;
//! let repaired = repair(&file.mesh)?;
//! for removed in &repaired.removed_faces {
//!     println!("{} is gone: {}", removed.face, removed.reason.title());
//! }
//! let losses = write(&output, &repaired.mesh, &WriteOptions::default())?;
//! assert!(losses.is_empty());
//! # assert_eq!(repaired.mesh.counts().vertices, 4);
//! # std::fs::remove_dir_all(&folder)?;
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! # A tour
//!
//! **A mesh** is an immutable value: positions, faces of any size, loose elements and attributes.
//!
//! ```
//! use meshmend::{CheckOptions, DefectKind, FaceTable, PolygonMesh, VertexId, View, check};
//!
//! // Two tetrahedra that meet in one vertex.
//! let faces = [0, 2, 1, 0, 1, 3, 1, 2, 3, 2, 0, 3, 0, 4, 5, 0, 6, 4, 4, 6, 5, 5, 6, 0].map(VertexId);
//! let points = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1], [-1, 0, 0], [0, -1, 0], [0, 0, -1]];
//! let positions = points.iter().map(|point| point.map(f64::from)).collect();
//! let mesh = PolygonMesh::new(positions, FaceTable::triangles(7, faces.to_vec())?)?;
//!
//! // A check tells what the mesh is and where it is wrong; it never changes anything.
//! let report = check(&mesh, &CheckOptions::default())?;
//! assert_eq!(report.topology.betti.z2, Some([1, 0, 2]));
//! assert!(!report.is_sound());
//! let pinched = report.defects_of_kind(DefectKind::PinchedVertex).next();
//! assert_eq!(pinched.map(|defect| defect.to_string()).as_deref(), Some("v0 joins 2 umbrellas"));
//!
//! // A repair gives another mesh and the record of all that it did.
//! let repaired = meshmend::repair(&mesh)?;
//! assert_eq!(repaired.mesh.counts().vertices, 8);
//! assert_eq!(repaired.provenance.vertices.of(VertexId(7)), Some(VertexId(0)));
//! assert!(check(&repaired.mesh, &CheckOptions::default())?.is_sound());
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! **Policies** are fields of the passes. A [`Pipeline`] runs passes in order; a [`Plan`] says the same in a file.
//!
//! ```
//! use meshmend::passes::{Orient, Side};
//! use meshmend::{PassKind, Pipeline, Plan};
//!
//! let outward = Orient { side: Side::Outward, ..Orient::default() };
//! let pipeline = Pipeline::new([PassKind::Weld.with_defaults(), outward.into()]);
//! let plan = Plan::from_toml("passes = ['weld', 'orient']\n[orient]\nside = 'outward'")?;
//! assert_eq!(plan.pipeline(), pipeline);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! **Connectivity** is an index over a mesh, in whichever classical structure is the point: a [`KernelKind`] is
//! chosen by name, and every kernel gives the same answers, or says everything that it can't hold.
//!
//! ```
//! use meshmend::mesh::{Build, Connectivity};
//! use meshmend::kernels::HalfEdge;
//! # use meshmend::{FaceTable, PolygonMesh, VertexId};
//! # let corners = [0, 1, 2, 0, 1, 3].map(VertexId).to_vec();
//! # let mesh = PolygonMesh::new(vec![[0.0; 3]; 4], FaceTable::triangles(4, corners)?)?;
//!
//! match HalfEdge::build(mesh.complex()) {
//!     Ok(half_edges) => println!("{} edges", half_edges.edge_count()),
//!     Err(refusal) => println!("{refusal}"),
//! }
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! **Kinds of defect** are rules, and a check takes further ones: all that is said of a kind is in one place.
//!
//! ```
//! use meshmend::mesh::{Defects, Found, Id, Listed};
//! use meshmend::{CheckOptions, Defect, DefectKind, Element, PolygonMesh, Rule, Rules, Severity, VertexId, check};
//! # use meshmend::FaceTable;
//!
//! const BELOW: Rule = Rule {
//!     code: "vertex-below-ground",
//!     title: "vertices below the ground",
//!     severity: Severity::Defect,
//!     explanation: "The vertex has a negative height, so it can't be printed.",
//!     found: Found::InMesh(find),
//!     listed: Listed::Unasked,
//!     counts: None,
//!     sentence: "{at} is below the ground",
//! };
//!
//! fn find(mesh: &PolygonMesh) -> Defects<'_> {
//!     let below = mesh.positions().iter().enumerate().filter(|(_, position)| position[2] < 0.0);
//!     Box::new(below.map(|(v, _)| Defect::new(DefectKind::Own(&BELOW), Element::Vertex(VertexId::new(v)))))
//! }
//!
//! # let faces = FaceTable::triangles(3, [0, 1, 2].map(VertexId).to_vec())?;
//! # let mesh = PolygonMesh::new(vec![[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, -2.0]], faces)?;
//! let options = CheckOptions { rules: Rules::with(&[&BELOW])?, ..CheckOptions::default() };
//! let report = check(&mesh, &options)?;
//! let defect = report.defects_of_kind(DefectKind::Own(&BELOW)).next();
//! assert_eq!(defect.map(|defect| defect.to_string()).as_deref(), Some("v2 is below the ground"));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! **Reports** for other programs are made by [`report`]: the same JSON that the command line prints.
//!
//! The parts are whole crates of their own, here under [`mesh`], [`kernels`], [`topology`], [`geometry`], [`passes`],
//! [`cutting`], [`formats`] and [`shapes`]; what the main jobs need is also here at the top. With the feature `flatten`
//! there is `unfold`, which lays a mesh out in the plane.

mod check;
mod kernel_bench;
mod loops;
mod mend;
pub mod report;
#[cfg(feature = "flatten")]
mod unfold;
mod view;

pub use meshmend_core as mesh;
pub use meshmend_cut as cutting;
#[cfg(feature = "flatten")]
pub use meshmend_flatten as flatten;
pub use meshmend_geometry as geometry;
pub use meshmend_io as formats;
pub use meshmend_kernels as kernels;
pub use meshmend_repair as passes;
pub use meshmend_shapes as shapes;
pub use meshmend_topology as topology;

pub use check::{CheckOptions, CheckReport, KernelVerdict, StoredCounts, check, check_in};
pub use kernel_bench::{KernelCost, KernelQuestion};
pub use loops::{CutOptions, CutReport, LoopError, LoopOptions, LoopReport, PathOptions, cut, loops};
pub use mend::repair;
pub use meshmend_core::{
    CornerId, Defect, DefectKind, EdgeId, Element, FaceId, FaceTable, FaceTableBuilder, FlippedNormals, Id,
    PolygonMesh, Provenance, Refusal, Rule, Rules, Severity, VertexId,
};
pub use meshmend_io::{
    Encoding, Format, Loss, Note, ReadError, ReadFile, ReadOptions, Seams, WriteError, WriteOptions, encode,
    read, read_bytes, write,
};
pub use meshmend_kernels::{KernelKind, KernelTask};
pub use meshmend_repair::{AnyPass, Distance, Pass, PassError, PassKind, Pipeline, Plan, Repaired, Session};
pub use meshmend_topology::TopologyReport;
#[cfg(feature = "flatten")]
pub use unfold::{UnfoldError, UnfoldOptions, Unfolded, unfold};
pub use view::View;
