//! Which attribute layers a written file would hold. The writers answer that, for a triangle with such layers.

use std::collections::BTreeSet;

use meshmend_core::{Domain, FaceTable, Layer, PolygonMesh, Values, VertexId};

use crate::{LostLayer, WriteOptions, losses};

/// For each layer of a mesh, whether a file written with these options would have it beside the others. Name,
/// elements and type decide; rounding of values does not matter. Options without a format hold all layers.
///
/// *Cost*: that of writing a triangle with all layers.
pub fn held_layers(mesh: &PolygonMesh, options: &WriteOptions) -> Vec<bool> {
    let samples: Vec<Layer> = mesh.layers().iter().map(sample).collect();
    let names: Vec<LostLayer> = samples.iter().map(LostLayer::of).collect();
    let lost = lost_layers(samples, options);
    names.iter().map(|name| !lost.contains(name)).collect()
}

/// The layers that a triangle loses.
fn lost_layers(layers: Vec<Layer>, options: &WriteOptions) -> BTreeSet<LostLayer> {
    let corners = (0..3).map(VertexId).collect();
    let points = vec![[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]];
    let triangle = FaceTable::triangles(3, corners)
        .ok()
        .and_then(|faces| PolygonMesh::new(points, faces).and_then(|mesh| mesh.with_layers(layers)).ok());
    let losses = triangle.map_or(Vec::new(), |triangle| losses(&triangle, options));
    losses.into_iter().filter_map(|loss| loss.layer).collect()
}

/// A layer of a triangle that is like another layer, on the elements where that was stored.
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

/// Some values of the type of others. They are not 0, which may stand for no value.
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
    use crate::{Encoding, Format, LossKind};

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

    #[test]
    fn what_is_lost_alone_is_lost_beside_any_other() {
        let names = ["color", "normal", "texcoord", "weight", "texnumber", "material", "object", "attribute"];
        let values = [
            (1, Values::U16(vec![0])),
            (1, Values::Text(vec![b"red".to_vec()])),
            (3, Values::F64(vec![0.0; 3])),
        ];
        let kinds: Vec<Layer> = names
            .iter()
            .flat_map(|name| [Domain::Vertex, Domain::Corner, Domain::Face].map(|domain| (name, domain)))
            .flat_map(|(name, domain)| values.clone().map(|(width, value)| layer(name, domain, width, value)))
            .collect();
        for (format, &encoding) in Format::ALL.iter().flat_map(|f| f.encodings().iter().map(move |e| (f, e)))
        {
            let options = WriteOptions::of(*format).with_encoding(encoding);
            let lost = |layers: Vec<Layer>| {
                let held = held_layers(&mesh(layers), &options);
                held.first() == Some(&false)
            };
            for one in kinds.iter().filter(|one| lost(vec![(*one).clone()])) {
                for other in &kinds {
                    assert!(lost(vec![one.clone(), other.clone()]), "{format}: {one:?} beside {other:?}");
                }
            }
        }
    }

    #[test]
    fn a_lost_layer_is_known_whatever_its_name_holds() {
        for name in ["a", "", "a` of `b", "vertex attribute `a`", "a` of 3 vertices, and `b"] {
            let layers = vec![
                layer(name, Domain::Vertex, 1, Values::U16(vec![0])),
                layer(name, Domain::Face, 1, Values::Text(vec![b"red".to_vec()])),
            ];
            for format in [Format::Off, Format::Stl, Format::Obj] {
                assert_eq!(
                    held_layers(&mesh(layers.clone()), &WriteOptions::of(format)),
                    [false; 2],
                    "{name}"
                );
            }
            let written = held_layers(&mesh(layers), &WriteOptions::of(Format::Ply));
            assert_eq!(written, [true, false], "{name}");
        }
    }

    #[test]
    fn an_alpha_that_is_lost_is_no_layer() {
        let color = layer("color", Domain::Vertex, 4, Values::U8(vec![1; 4]));
        let losses = losses(&mesh(vec![color.clone()]), &WriteOptions::of(Format::Obj));
        assert!(losses.iter().any(|loss| loss.kind == LossKind::Layer && loss.layer.is_none()));
        assert_eq!(held_layers(&mesh(vec![color]), &WriteOptions::of(Format::Obj)), [true]);
    }
}
