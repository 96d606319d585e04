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
//! What that makes of the file:
//!
#![doc = include_str!("../pictures/broken-before-after.svg")]
//!
//! # By task
//!
//! **I have arrays.** Points and triangles go in and come out as they are in any other program.
//!
//! ```
//! use meshmend::PolygonMesh;
//!
//! let points: [[f32; 3]; 5] = [[0., 0., 0.], [1., 0., 0.], [0., 1., 0.], [1., 1., 0.], [1., 0., 0.]];
//! let mesh = PolygonMesh::from_triangles(&points, &[[0, 1, 2], [4, 3, 2]])?;
//! let repaired = meshmend::repair(&mesh)?.mesh;
//! assert_eq!(repaired.triangles(), Some(vec![[0, 1, 2], [1, 3, 2]]));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! [`PolygonMesh::from_polygons`] takes faces of any size, and [`PolygonMesh::to_arrays`] gives them.
//!
//! **I want to know where it is broken.** A defect says at what element it is, and so in which faces.
//!
//! ```
//! use meshmend::{CheckOptions, PolygonMesh, Severity, check};
//!
//! // Three triangles on one edge.
//! let points = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.5, 1.0, 0.0], [0.5, -1.0, 0.0], [0.5, 0.0, 1.0]];
//! let mesh = PolygonMesh::from_triangles(&points, &[[0, 1, 2], [1, 0, 3], [0, 1, 4]])?;
//! let report = check(&mesh, &CheckOptions::default())?;
//! let wrong = report.listed_kinds().filter(|kind| kind.severity() == Severity::Defect);
//! let said: Vec<String> =
//!     wrong.flat_map(|kind| report.defects_of_kind(kind)).map(|defect| defect.to_string()).collect();
//! let expected =
//!     ["e0 v0-v1 has 3 sides", "v0 is on a non-manifold edge", "v1 is on a non-manifold edge"];
//! assert_eq!(said, expected);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! A picture shows it as well: the command is `meshmend render`. This is the strip of faces by which a Möbius band is named.
//!
#![doc = include_str!("../pictures/moebius-witness.svg")]
//!
//! **I want my UVs back.** Welding moves attributes that differ from the vertices to the corners, and never averages them. They
//! are found by their name, wherever they are.
//!
//! ```
//! use meshmend::mesh::{Carry, Domain, Layer, Values};
//! use meshmend::PolygonMesh;
//!
//! // Two triangles that share an edge by position only, as exporters write a seam of a texture.
//! let points = [[0., 0., 0.], [1., 0., 0.], [0., 1., 0.], [1., 1., 0.], [1., 0., 0.], [0., 1., 0.]];
//! let numbers = vec![0.0, 0.0, 0.5, 0.0, 0.0, 0.5, 1.0, 1.0, 0.6, 0.1, 0.1, 0.6];
//! let uv = Layer::direct("texcoord", Domain::Vertex, 2, Carry::Interpolate, Values::F32(numbers));
//! let mesh = PolygonMesh::from_triangles(&points, &[[0, 1, 2], [4, 3, 5]])?.with_layers(vec![uv])?;
//!
//! let repaired = meshmend::repair(&mesh)?.mesh;
//! assert_eq!(repaired.counts().vertices, 4);
//! let uv = repaired.layer_named("texcoord").ok_or("the layer is there")?;
//! let of_corner: Vec<Option<f64>> =
//!     uv.corner_values(repaired.faces()).map(|value| uv.values().number(2 * value?)).collect();
//! let expected = [0.0_f32, 0.5, 0.0, 0.6, 1.0, 0.1].map(|u| Some(f64::from(u)));
//! assert_eq!(of_corner, expected);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! **I write a kernel of my own.** Whatever implements [`Connectivity`](mesh::Connectivity) takes every question of
//! [`topology`]; CONTRIBUTING shows a whole one.
//!
//! **I want to edit a mesh.** An [`Editor`](edit::Editor) flips, splits, collapses, pokes, cuts and zips; each call is refused with
//! every reason or can be undone, and attributes go along. `crates/meshmend-edit/examples` subdivide meshes with it.
//!
//! ```
//! use meshmend::PolygonMesh;
//! use meshmend::edit::Editor;
//!
//! let square = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [1.0, 1.0, 0.0], [0.0, 1.0, 0.0]];
//! let mut editor = Editor::new(&PolygonMesh::from_triangles(&square, &[[0, 1, 2], [0, 2, 3]])?)?;
//! let edges: Vec<_> = editor.edges().collect();
//! let done: Vec<_> = edges.into_iter().filter_map(|edge| editor.flip(edge).ok()).collect();
//! assert_eq!(done.len(), 1, "the edges of the boundary refuse");
//! editor.apply(&done[0].undo)?;
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! **I write a pass, or a kind of defect, of my own.** Both are one file and one row, see CONTRIBUTING; [`Pipeline::then`] takes
//! the pass, and [`CheckOptions::rules`] the kind of defect.
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
//! use meshmend::{Pipeline, Plan};
//!
//! let outward = Orient { side: Side::Outward, ..Orient::default() };
//! let pipeline = Pipeline::default().with(outward);
//! let plan = Plan::from_toml("[orient]\nside = 'outward'")?;
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
//! let options = CheckOptions::default().with_rules(Rules::with(&[&BELOW])?);
//! let report = check(&mesh, &options)?;
//! let defect = report.defects_of_kind(DefectKind::Own(&BELOW)).next();
//! assert_eq!(defect.map(|defect| defect.to_string()).as_deref(), Some("v2 is below the ground"));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! **Reports** for other programs are made by [`report`]: the same JSON that the command line prints. Whole files, with their parts
//! and for an output of any format, are repaired by [`files`], as the command line does.
//!
//! The parts are whole crates of their own, here under [`mesh`], [`kernels`], [`topology`], [`geometry`], [`spatial`], [`passes`],
//! [`cutting`], [`edit`], [`formats`] and [`shapes`]; [`matrices`] is a part of [`topology`]. What the main jobs need is also here at
//! the top. With the feature `flatten` there is `unfold`, which lays a mesh out in the plane.

mod by_name;
mod check;
mod check_options;
mod external;
pub mod files;
mod gate;
mod geometry_questions;
mod loops;
pub mod maps;
mod matrix_questions;
mod mend;
pub mod report;
mod structures;
#[cfg(feature = "flatten")]
mod unfold;
mod view;
pub mod words;

pub use meshmend_core as mesh;
pub use meshmend_cut as cutting;
pub use meshmend_edit as edit;
#[cfg(feature = "flatten")]
pub use meshmend_flatten as flatten;
pub use meshmend_geometry as geometry;
pub use meshmend_io as formats;
pub use meshmend_kernels as kernels;
pub use meshmend_repair as passes;
pub use meshmend_shapes as shapes;
pub use meshmend_spatial as spatial;
pub use meshmend_topology as topology;
pub use meshmend_topology::matrices;

pub use by_name::{NamedReport, check_by_name};
pub use check::{CheckReport, KernelVerdict, StoredCounts, check, check_in};
pub use check_options::CheckOptions;
pub use external::{ExternalReport, check_external};
pub use gate::{Criterion, Failing, Gate, UnknownCriterion};
pub use geometry_questions::{
    GeometryChange, GeometryChanges, GeometryMarks, GeometryOptions, GeometryReport, Question, Questions,
};
pub use loops::{CutOptions, CutReport, LoopError, LoopOptions, LoopReport, PathOptions, cut, loops};
pub use matrix_questions::{MatrixAnswers, MatrixError, MatrixQuestions, Neighbourhood};
pub use mend::repair;
pub use meshmend_core::{
    CornerId, Defect, DefectKind, EdgeId, Element, FaceId, FaceTable, FaceTableBuilder, FlippedNormals, Id,
    PolygonMesh, Provenance, Refusal, Rule, Rules, Severity, VertexId,
};
pub use meshmend_external::{ExternalError, ExternalOptions};
pub use meshmend_io::{
    Encoding, Format, Loss, Note, ReadError, ReadFile, ReadOptions, Seams, WriteError, WriteOptions, encode,
    read, read_bytes, write,
};
pub use meshmend_kernels::{KernelKind, KernelTask};
pub use meshmend_repair::{AnyPass, Distance, Pass, PassError, PassKind, Pipeline, Plan, Repaired, Session};
pub use meshmend_topology::TopologyReport;
pub use structures::{
    AnyKernel, AnyView, KernelCost, KernelNameError, KernelQuestion, Kernels, LINEAR_LIMIT, Rung,
};
#[cfg(feature = "flatten")]
pub use unfold::{UnfoldError, UnfoldOptions, Unfolded, unfold};
pub use view::View;
