//! The documents of closed paths, and of a cut along them.

use meshmend_core::{PolygonMesh, VertexId};
use meshmend_cut::{CutAlong, CutSeam, Piece};
use meshmend_io::{Loss, Note, ReadFile};
use meshmend_repair::Distance;
use meshmend_topology::{
    ComponentGenerators, Generator, GeneratorKind, Generators, GluingWord, Measure, surface_name,
};
use serde::Serialize;

use super::{BeforeAndAfter, Listing, MOST_POSITIONS, PlacedDefect, SCHEMA};
use crate::{CutReport, LoopReport, StoredCounts};

/// How many vertices the paths of a document have together at most. Those of a mesh can have as many as the square of
/// its vertices, which few memories hold.
pub const MOST_PATH_VERTICES: usize = 1 << 24;

/// The closed paths of a mesh's surfaces, with the list of components cut to a limit.
#[derive(Clone, Debug, Serialize)]
pub struct LoopsDocument {
    /// The number of this form.
    pub schema: u32,
    /// The file that the mesh is from, if it is from one.
    pub file: Option<String>,
    /// Which form of which format the file has, such as `ply-le`.
    pub format: Option<&'static str>,
    /// `indexed` or `welded`.
    pub view: &'static str,
    /// The distance of a welded view.
    pub weld: Option<Distance>,
    /// The first components, by lowest vertex.
    pub components: Vec<ComponentLoops>,
    /// How many components there are in all.
    pub components_total: u64,
    /// How many paths all components have.
    pub loops_total: u64,
    /// What the reader had to say about the file.
    pub notes: Vec<Note>,
}

/// The closed paths of one component.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct ComponentLoops {
    /// What the surface is called; absent for a component that is not a surface.
    pub name: Option<String>,
    /// Why a component that is not a surface has no paths: its first edge or vertex that a surface can't have.
    pub obstacle: Option<PlacedDefect>,
    /// Where the shortest paths begin.
    pub root: Option<VertexId>,
    /// In what lengths are measured.
    pub measure: Option<Measure>,
    /// How long all handles' or cross-caps' paths are together, each taken from the root and back to it.
    pub system_length: Option<f64>,
    /// The paths.
    pub loops: Vec<LoopDocument>,
}

/// A closed path.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct LoopDocument {
    /// What it goes round.
    pub kind: GeneratorKind,
    /// How long it is.
    pub length: f64,
    /// Whether it has two sides.
    pub two_sided: bool,
    /// How many vertices it has.
    pub vertex_count: usize,
    /// Its vertices, each joined to the next and the last to the first; absent where the paths before have
    /// [`MOST_PATH_VERTICES`] together.
    pub vertices: Option<Vec<VertexId>>,
}

/// What a cut did, with every list cut to a limit.
#[derive(Clone, Debug, Serialize)]
pub struct CutDocument {
    /// The number of this form.
    pub schema: u32,
    /// The file that was read, if one was.
    pub file: Option<String>,
    /// The file that was written, if one was.
    pub output: Option<String>,
    /// `indexed` or `welded`.
    pub view: &'static str,
    /// The distance of a welded view.
    pub weld: Option<Distance>,
    /// Along what was cut.
    pub along: CutAlong,
    /// What there was before, in that view, and what there is after.
    pub stored: BeforeAndAfter,
    /// The components.
    pub components: Listing<CutComponent>,
    /// The edges that were opened.
    pub seams: Listing<SeamDocument>,
    /// What the written format can't carry.
    pub losses: Vec<Loss>,
    /// What the reader had to say about the file.
    pub notes: Vec<Note>,
}

/// A component before and after a cut.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct CutComponent {
    /// What the surface was called.
    pub name: String,
    /// What it is called now.
    pub after: String,
    /// How its rim is glued to itself; absent if it is not a disc.
    pub word: Option<GluingWord>,
    /// What that word makes of a disc.
    pub glued: Option<String>,
}

/// An edge that was opened.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct SeamDocument {
    /// Its ends before.
    pub edge: [VertexId; 2],
    /// Its ends after, in the same order, along each of its sides.
    pub sides: [[VertexId; 2]; 2],
}

impl LoopsDocument {
    /// The document of a report, with at most `limit` components.
    pub fn new(report: &LoopReport, limit: usize) -> Self {
        let all = report.generators.components();
        let mut room = MOST_PATH_VERTICES;
        let shown = all.iter().take(limit);
        LoopsDocument {
            schema: SCHEMA,
            file: None,
            format: None,
            view: report.view.name(),
            weld: report.view.distance(),
            components: shown.map(|c| ComponentLoops::new(report, c, &mut room)).collect(),
            components_total: all.len() as u64,
            loops_total: all.iter().map(|component| component.generators.len() as u64).sum(),
            notes: Vec::new(),
        }
    }

    /// The document with what is known of the file that the mesh was read from.
    pub fn of_file(self, name: String, file: &ReadFile) -> Self {
        LoopsDocument { file: Some(name), format: Some(file.variant), notes: file.notes.clone(), ..self }
    }
}

impl ComponentLoops {
    fn new(report: &LoopReport, component: &ComponentGenerators, room: &mut usize) -> Self {
        let (system, generators) = (component.system, &report.generators);
        let placed = |defect: &_| PlacedDefect::new(Clone::clone(defect), &report.mesh, MOST_POSITIONS);
        ComponentLoops {
            name: system.map(|system| surface_name(system.surface)),
            obstacle: component.obstacle.as_ref().map(placed),
            root: system.map(|system| system.root),
            measure: system.map(|system| system.measure),
            system_length: system.map(|system| system.length),
            loops: component.generators.iter().map(|one| LoopDocument::new(generators, one, room)).collect(),
        }
    }
}

impl LoopDocument {
    fn new(generators: &Generators, generator: &Generator, room: &mut usize) -> Self {
        let left = room.checked_sub(generator.vertex_count);
        *room = left.unwrap_or(0);
        LoopDocument {
            kind: generator.kind,
            length: generator.length,
            two_sided: generator.is_two_sided,
            vertex_count: generator.vertex_count,
            vertices: left.map(|_| generators.vertices(generator)),
        }
    }
}

impl CutDocument {
    /// The document of a report, with at most `limit` items in each list.
    pub fn new(report: &CutReport, along: CutAlong, limit: usize) -> Self {
        let counts = |mesh: &PolygonMesh| StoredCounts::of(mesh);
        CutDocument {
            schema: SCHEMA,
            file: None,
            output: None,
            view: report.view.name(),
            weld: report.view.distance(),
            along,
            stored: BeforeAndAfter { before: counts(&report.before), after: counts(&report.discs.mesh) },
            components: Listing::cut(report.discs.pieces.iter().map(CutComponent::new), limit),
            seams: Listing::cut(report.discs.seams.iter().map(SeamDocument::new), limit),
            losses: Vec::new(),
            notes: Vec::new(),
        }
    }
}

impl CutComponent {
    fn new(piece: &Piece) -> Self {
        let glued = piece.word.as_ref().and_then(GluingWord::surface);
        CutComponent {
            name: surface_name(piece.before),
            after: surface_name(piece.after),
            word: piece.word.clone(),
            glued: glued.map(surface_name),
        }
    }
}

impl SeamDocument {
    fn new(seam: &CutSeam) -> Self {
        SeamDocument { edge: seam.ends, sides: seam.side_ends }
    }
}

#[cfg(test)]
mod tests {
    use meshmend_core::{FaceTable, FaceTableBuilder};
    use serde_json::{Value, json};

    use super::*;
    use crate::{CutOptions, LoopOptions, PathOptions, cut, loops};

    /// The torus with seven vertices, a bow tie, and a triangle.
    fn mesh() -> PolygonMesh {
        let torus = (0..7).flat_map(|i| [[i, (i + 1) % 7, (i + 3) % 7], [i, (i + 3) % 7, (i + 2) % 7]]);
        let mut builder = FaceTableBuilder::default();
        for face in torus.chain([[7, 8, 9], [9, 10, 11], [12, 13, 14]]) {
            builder.push_face(face.map(VertexId));
        }
        let positions = (0..15).map(|i| [f64::from(i), f64::from(i * i), 0.5]).collect();
        PolygonMesh::new(positions, builder.build(15).unwrap()).unwrap()
    }

    fn value(document: &impl Serialize) -> Value {
        serde_json::from_str(&crate::report::json(document).unwrap()).unwrap()
    }

    #[test]
    fn each_component_has_its_loops_or_the_reason() {
        let options = LoopOptions {
            paths: PathOptions { measure: Measure::Hops, ..PathOptions::default() },
            ..LoopOptions::default()
        };
        let report = loops(&mesh(), &options).unwrap();
        let document = value(&LoopsDocument::new(&report, 10));
        let [torus, bow_tie, disc] = [0, 1, 2].map(|place| &document["components"][place]);
        assert_eq!((&torus["name"], &disc["name"]), (&json!("torus"), &json!("disc")));
        assert_eq!((torus["loops"].as_array().unwrap().len(), &disc["loops"]), (2, &json!([])));
        assert_eq!((&torus["root"], &torus["measure"]), (&json!(0), &json!("hops")));
        let path = &torus["loops"][0];
        assert_eq!(
            (&path["kind"], &path["two_sided"], &path["length"]),
            (&json!("handle"), &json!(true), &json!(3.0))
        );
        assert_eq!((path["vertices"].as_array().unwrap().len(), &path["vertex_count"]), (3, &json!(3)));
        assert_eq!((&bow_tie["name"], &bow_tie["loops"]), (&Value::Null, &json!([])));
        assert_eq!(
            (&bow_tie["obstacle"]["kind"], &bow_tie["obstacle"]["vertex"]),
            (&json!("pinched-vertex"), &json!(9))
        );
        let document = value(&LoopsDocument::new(&report, 1));
        assert_eq!(document["components"].as_array().unwrap().len(), 1);
        assert_eq!((&document["components_total"], &document["loops_total"]), (&json!(3), &json!(2)));
    }

    #[test]
    fn paths_that_fill_the_room_are_not_spelt_out() {
        let report = loops(&mesh(), &LoopOptions::default()).unwrap();
        let generators = &report.generators.components()[0].generators;
        let mut room = generators[0].vertex_count;
        let shown = [0, 1].map(|i| LoopDocument::new(&report.generators, &generators[i], &mut room));
        assert_eq!(shown.each_ref().map(|path| path.vertices.is_some()), [true, false]);
        assert_eq!((shown[1].vertex_count, room), (generators[1].vertex_count, 0));
    }

    #[test]
    fn a_cut_says_what_was_glued_to_what() {
        let refused = cut(&mesh(), &CutOptions::default()).unwrap_err();
        assert_eq!(refused.to_string(), "only a surface can be cut: v9 joins 2 umbrellas, all open");
        let faces = [0, 1, 2, 0, 3, 1, 1, 3, 2, 2, 3, 0].map(VertexId).to_vec();
        let sphere = PolygonMesh::new(vec![[0.0; 3]; 4], FaceTable::triangles(4, faces).unwrap()).unwrap();
        let report = cut(&sphere, &CutOptions::default()).unwrap();
        let document = value(&CutDocument::new(&report, CutAlong::CutGraph, 1));
        assert_eq!((&document["along"], &document["seams"]["count"]), (&json!("cut-graph"), &json!(2)));
        assert_eq!(document["seams"]["items"], json!([{ "edge": [0, 1], "sides": [[0, 1], [4, 1]] }]));
        let component = json!({ "name": "sphere", "after": "disc", "word": "a a⁻¹", "glued": "sphere" });
        assert_eq!(document["components"], json!({ "count": 1, "items": [component] }));
        assert_eq!(document["stored"]["after"]["vertices"], 5);
    }
}
