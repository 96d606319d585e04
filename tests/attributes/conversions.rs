//! Conversions keep what a mesh carries, or name what is lost.

use std::collections::BTreeSet;

use meshmend_core::{CornerId, Domain, Id, Layer, Metadata, PolygonMesh, Role, Values};
use meshmend_io::{Format, Loss, LossKind, Seams};
use meshmend_tests::corpus::corpus;
use meshmend_tests::each::assert_each;

use crate::values::{TWO_TETRAHEDRA, Target, converted, read, readable, value, written};

#[test]
pub(crate) fn what_comes_back_from_any_format_is_what_went_in_but_for_the_losses_named() {
    let Some(entries) = corpus() else { return };
    // What becomes of attributes of a scene is asked of every pair of formats elsewhere.
    let mut meshes = readable(&entries);
    meshes.retain(|(entry, _)| !entry.name.ends_with(".glb") && !entry.name.ends_with(".gltf"));
    assert_each(&meshes, |(entry, mesh)| {
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
pub(crate) fn unnamed_loss(
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
pub(crate) fn has_same_vertices(before: &PolygonMesh, losses: &[Loss]) -> bool {
    use LossKind::{Precision, SharedVertices, ShortFaces, UnusedVertices};
    let others = [SharedVertices, UnusedVertices, ShortFaces, Precision];
    // Points that are not finite equal nothing, and so are not shared again.
    !losses.iter().any(|loss| others.contains(&loss.kind))
        && before.positions().iter().flatten().all(|x| x.is_finite())
}

/// How many vertices the losses say that there are more: `N vertices are written M times`, `with N vertices more`.
pub(crate) fn further_vertices(losses: &[Loss]) -> usize {
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

pub(crate) fn unnamed_loss_of_shape(
    before: &PolygonMesh,
    after: &PolygonMesh,
    losses: &[Loss],
) -> Option<String> {
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
pub(crate) fn is_stated(statement: &Metadata, mesh: &PolygonMesh, format: Format) -> bool {
    let is_moved = |other: &Metadata| {
        statement.kind() == "comment" && other.key == "comment" && other.value == statement.value
    };
    mesh.metadata().contains(statement) || format != Format::Obj && mesh.metadata().iter().any(is_moved)
}

/// The points of all corners in order, to the bit but for the payload of NaNs and the sign of 0.
pub(crate) fn corner_positions(mesh: &PolygonMesh) -> Vec<[u64; 3]> {
    let bits = |x: f64| if x.is_nan() { u64::MAX } else { (x + 0.0).to_bits() };
    let point = |corner: CornerId| mesh.position(mesh.faces().corner_vertex(corner)).map(bits);
    mesh.faces().corners().map(point).collect()
}

/// How a layer differs in another mesh with the same elements, unless a loss speaks of it.
pub(crate) fn unnamed_layer_loss(layer: &Layer, after: &PolygonMesh, losses: &[Loss]) -> Option<String> {
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
pub(crate) fn without_third_number(layer: &Layer, losses: &[Loss]) -> Layer {
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
pub(crate) fn value_as_in(layer: &Layer, element: usize, other: &Layer) -> Option<String> {
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
pub(crate) fn conversions_of_a_mesh_that_has_everything_name_their_losses() {
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
