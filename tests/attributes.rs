//! What a mesh carries beside its shape goes through repair and conversion: each corner keeps its texture coordinate
//! and each face its material, and what a format can't carry is named.

use std::collections::BTreeSet;

use meshmend_core::{CornerId, Domain, FaceId, Id, Layer, PolygonMesh, Values};
use meshmend_io::{Encoding, Format, Loss, LossKind, ReadOptions, WriteOptions, encode, read_bytes};
use meshmend_repair::{PassKind, Pipeline, Repaired};
use meshmend_tests::corpus::{Entry, corpus};
use meshmend_tests::each::assert_each;

/// Two tetrahedra that share an edge and have to be split there, one of them with a vertex stored twice that has to be
/// welded; corners have texture coordinates and normals, faces an object, groups, a material and a smoothing group.
const TWO_TETRAHEDRA: &str = "\
mtllib paint.mtl
v 0 0 0
v 0 0 1
v 1 0 0
v 1 1 0
v 1 1 0
v -1 0 0
v -1 -1 0
vt 0 0
vt 0 1
vt 1 0
vt 1 1
vt 0.5 0.25
vn 0 0 1
vn 0 1 0
o first
g lower
usemtl red
s 1
f 1/1/1 2/2/1 3/3/2
f 2/2/2 1/4/1 4/5/1
usemtl green
f 1/1/1 3/2/1 5/4/2
s off
f 2/5/2 4/3/1 3/1/1
o second
g upper front
usemtl blue
f 1/5/1 6/2/1 2/3/2
f 1/3/1 2/4/1 7/1/2
f 1/2/1 7/3/1 6/4/1
usemtl red
f 2/1/1 6/2/1 7/5/2
";

fn read(text: &[u8], name: &str) -> PolygonMesh {
    read_bytes(text, name, &ReadOptions::default()).unwrap().mesh
}

fn written(mesh: &PolygonMesh, format: Format, encoding: Encoding) -> (Vec<u8>, Vec<Loss>) {
    let mut bytes = Vec::new();
    let losses = encode(mesh, &WriteOptions::of(format).with_encoding(encoding), &mut bytes).unwrap();
    (bytes, losses)
}

/// The mesh as it is read again from a file of a format; welded where the format has no shared vertices.
fn converted(mesh: &PolygonMesh, format: Format, encoding: Encoding) -> (PolygonMesh, Vec<Loss>) {
    let (bytes, losses) = written(mesh, format, encoding);
    let again = read(&bytes, &format!("converted.{}", format.extensions()[0]));
    match format {
        Format::Stl => (Pipeline::new([PassKind::Weld.with_defaults()]).run(&again).unwrap().mesh, losses),
        _ => (again, losses),
    }
}

/// One value of a layer, as text that differs where a bit does.
fn value(layer: &Layer, element: usize) -> Option<String> {
    let at = layer.value_of(element)? * layer.width();
    Some(entries(layer.values(), at, layer.width()))
}

fn entries(values: &Values, at: usize, width: usize) -> String {
    let range = at..at + width;
    match values {
        Values::I8(v) => format!("{:?}", &v[range]),
        Values::U8(v) => format!("{:?}", &v[range]),
        Values::I16(v) => format!("{:?}", &v[range]),
        Values::U16(v) => format!("{:?}", &v[range]),
        Values::I32(v) => format!("{:?}", &v[range]),
        Values::U32(v) => format!("{:?}", &v[range]),
        // In double precision, as a text keeps the number and not its type.
        Values::F32(v) => format!("{:?}", v[range].iter().map(|&x| f64::from(x)).collect::<Vec<_>>()),
        Values::F64(v) => format!("{:?}", &v[range]),
        Values::Text(v) => {
            format!("{:?}", v[range].iter().map(|t| String::from_utf8_lossy(t)).collect::<Vec<_>>())
        }
        Values::Lists { starts, items } => {
            let list = |i: usize| (starts[i] as usize, (starts[i + 1] - starts[i]) as usize);
            range.map(list).map(|(start, length)| entries(items, start, length)).collect()
        }
    }
}

/// What a corner has in a layer that is on the corners, or on the vertices and seen from the corner.
fn corner_value(mesh: &PolygonMesh, layer: &str, corner: CornerId) -> Option<String> {
    match mesh.layer(layer, Domain::Corner) {
        Some(layer) => value(layer, corner.index()),
        None => value(mesh.layer(layer, Domain::Vertex)?, mesh.faces().corner_vertex(corner).index()),
    }
}

fn face_value(mesh: &PolygonMesh, layer: &str, face: FaceId) -> Option<String> {
    value(mesh.layer(layer, Domain::Face)?, face.index())
}

/// The names of the layers that corners have values in, and of those that faces have.
fn layer_names(mesh: &PolygonMesh) -> [BTreeSet<String>; 2] {
    let names = |of_faces: bool| {
        let layers = mesh.layers().iter().filter(|layer| (layer.domain() == Domain::Face) == of_faces);
        layers.map(|layer| layer.name().to_owned()).collect()
    };
    [names(false), names(true)]
}

/// The first corner or face of a repaired mesh that has another value than the one that it was as stored.
fn first_changed_value(stored: &PolygonMesh, repaired: &Repaired, result: &PolygonMesh) -> Option<String> {
    let [of_corners, of_faces] = layer_names(stored);
    for name in &of_corners {
        let differs = |&(new, old): &(CornerId, Option<CornerId>)| {
            old.is_some_and(|old| corner_value(result, name, new) != corner_value(stored, name, old))
        };
        if let Some((new, old)) = repaired.provenance.corners.iter().find(differs) {
            let [now, before] = [corner_value(result, name, new), corner_value(stored, name, old?)];
            return Some(format!("`{name}` of {new} is {now:?}, was {before:?}"));
        }
    }
    for name in &of_faces {
        let differs = |&(new, old): &(FaceId, Option<FaceId>)| {
            old.is_some_and(|old| face_value(result, name, new) != face_value(stored, name, old))
        };
        if let Some((new, old)) = repaired.provenance.faces.iter().find(differs) {
            let [now, before] = [face_value(result, name, new), face_value(stored, name, old?)];
            return Some(format!("`{name}` of {new} is {now:?}, was {before:?}"));
        }
    }
    None
}

/// Each face as its corners' positions and values in order from the least, with the values of the face; sorted.
///
/// It says what a mesh looks like, and nothing of how it is stored.
fn appearance(mesh: &PolygonMesh) -> Vec<String> {
    let [of_corners, of_faces] = layer_names(mesh);
    let corner = |corner: CornerId| {
        let values: Vec<_> = of_corners.iter().map(|name| corner_value(mesh, name, corner)).collect();
        format!("{:?} {values:?}", mesh.position(mesh.faces().corner_vertex(corner)))
    };
    let face = |face: FaceId| {
        let corners: Vec<String> = mesh.faces().face_corners(face).map(corner).collect();
        let least = (0..corners.len()).min_by_key(|&i| &corners[i]).unwrap_or(0);
        let values: Vec<_> = of_faces.iter().map(|name| face_value(mesh, name, face)).collect();
        format!("{:?} {values:?}", [&corners[least..], &corners[..least]].concat())
    };
    let mut faces: Vec<String> = mesh.faces().faces().map(face).collect();
    faces.sort();
    faces
}

#[test]
fn welding_and_splitting_keep_every_texture_coordinate_and_material() {
    let stored = read(TWO_TETRAHEDRA.as_bytes(), "two.obj");
    let repaired = Pipeline::default().run(&stored).unwrap();
    let changed: Vec<PassKind> =
        repaired.passes.iter().filter(|pass| pass.is_changed).map(|pass| pass.pass).collect();
    assert_eq!(changed, [PassKind::Weld, PassKind::Split]);
    assert_eq!(repaired.mesh.counts().vertices, 8);
    assert_eq!(appearance(&repaired.mesh), appearance(&stored));
    let (again, losses) = converted(&repaired.mesh, Format::Obj, Encoding::Ascii);
    assert_eq!(losses, []);
    assert_eq!(appearance(&again), appearance(&stored));
    assert_eq!(again.metadata(), stored.metadata());
}

#[test]
fn flipped_faces_keep_their_values_corner_by_corner() {
    let turned = TWO_TETRAHEDRA.replace("f 1/1/1 2/2/1 3/3/2", "f 1/1/1 3/3/2 2/2/1");
    let [stored, straight] = [&turned[..], TWO_TETRAHEDRA].map(|text| read(text.as_bytes(), "two.obj"));
    let repaired = Pipeline::default().run(&stored).unwrap();
    assert_eq!(repaired.provenance.flipped.len(), 1);
    assert_eq!(appearance(&repaired.mesh), appearance(&straight));
}

/// A cube's face of three strips with properties of every kind, two of its vertices stored twice.
const RICH_PLY: &str = "\
ply
format ascii 1.0
comment made by hand
element vertex 7
property double x
property double y
property double z
property uchar red
property uchar green
property uchar blue
property float quality
property short flags
element face 3
property list uchar int vertex_indices
property uchar red
property uchar green
property uchar blue
property list uchar float weights
property int region
end_header
0 0 0 255 0 0 0.5 1
1 0 0 0 255 0 0.25 -2
1 1 0 0 0 255 0.125 3
0 1 0 9 9 9 1e-9 4
1 0 0 0 255 0 0.25 -2
1 1 0 77 0 255 0.125 3
2 0 0 1 2 3 7 5
3 0 1 2 10 20 30 2 0.5 0.75 -1
3 0 2 3 40 50 60 0 70000
3 4 6 5 7 8 9 1 3 5
";

#[test]
fn custom_properties_and_colours_of_a_ply_file_go_through_a_repair() {
    let stored = read(RICH_PLY.as_bytes(), "rich.ply");
    let repaired = Pipeline::default().run(&stored).unwrap();
    assert_eq!(repaired.mesh.counts().vertices, 5, "the strips are stitched");
    assert_eq!(appearance(&repaired.mesh), appearance(&stored));
    let home =
        |name: &str| repaired.mesh.layers().iter().find(|layer| layer.name() == name).unwrap().domain();
    assert_eq!(home("color"), Domain::Corner, "the two vertices that are joined have different colours");
    assert_eq!(home("quality"), Domain::Vertex, "they have the same quality");
    for &encoding in Format::Ply.encodings() {
        let (again, losses) = converted(&repaired.mesh, Format::Ply, encoding);
        assert_eq!(losses, [], "{encoding}");
        assert_eq!(appearance(&again), appearance(&stored), "{encoding}");
    }
}

fn readable(entries: &[Entry]) -> Vec<(&Entry, PolygonMesh)> {
    let here = entries.iter().filter(|entry| entry.is_read_here());
    let mesh = |entry: &Entry| Some(meshmend_io::read(&entry.path, &ReadOptions::default()).ok()?.mesh);
    here.filter_map(|entry| Some((entry, mesh(entry)?))).collect()
}

#[test]
fn every_value_in_the_corpus_follows_its_corner_or_face_through_a_repair() {
    let Some(entries) = corpus() else { return };
    let mut meshes = readable(&entries);
    meshes.retain(|(_, mesh)| !mesh.layers().is_empty());
    assert!(meshes.len() > 100, "only {} files have attributes", meshes.len());
    assert_each(&meshes, |(entry, stored)| {
        let repaired = Pipeline::default().run(stored).unwrap();
        let changed = first_changed_value(stored, &repaired, &repaired.mesh);
        changed.map(|changed| format!("{}: {changed}", entry.name)).into_iter().collect()
    });
}

#[test]
fn what_comes_back_from_any_format_is_what_went_in_but_for_the_losses_named() {
    let Some(entries) = corpus() else { return };
    assert_each(&readable(&entries), |(entry, mesh)| {
        let targets =
            Format::ALL.iter().flat_map(|&format| format.encodings().iter().map(move |&e| (format, e)));
        targets
            .filter_map(|(format, encoding)| {
                let (again, losses) = converted(mesh, format, encoding);
                let unnamed = unnamed_loss(mesh, &again, &losses)?;
                Some(format!("{} as {format} {encoding}: {unnamed}, but named are {losses:?}", entry.name))
            })
            .collect()
    });
}

/// Something that is not in the second mesh as it is in the first, though no loss names it.
fn unnamed_loss(before: &PolygonMesh, after: &PolygonMesh, losses: &[Loss]) -> Option<String> {
    use LossKind::{
        LooseEdges, LoosePoints, Metadata, Names, Polygons, Precision, SharedVertices, ShortFaces,
        UnusedVertices,
    };
    let named = |kinds: &[LossKind]| losses.iter().any(|loss| kinds.contains(&loss.kind));
    let same_faces = !named(&[Polygons, ShortFaces]);
    // Points that are not finite equal nothing, and so are not shared again.
    let same_vertices = !named(&[SharedVertices, UnusedVertices, ShortFaces, Precision])
        && before.positions().iter().flatten().all(|x| x.is_finite());
    if same_vertices && before.counts().vertices != after.counts().vertices {
        return Some("the number of vertices differs".to_owned());
    }
    if same_faces && !named(&[Precision]) && corner_positions(before) != corner_positions(after) {
        return Some("the faces have other points".to_owned());
    }
    if same_faces && before.counts().faces != after.counts().faces {
        return Some("the number of faces differs".to_owned());
    }
    if before.loose_edges().len() != after.loose_edges().len() && !named(&[LooseEdges]) {
        return Some("loose edges differ".to_owned());
    }
    if before.loose_points().len() != after.loose_points().len() && !named(&[LoosePoints]) {
        return Some("loose points differ".to_owned());
    }
    let lost = before.metadata().iter().find(|statement| !after.metadata().contains(statement));
    if let Some(lost) = lost.filter(|_| !named(&[Metadata, Names])) {
        return Some(format!("the statement {lost:?} is gone"));
    }
    let of_vertices = |layer: &&Layer| layer.domain() == Domain::Vertex;
    let comparable = |layer: &&Layer| same_faces && (same_vertices || !of_vertices(layer));
    before.layers().iter().filter(comparable).find_map(|layer| unnamed_layer_loss(layer, after, losses))
}

/// The points of all corners in order, to the bit but for the payload of NaNs and the sign of 0.
fn corner_positions(mesh: &PolygonMesh) -> Vec<[u64; 3]> {
    let bits = |x: f64| if x.is_nan() { u64::MAX } else { (x + 0.0).to_bits() };
    let point = |corner: CornerId| mesh.position(mesh.faces().corner_vertex(corner)).map(bits);
    mesh.faces().corners().map(point).collect()
}

/// How a layer differs in another mesh with the same elements, unless a loss speaks of it.
fn unnamed_layer_loss(layer: &Layer, after: &PolygonMesh, losses: &[Loss]) -> Option<String> {
    let concerned = [LossKind::Layer, LossKind::AbsentValue, LossKind::Converted, LossKind::Names];
    let words = [layer.name(), if layer.name() == "color" { "colour" } else { layer.name() }];
    let speaks_of_it =
        |loss: &Loss| concerned.contains(&loss.kind) && words.iter().any(|word| loss.message.contains(word));
    if losses.iter().any(speaks_of_it) {
        return None;
    }
    let has_values = (0..layer.element_count()).any(|element| layer.value_of(element).is_some());
    // The one object of an ASCII STL file is the name of its solid.
    let is_title =
        layer.name() == "object" && after.metadata().iter().any(|statement| statement.key == "solid");
    if !has_values || is_title {
        return None;
    }
    let Some(other) = after.layer(layer.name(), layer.domain()) else {
        return Some(format!("the layer `{}` is gone", layer.name()));
    };
    let differs =
        (0..layer.element_count()).find(|&element| value(layer, element) != value(other, element))?;
    let [now, before] = [value(other, differs), value(layer, differs)];
    Some(format!("`{}` of element {differs} is {now:?}, was {before:?}", layer.name()))
}

/// What each format can't carry of a mesh that has everything, by kind and by the layers concerned.
#[test]
fn conversions_of_a_mesh_that_has_everything_name_their_losses() {
    use LossKind::{Layer, LooseEdges, LoosePoints, Metadata, SharedVertices};
    let text = format!("{TWO_TETRAHEDRA}l 1 7\np 4\n");
    let rich = read(text.as_bytes(), "rich.obj");
    let lost = |format: Format| {
        let losses = written(&rich, format, format.encodings()[0]).1;
        let kinds: BTreeSet<LossKind> = losses.iter().map(|loss| loss.kind).collect();
        let layers = rich.layers().iter().map(|layer| layer.name());
        let named = |layer: &&str| losses.iter().any(|loss| loss.message.contains(&format!("`{layer}`")));
        (Vec::from_iter(kinds), layers.filter(named).collect::<Vec<_>>())
    };
    let of_faces = ["object", "group", "material", "smoothing"];
    let all = ["texcoord", "normal", "object", "group", "material", "smoothing"];
    assert_eq!(lost(Format::Obj), (vec![], vec![]));
    assert_eq!(lost(Format::Ply), (vec![Layer, LoosePoints, Metadata], of_faces.to_vec()));
    let without_indices = vec![Layer, SharedVertices, LooseEdges, LoosePoints, Metadata];
    assert_eq!(lost(Format::Stl), (without_indices, all.to_vec()));
    assert_eq!(lost(Format::Off), (vec![Layer, LooseEdges, LoosePoints, Metadata], all.to_vec()));
}
