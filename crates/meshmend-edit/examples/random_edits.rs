//! How long random operators take: a hundred thousand of them on a torus of a hundred thousand triangles.
//!
//! `cargo run --release -p meshmend-edit --example random_edits`

use std::error::Error;
use std::time::Instant;

use meshmend_core::{FaceTable, PolygonMesh, VertexId};
use meshmend_edit::{Edit, Editor, HalfKey, Opening, StaleKey};

const SIDE: u32 = 224;
const OPERATORS: usize = 100_000;

fn main() -> Result<(), Box<dyn Error>> {
    let mesh = torus()?;
    let begin = Instant::now();
    let mut editor = Editor::new(&mesh)?;
    println!("{} faces, taken apart in {:.1?}", editor.face_count(), begin.elapsed());
    let mut halves: Vec<HalfKey> = editor.halves().collect();
    let (mut state, mut done, mut refused) = (1u64, 0, 0);
    let begin = Instant::now();
    while done < OPERATORS {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        let (kind, at) = (state >> 60, (state >> 24) as usize % halves.len());
        match edit(&editor, kind, halves[at]).map(|edit| editor.apply(&edit)) {
            Ok(Ok(made)) => {
                done += 1;
                for edge in made.edges {
                    halves.extend(editor.edge_halves(edge)?);
                }
            }
            Ok(Err(_)) => refused += 1,
            // Its half-edge is gone.
            Err(_) => _ = halves.swap_remove(at),
        }
    }
    println!("{done} operators, and {refused} that were refused, in {:.1?}", begin.elapsed());
    let begin = Instant::now();
    let (mesh, _) = editor.finish()?;
    println!("{} faces, put together in {:.1?}", mesh.counts().faces, begin.elapsed());
    Ok(())
}

/// One of the local operators at a half-edge.
fn edit(editor: &Editor, kind: u64, half: HalfKey) -> Result<Edit, StaleKey> {
    let (edge, vertex, next) = (editor.edge(half)?, editor.origin(half)?, editor.next(half)?);
    let (point, across) = (editor.position(vertex)?, editor.next(editor.twin(half)?)?);
    Ok(match kind {
        0..4 => Edit::Flip { edge },
        4..7 => Edit::Collapse { half, point },
        7..9 => Edit::SplitVertex { from: Opening::Edge(half), to: Opening::Edge(across), point },
        9 => Edit::SplitEdge { edge, at: 0.5 },
        10 => Edit::JoinEdges { vertex },
        11 => Edit::JoinFaces { edge },
        12 | 13 => Edit::SplitFace { from: half, to: editor.next(next)? },
        14 => Edit::RemoveVertex { vertex },
        _ => match editor.face(half)? {
            Some(face) => Edit::Poke { face, point },
            None => Edit::CloseHole { half },
        },
    })
}

fn torus() -> Result<PolygonMesh, Box<dyn Error>> {
    let vertex = |x: u32, y: u32| VertexId(x % SIDE + SIDE * (y % SIDE));
    let triangles = (0..SIDE * SIDE).flat_map(|at| {
        let (x, y) = (at % SIDE, at / SIDE);
        let [a, b, c, d] = [[x, y], [x + 1, y], [x + 1, y + 1], [x, y + 1]].map(|[x, y]| vertex(x, y));
        [a, b, c, a, c, d]
    });
    let points = (0..SIDE * SIDE).map(|at| [f64::from(at % SIDE), f64::from(at / SIDE), 0.0]);
    Ok(PolygonMesh::new(
        points.collect(),
        FaceTable::triangles((SIDE * SIDE) as usize, triangles.collect())?,
    )?)
}
