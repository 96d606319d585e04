//! The vocabulary that every other crate of meshmend speaks.
//!
//! Five ideas carry the library, and each has its home here:
//!
//! 1. **The mesh is an immutable value; connectivity is an index over it.** [`FaceTable`] holds any polygon
//!    soup, [`PolygonMesh`] adds positions, loose elements and attributes, and a *kernel* is a disposable index
//!    over the mesh's [`Complex`].
//! 2. **A corner is a half-edge.** Corner `c` stands at one vertex and owns the *side* that runs to the next
//!    corner's vertex. Faces, edges and vertices are three ways of grouping corners: their *stars*
//!    ([`Connectivity`]).
//! 3. **Refusal is computed from capabilities.** A kernel declares what it holds ([`Capabilities`]); shared code
//!    lists every [`Defect`] outside that ([`admission`]); only then is the kernel assembled, and that can't fail.
//! 4. **One vocabulary of defects.** Why a kernel refuses, what a check finds and what a pass mends are all
//!    [`Defect`]s: a kind, the [`Element`] where it is, and a count. All that is said of a kind is its [`Rule`].
//! 5. **Provenance is the record of change.** A pass says for each new face and corner which old one it came
//!    from ([`Provenance`]); everything else is derived, and attributes ride on it ([`Draft`]).

mod admission;
mod anchors;
mod attributes;
mod capabilities;
mod classes;
mod column;
mod complex;
mod connectivity;
mod cycles;
mod defects;
mod differences;
mod draft;
mod edge_table;
mod edge_use;
mod face_index;
mod face_table;
mod grouping;
mod ids;
mod mesh;
mod pooling;
mod printable;
mod provenance;
mod render_vertices;
mod role;
mod stars;
mod values;
mod vertex_corners;
mod words;

pub use admission::{Refusal, admission};
pub use attributes::{Carry, Domain, Layer, NO_VALUE};
pub use capabilities::Capabilities;
pub use classes::{Classes, Joined, SidedClasses};
pub use column::Column;
pub use complex::Complex;
pub use connectivity::{Connectivity, ManifoldConnectivity};
pub use cycles::{canonical_rotation, distinct_count};
pub use defects::{
    Defect, DefectKind, Defects, Detail, Element, Found, Listed, Rule, RuleError, Rules, Severity, Strip,
    Unjudged,
};
pub use differences::{Aspect, Differences};
pub use draft::{Blend, Draft, DraftError, Loose, VertexDraft};
pub use edge_table::{EdgeSide, EdgeTable};
pub use edge_use::EdgeUse;
pub use face_index::FaceIndex;
pub use face_table::{FaceTable, FaceTableBuilder, FaceTableError, MAX_CORNERS};
pub use ids::{CornerId, EdgeId, FaceId, Id, VertexId};
pub use mesh::{MeshError, Metadata, PolygonMesh};
pub use printable::printable;
pub use provenance::{Counts, Provenance, Sources};
pub use role::{FlippedNormals, Role, turned_normals};
pub use stars::{
    EdgeClass, Umbrellas, VertexClass, edge_class, irregular_vertices, is_inconsistent, is_manifold,
    umbrellas, vertex_classes,
};
pub use values::Values;
pub use words::counted;
