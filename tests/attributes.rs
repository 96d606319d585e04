//! What a mesh carries beside its shape goes through repair and conversion: each corner keeps its texture coordinate
//! and each face its material, and what a format can't carry is named.

use std::collections::BTreeSet;

use meshmend_core::{CornerId, Domain, FaceId, Id, Layer, Metadata, PolygonMesh, Role, Values};
use meshmend_io::{Encoding, Format, Loss, LossKind, ReadOptions, Seams, WriteOptions, encode, read_bytes};
use meshmend_repair::{PassError, PassKind, Pipeline, Repaired};
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

/// A format in one of its encodings, and how vertices are written whose attributes differ from face to face.
#[derive(Clone, Copy)]
struct Target {
    format: Format,
    encoding: Encoding,
    seams: Seams,
}

impl Target {
    fn all() -> impl Iterator<Item = Target> {
        let encodings =
            Format::ALL.iter().flat_map(|&format| format.encodings().iter().map(move |&e| (format, e)));
        encodings.flat_map(|(format, encoding)| {
            [Seams::Split, Seams::Corners].map(|seams| Target { format, encoding, seams })
        })
    }
}

fn written(mesh: &PolygonMesh, target: Target) -> (Vec<u8>, Vec<Loss>) {
    let mut bytes = Vec::new();
    let options = WriteOptions::of(target.format).with_seams(target.seams);
    let losses = encode(mesh, &options.with_encoding(target.encoding), &mut bytes).unwrap();
    (bytes, losses)
}

/// The mesh as it is read again from a file of a format; welded where the format has no shared vertices.
fn converted(mesh: &PolygonMesh, target: Target) -> (PolygonMesh, Vec<Loss>) {
    let format = target.format;
    let (bytes, losses) = written(mesh, target);
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

/// A layer with the opposite sign, if it holds normals; else as it is.
fn turned(layer: &Layer) -> Layer {
    let values = match layer.values() {
        _ if layer.role() != Role::Normal => return layer.clone(),
        Values::F32(v) => Values::F32(v.iter().map(|x| -x).collect()),
        Values::F64(v) => Values::F64(v.iter().map(|x| -x).collect()),
        Values::I8(v) => Values::I8(v.iter().map(|x| x.saturating_neg()).collect()),
        Values::I16(v) => Values::I16(v.iter().map(|x| x.saturating_neg()).collect()),
        Values::I32(v) => Values::I32(v.iter().map(|x| x.saturating_neg()).collect()),
        _ => return layer.clone(),
    };
    layer.clone().with_pool(layer.width(), values)
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

/// The first corner or face of a repaired mesh that has another value than the one that it was as stored; the normals of
/// flipped faces have the opposite sign.
fn first_changed_value(stored: &PolygonMesh, repaired: &Repaired, result: &PolygonMesh) -> Option<String> {
    let opposite = stored.clone().with_layers(stored.layers().iter().map(turned).collect()).unwrap();
    let flipped: BTreeSet<FaceId> = repaired.provenance.flipped.iter().copied().collect();
    let source = |face: FaceId| if flipped.contains(&face) { &opposite } else { stored };
    let [of_corners, of_faces] = layer_names(stored);
    for name in &of_corners {
        for (new, old) in repaired.provenance.corners.iter() {
            let Some(old) = old else { continue };
            let before = corner_value(source(result.faces().corner_face(new)), name, old);
            let now = corner_value(result, name, new);
            if now != before {
                return Some(format!("`{name}` of {new} is {now:?}, was {before:?}"));
            }
        }
    }
    for name in &of_faces {
        for (new, old) in repaired.provenance.faces.iter() {
            let Some(old) = old else { continue };
            let [now, before] = [face_value(result, name, new), face_value(source(new), name, old)];
            if now != before {
                return Some(format!("`{name}` of {new} is {now:?}, was {before:?}"));
            }
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
    let target = Target { format: Format::Obj, encoding: Encoding::Ascii, seams: Seams::Split };
    let (again, losses) = converted(&repaired.mesh, target);
    assert_eq!(losses, []);
    assert_eq!(appearance(&again), appearance(&stored));
    assert_eq!(again.metadata(), stored.metadata());
}

/// Normals turn with their faces; all else stays as it is.
#[test]
fn flipped_faces_keep_their_values_corner_by_corner() {
    let turned = TWO_TETRAHEDRA.replace("f 1/1/1 2/2/1 3/3/2", "f 1/1/1 3/3/2 2/2/1");
    let opposite = TWO_TETRAHEDRA
        .replace("vn 0 1 0\n", "vn 0 1 0\nvn -0 -0 -1\nvn -0 -1 -0\n")
        .replace("f 1/1/1 2/2/1 3/3/2", "f 1/1/3 2/2/3 3/3/4");
    let [stored, straight] = [turned, opposite].map(|text| read(text.as_bytes(), "two.obj"));
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
    for target in Target::all().filter(|target| target.format == Format::Ply) {
        let Target { encoding, seams, .. } = target;
        let (again, losses) = converted(&repaired.mesh, target);
        let losses: Vec<_> = losses.iter().map(|loss| (loss.kind, loss.count)).collect();
        let (named, vertices) = match seams {
            Seams::Corners => (vec![], 5),
            _ => (vec![(LossKind::SeamVertices, 1)], 6),
        };
        assert_eq!((losses, again.counts().vertices), (named, vertices), "{encoding} {seams:?}");
        assert_eq!(appearance(&again), appearance(&stored), "{encoding} {seams:?}");
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
        let repaired = match Pipeline::default().run(stored) {
            Ok(repaired) => repaired,
            Err(PassError::Emptied(_)) => return Vec::new(),
            Err(error) => return vec![format!("{}: {error}", entry.name)],
        };
        let changed = first_changed_value(stored, &repaired, &repaired.mesh);
        changed.map(|changed| format!("{}: {changed}", entry.name)).into_iter().collect()
    });
}

#[test]
fn what_comes_back_from_any_format_is_what_went_in_but_for_the_losses_named() {
    let Some(entries) = corpus() else { return };
    assert_each(&readable(&entries), |(entry, mesh)| {
        let wrong = |target: Target| {
            let Target { format, encoding, seams } = target;
            let (again, losses) = converted(mesh, target);
            let unnamed = unnamed_loss(mesh, &again, target, &losses)?;
            let as_what = format!("{} as {format} {encoding}, seams {seams:?}", entry.name);
            Some(format!("{as_what}: {unnamed}, but named are {losses:?}"))
        };
        Target::all().filter_map(wrong).collect()
    });
}

/// Something that is not in the second mesh as it is in the first, though no loss names it.
fn unnamed_loss(
    before: &PolygonMesh,
    after: &PolygonMesh,
    target: Target,
    losses: &[Loss],
) -> Option<String> {
    let named = |kinds: &[LossKind]| losses.iter().any(|loss| kinds.contains(&loss.kind));
    if target.seams == Seams::Corners && named(&[LossKind::SeamVertices]) {
        return Some("a vertex was split".to_owned());
    }
    let same_faces = !named(&[LossKind::Polygons, LossKind::ShortFaces]);
    let lost_shape = unnamed_loss_of_shape(before, after, losses);
    if lost_shape.is_some() {
        return lost_shape;
    }
    let lost = before.metadata().iter().find(|statement| !is_stated(statement, after, target.format));
    if let Some(lost) = lost.filter(|_| !named(&[LossKind::Metadata, LossKind::Names])) {
        return Some(format!("the statement {lost:?} is gone"));
    }
    let same_vertices = has_same_vertices(before, losses);
    let comparable = |layer: &&Layer| match layer.domain() {
        Domain::LooseEdge => !named(&[LossKind::LooseEdges]),
        Domain::LoosePoint => !named(&[LossKind::LoosePoints]),
        Domain::Vertex => same_faces && same_vertices,
        _ => same_faces,
    };
    let mut layers = before.layers().iter().filter(comparable);
    layers.find_map(|layer| unnamed_layer_loss(layer, after, losses))
}

/// Whether no loss says that vertices are others; those that are written for seams follow at the end.
fn has_same_vertices(before: &PolygonMesh, losses: &[Loss]) -> bool {
    use LossKind::{Precision, SharedVertices, ShortFaces, UnusedVertices};
    let others = [SharedVertices, UnusedVertices, ShortFaces, Precision];
    // Points that are not finite equal nothing, and so are not shared again.
    !losses.iter().any(|loss| others.contains(&loss.kind))
        && before.positions().iter().flatten().all(|x| x.is_finite())
}

/// How many vertices the losses say that there are more: `N vertices are written M times`, `with N vertices more`.
fn further_vertices(losses: &[Loss]) -> usize {
    let number = |text: &str, before: &str, after: &str| -> usize {
        let found = text.rsplit_once(after).and_then(|(rest, _)| rest.rsplit_once(before));
        found.map_or(0, |(_, number)| number.parse().unwrap())
    };
    let further = |loss: &Loss| match loss.kind {
        LossKind::SeamVertices => {
            number(&loss.message, "written ", " times") - usize::try_from(loss.count).unwrap()
        }
        LossKind::Polygons if loss.message.contains(" vertex more") => 1,
        LossKind::Polygons => number(&loss.message, "with ", " vertices more"),
        _ => 0,
    };
    losses.iter().map(further).sum()
}

fn unnamed_loss_of_shape(before: &PolygonMesh, after: &PolygonMesh, losses: &[Loss]) -> Option<String> {
    use LossKind::{LooseEdges, LoosePoints, Polygons, Precision, ShortFaces};
    let named = |kinds: &[LossKind]| losses.iter().any(|loss| kinds.contains(&loss.kind));
    let same_faces = !named(&[Polygons, ShortFaces]);
    let vertices = before.counts().vertices + further_vertices(losses);
    if has_same_vertices(before, losses) && vertices != after.counts().vertices {
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
    None
}

/// Whether a mesh has a statement. A comment beside an element stands on top where only OBJ can keep its place.
fn is_stated(statement: &Metadata, mesh: &PolygonMesh, format: Format) -> bool {
    let is_moved = |other: &Metadata| {
        statement.kind() == "comment" && other.key == "comment" && other.value == statement.value
    };
    mesh.metadata().contains(statement) || format != Format::Obj && mesh.metadata().iter().any(is_moved)
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
    let layer = &without_third_number(layer, losses);
    let has_values = (0..layer.element_count()).any(|element| layer.value_of(element).is_some());
    // The one object of an ASCII STL file is the name of its solid.
    let is_title =
        layer.name() == "object" && after.metadata().iter().any(|statement| statement.key == "solid");
    if !has_values || is_title {
        return None;
    }
    let differs = |element: usize, now: Option<String>, was: Option<String>| {
        (now != was).then(|| format!("`{}` of element {element} is {now:?}, was {was:?}", layer.name()))
    };
    if let Some(other) = after.layer(layer.name(), layer.domain()) {
        let mut elements = 0..layer.element_count();
        return elements.find_map(|e| differs(e, value(other, e), value_as_in(layer, e, other)));
    }
    if let (Domain::Corner, Some(other)) = (layer.domain(), after.layer(layer.name(), Domain::Vertex)) {
        return after.faces().corners().find_map(|corner| {
            let vertex = after.faces().corner_vertex(corner).index();
            differs(corner.index(), value(other, vertex), value_as_in(layer, corner.index(), other))
        });
    }
    if let ("texnumber", Some(other)) = (layer.name(), after.layer("material", Domain::Face)) {
        // MeshLab's numbers of textures are names of materials elsewhere.
        let named = |e: usize| Some(value(layer, e)?.replace('[', "[\"texture_").replace(']', "\"]"));
        return (0..layer.element_count()).find_map(|e| differs(e, value(other, e), named(e)));
    }
    Some(format!("the layer `{}` of {:?} is gone", layer.name(), layer.domain()))
}

/// Texture coordinates without the third number, if that is named as lost; any other layer as it is.
fn without_third_number(layer: &Layer, losses: &[Loss]) -> Layer {
    let is_named = losses
        .iter()
        .any(|loss| loss.kind == LossKind::Converted && loss.message.starts_with("the third number, "));
    match layer.values() {
        Values::F64(numbers) if is_named && layer.role() == Role::TexCoord && layer.width() == 3 => {
            let first_two = numbers.chunks_exact(3).flat_map(|value| [value[0], value[1]]);
            layer.clone().with_pool(2, Values::F64(first_two.collect()))
        }
        _ => layer.clone(),
    }
}

/// One value of a layer; a colour of fractions as bytes, if the other layer is one of bytes.
fn value_as_in(layer: &Layer, element: usize, other: &Layer) -> Option<String> {
    let (Role::Color, Values::F64(fractions), Values::U8(_)) = (layer.role(), layer.values(), other.values())
    else {
        return value(layer, element);
    };
    let at = layer.value_of(element)? * layer.width();
    let bytes = fractions[at..at + layer.width()].iter().map(|x| x * 255.0);
    // A fraction that no byte is stays one, and so differs.
    let text: Vec<String> = bytes.map(|x| format!("{x}")).collect();
    Some(format!("[{}]", text.join(", ")))
}

/// What each format can't carry of a mesh that has everything, by kind and by the layers concerned.
#[test]
fn conversions_of_a_mesh_that_has_everything_name_their_losses() {
    use LossKind::{Layer, LooseEdges, LoosePoints, Metadata, SeamVertices, SharedVertices};
    let text = format!("{TWO_TETRAHEDRA}l 1 7\np 4\n");
    let rich = read(text.as_bytes(), "rich.obj");
    let lost = |format: Format, seams: Seams| {
        let losses = written(&rich, Target { format, encoding: format.encodings()[0], seams }).1;
        let kinds: BTreeSet<LossKind> = losses.iter().map(|loss| loss.kind).collect();
        let is_named = |name: &str| losses.iter().any(|loss| loss.message.contains(name));
        let layers = rich
            .layers()
            .iter()
            .map(|layer| format!("{} attribute `{}`", layer.domain().name(), layer.name()));
        (Vec::from_iter(kinds), layers.filter(|name| is_named(name)).collect::<Vec<_>>())
    };
    let of_faces =
        ["object", "group", "material", "smoothing"].map(|name| format!("face attribute `{name}`"));
    let of_corners = ["texcoord", "normal"].map(|name| format!("corner attribute `{name}`"));
    let of_edges = ["object", "group", "material"].map(|name| format!("loose edge attribute `{name}`"));
    let all = [&of_corners[..], &of_faces].concat();
    for seams in [Seams::Split, Seams::Corners] {
        assert_eq!(lost(Format::Obj, seams), (vec![], vec![]));
        // What loose elements have is lost with them.
        let without_indices = vec![Layer, SharedVertices, LooseEdges, LoosePoints, Metadata];
        assert_eq!(lost(Format::Stl, seams), (without_indices, all.clone()));
        assert_eq!(lost(Format::Off, seams), (vec![Layer, LooseEdges, LoosePoints, Metadata], all.clone()));
    }
    let names = [&of_faces[..], &of_edges].concat();
    let kinds = vec![Layer, LoosePoints, Metadata];
    assert_eq!(lost(Format::Ply, Seams::Corners), (kinds, names.clone()));
    let split = vec![Layer, LoosePoints, Metadata, SeamVertices];
    assert_eq!(lost(Format::Ply, Seams::Split), (split, names));
}
