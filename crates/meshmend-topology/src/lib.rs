//! What a polygon mesh is, told from its connectivity alone: exact answers for any mesh, manifold or not.
//!
//! Each file asks one question, through the [`Connectivity`](meshmend_core::Connectivity) trait, so that every
//! kernel gives the same answer. [`topology`] asks them all and returns a [`TopologyReport`] of plain facts.
//!
//! ```
//! use meshmend_core::{Build, EdgeUse, FaceTable, PolygonMesh, VertexId};
//! use meshmend_topology::topology;
//!
//! let tetrahedron = [0, 1, 2, 0, 3, 1, 1, 3, 2, 2, 3, 0].map(VertexId).to_vec();
//! let mesh = PolygonMesh::new(vec![[0.0; 3]; 4], FaceTable::triangles(4, tetrahedron)?)?;
//! let report = topology(&EdgeUse::build(mesh.complex())?, &mesh);
//! assert_eq!(report.betti.z2, Some([1, 0, 1]));
//! assert_eq!(report.component_kinds[0].name.as_deref(), Some("sphere"));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! [`matrices`] says what can be said with less than a kernel: by the boundary matrices, or by the graph alone.
//!
//! No answer is a guess: a figure that is not defined for a mesh (the genus of something that is not a surface) is
//! absent, and the report says why.

mod defects;
mod faces;
mod homology;
mod ids;
mod loops;
pub mod matrices;
mod orientation;
mod report;
mod surfaces;

#[cfg(test)]
mod shapes;

pub use defects::DefectList;
pub use faces::{
    AlikeFace, DuplicateFace, FaceShapes, Likeness, alike_faces, duplicate_faces,
    faces_with_repeated_corners, non_simple_faces, repeats,
};
pub use homology::{
    Betti, ELIMINATION_BUDGET, Effect, Incremental, Instigators, PatchEnds, PatchUse, REDUCTION_BUDGET, Step,
    TwoCycles, betti, betti_of, betti_within, incremental, incremental_within, instigators,
};
pub use ids::{ComponentId, PatchId};
pub use loops::{
    CoTree, ComponentGenerators, CutGraph, Generator, GeneratorError, GeneratorKind, GeneratorOptions,
    Generators, LoopSystem, Measure, Roots, cut_graph, generators,
};
pub use orientation::{
    DualEdge, ONE_SIDED_BUDGET, OneSidedLoop, OneSidedStrip, Orientability, Patches, Seam, Side,
    one_sided_loops, one_sided_loops_by_length, orientability, patches, seams, seams_by_length, short_seam,
};
pub use report::{
    DuplicateCounts, Figures, NonManifoldVertexCounts, Reason, TopologyReport, Undefined, Witness, topology,
    topology_watched,
};
pub use surfaces::{
    BoundaryLoops, ComponentFacts, ComponentKind, Components, GluingWord, Letter, Permutations, Surface,
    boundary_loops, component_facts, component_kinds, components, permutations, surface_name,
};
