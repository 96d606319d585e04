//! Which attribute layers a written file would hold: asked of the writers, with a triangle that has such a layer.

use meshmend_core::{Domain, FaceTable, Layer, PolygonMesh, Values, VertexId};

use crate::layers::domain_name;
use crate::{LossKind, WriteOptions, losses};

/// For each layer of a mesh whether a file that is written so would have it, by its name, elements and type; whether its
/// values are rounded is another question. Options that name no format hold all.
///
/// *Cost*: that of writing a triangle for each layer.
pub fn held_layers(mesh: &PolygonMesh, options: &WriteOptions) -> Vec<bool> {
    let samples: Vec<Layer> = mesh.layers().iter().map(sample).collect();
    let lost_together = lost_names(&samples, options);
    let is_held = |sample: &Layer| {
        lost_names(std::slice::from_ref(sample), options).is_empty()
            && !lost_together.contains(&spelled(sample))
    };
    samples.iter().map(is_held).collect()
}

/// The layers, by what losses call them, that a triangle loses.
fn lost_names(layers: &[Layer], options: &WriteOptions) -> Vec<String> {
    let corners = (0..3).map(VertexId).collect();
    let points = vec![[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]];
    let triangle = FaceTable::triangles(3, corners).ok().and_then(|faces| {
        PolygonMesh::new(points, faces).and_then(|mesh| mesh.with_layers(layers.to_vec())).ok()
    });
    let losses = triangle.map_or(Vec::new(), |triangle| losses(&triangle, options));
    let lost = losses.into_iter().filter(|loss| loss.kind == LossKind::Layer).map(|loss| loss.message);
    let names = layers.iter().map(spelled);
    let lost: Vec<String> = lost.collect();
    names.filter(|name| lost.iter().any(|message| message.contains(name))).collect()
}

/// What a loss calls a layer.
fn spelled(layer: &Layer) -> String {
    format!("{} attribute `{}`", domain_name(layer.domain()), layer.name())
}

/// A layer of a triangle like another one, on the elements on which that was stored.
fn sample(layer: &Layer) -> Layer {
    let count = match layer.home() {
        Domain::Vertex | Domain::Corner => 3,
        Domain::Face => 1,
        // A triangle has none of those.
        Domain::LooseEdge | Domain::LoosePoint => 0,
    };
    let values = one(layer.values(), layer.width());
    Layer::indexed(layer.name(), layer.home(), layer.width(), layer.carry(), values, vec![0; count])
}

/// So many values of the type of some others. They are not 0, which may stand for none.
fn one(values: &Values, width: usize) -> Values {
    match values {
        Values::I8(_) => Values::I8(vec![1; width]),
        Values::U8(_) => Values::U8(vec![1; width]),
        Values::I16(_) => Values::I16(vec![1; width]),
        Values::U16(_) => Values::U16(vec![1; width]),
        Values::I32(_) => Values::I32(vec![1; width]),
        Values::U32(_) => Values::U32(vec![1; width]),
        Values::F32(_) => Values::F32(vec![1.0; width]),
        Values::F64(_) => Values::F64(vec![1.0; width]),
        Values::Text(_) => Values::Text(vec![b"1".to_vec(); width]),
        Values::Lists { items, .. } => {
            Values::Lists { starts: (0..=width as u32).collect(), items: Box::new(one(items, width)) }
        }
    }
}

#[cfg(test)]
mod tests {
    use meshmend_core::Carry;

    use super::*;
    use crate::{Encoding, Format};

    fn mesh(layers: Vec<Layer>) -> PolygonMesh {
        let faces = FaceTable::triangles(3, (0..3).map(VertexId).collect()).unwrap();
        PolygonMesh::new(vec![[0.0; 3]; 3], faces).unwrap().with_layers(layers).unwrap()
    }

    fn layer(name: &str, domain: Domain, width: usize, value: Values) -> Layer {
        let count = if domain == Domain::Face { 1 } else { 3 };
        Layer::indexed(name, domain, width, Carry::Copy, value, vec![0; count])
    }

    #[test]
    fn each_format_holds_what_its_writer_writes() {
        let name = || Values::Text(vec![b"red".to_vec()]);
        let mesh = mesh(vec![
            layer("material", Domain::Face, 1, name()),
            layer("object", Domain::Face, 1, name()),
            layer("attribute", Domain::Face, 1, Values::U16(vec![0])),
            layer("color", Domain::Face, 3, Values::U8(vec![0; 3])),
            layer("texcoord", Domain::Corner, 2, Values::F64(vec![0.0; 2])),
        ]);
        let held = |format, encoding| held_layers(&mesh, &WriteOptions::of(format).with_encoding(encoding));
        assert_eq!(held(Format::Obj, Encoding::Ascii), [true, true, false, false, true]);
        assert_eq!(held(Format::Ply, Encoding::Ascii), [false, false, true, true, true]);
        assert_eq!(held(Format::Off, Encoding::Ascii), [false, false, false, true, false]);
        assert_eq!(held(Format::Stl, Encoding::Ascii), [false, true, false, false, false]);
        assert_eq!(held(Format::Stl, Encoding::LittleEndian), [false, false, true, false, false]);
        assert_eq!(held_layers(&mesh, &WriteOptions::default()), [true; 5]);
    }

    #[test]
    fn what_gives_way_to_another_layer_is_not_held() {
        let texcoord = || layer("texcoord", Domain::Vertex, 2, Values::F64(vec![0.0; 2]));
        let normal = || layer("normal", Domain::Vertex, 3, Values::F64(vec![0.0; 3]));
        let held = |layers| held_layers(&mesh(layers), &WriteOptions::of(Format::Off));
        assert_eq!(held(vec![texcoord()]), [true]);
        assert_eq!(held(vec![texcoord(), normal()]), [false, true]);
        let loose = Layer::indexed("group", Domain::LooseEdge, 1, Carry::Copy, Values::U8(vec![0]), vec![]);
        assert_eq!(held(vec![loose, texcoord(), normal()])[1..], [false, true]);
    }
}
