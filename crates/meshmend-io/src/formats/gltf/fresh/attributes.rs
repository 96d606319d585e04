//! Which layers become which attributes.

use std::collections::BTreeSet;

use meshmend_core::{Domain, Layer, PolygonMesh, Role, Values};

use crate::layers::{has_fractions, is_numeric};

/// What a layer is to readers of the format.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Kind {
    Normal,
    Tangent,
    /// A set of texture coordinates.
    TexCoord(usize),
    /// A set of colours.
    Color(usize),
    /// Numbers of which the format knows the name alone.
    Own,
}

/// The kinds of all layers of a mesh.
pub(super) struct Kinds {
    kinds: Vec<Option<Kind>>,
}

/// A layer that is written with the vertices.
pub(super) struct Attribute<'a> {
    pub(super) layer: &'a Layer,
    pub(super) kind: Kind,
    pub(super) semantic: String,
}

impl Kinds {
    /// The kinds of some layers. Only the first one of normals and the first one of tangents are those of the format.
    pub(super) fn of(layers: &[Layer]) -> Self {
        let (mut normals, mut tangents, mut texcoords, mut colors) = (0, 0, 0, 0);
        let mut names = BTreeSet::new();
        let kinds = layers.iter().map(|layer| {
            if !is_storable(layer) {
                return None;
            }
            let kind = match layer.role() {
                Role::Normal if is_normal(layer) => {
                    counted(&mut normals, |n| (n == 0).then_some(Kind::Normal))
                }
                Role::Tangent if is_tangent(layer) => {
                    counted(&mut tangents, |n| (n == 0).then_some(Kind::Tangent))
                }
                Role::TexCoord if is_texcoord(layer) => counted(&mut texcoords, |n| Some(Kind::TexCoord(n))),
                Role::Color if is_color(layer) => counted(&mut colors, |n| Some(Kind::Color(n))),
                _ => None,
            };
            let kind = kind.unwrap_or(Kind::Own);
            // Of two layers with one name the first one is written.
            names.insert(semantic(kind, layer)).then_some(kind)
        });
        Kinds { kinds: kinds.collect() }
    }

    /// The kind of a layer; `None` if the format can't hold it.
    pub(super) fn kind(&self, layer: usize) -> Option<Kind> {
        self.kinds.get(layer).copied().flatten()
    }
}

/// The attributes of a mesh that was made ready.
pub(super) fn attributes(mesh: &PolygonMesh) -> Vec<Attribute<'_>> {
    let kinds = Kinds::of(mesh.layers());
    let layers = mesh.layers().iter().enumerate().filter(|(_, layer)| layer.domain() == Domain::Vertex);
    let attribute = |(at, layer)| {
        let kind = kinds.kind(at)?;
        Some(Attribute { layer, kind, semantic: semantic(kind, layer) })
    };
    layers.filter_map(attribute).collect()
}

fn counted(count: &mut usize, kind: impl Fn(usize) -> Option<Kind>) -> Option<Kind> {
    *count += 1;
    kind(*count - 1)
}

fn semantic(kind: Kind, layer: &Layer) -> String {
    match kind {
        Kind::Normal => "NORMAL".to_owned(),
        Kind::Tangent => "TANGENT".to_owned(),
        Kind::TexCoord(set) => format!("TEXCOORD_{set}"),
        Kind::Color(set) => format!("COLOR_{set}"),
        Kind::Own if layer.name().starts_with('_') => layer.name().to_owned(),
        Kind::Own => format!("_{}", layer.name()),
    }
}

/// Whether vertices can have the values of a layer. What moves vertices means nothing without skins and animations,
/// which a new file has not.
fn is_storable(layer: &Layer) -> bool {
    let is_of_vertices = matches!(layer.domain(), Domain::Vertex | Domain::Corner);
    let is_at_rest =
        matches!(layer.role(), Role::Plain | Role::Normal | Role::Tangent | Role::TexCoord | Role::Color);
    is_of_vertices && is_at_rest && is_numeric(layer) && (1..=4).contains(&layer.width())
}

fn is_normal(layer: &Layer) -> bool {
    layer.width() == 3 && (has_fractions(layer) || layer.is_normalized() && is_signed(layer.values()))
}

fn is_signed(values: &Values) -> bool {
    matches!(values, Values::I8(_) | Values::I16(_))
}

/// Whether all values are a direction of unit length and a sign.
fn is_tangent(layer: &Layer) -> bool {
    let is_tangent = |value: &[f64]| {
        let square: f64 = value[..3].iter().map(|x| x * x).sum();
        (square.sqrt() - 1.0).abs() < UNIT_SLACK && value[3].abs() == 1.0
    };
    layer.width() == 4 && has_fractions(layer) && each_value(layer, is_tangent)
}

/// How far the length of a direction may be from 1. Validators allow a little more.
pub(super) const UNIT_SLACK: f64 = 0.005;

/// Whether all values are two numbers, or have a third one that is always 0.
fn is_texcoord(layer: &Layer) -> bool {
    let is_unsigned = matches!(layer.values(), Values::U8(_) | Values::U16(_));
    match layer.width() {
        2 => has_fractions(layer) || layer.is_normalized() && is_unsigned,
        3 => has_fractions(layer) && each_value(layer, |value| value[2] == 0.0),
        _ => false,
    }
}

/// Whether all values are colours of three or four numbers that stand for 0 to 1.
fn is_color(layer: &Layer) -> bool {
    let is_fraction = |value: &[f64]| value.iter().all(|x| (0.0..=1.0).contains(x));
    matches!(layer.width(), 3 | 4)
        && match layer.values() {
            Values::U8(_) | Values::U16(_) => true,
            _ => has_fractions(layer) && each_value(layer, is_fraction),
        }
}

fn each_value(layer: &Layer, is_fit: impl Fn(&[f64]) -> bool) -> bool {
    let width = layer.width();
    match layer.values() {
        Values::F64(values) => values.chunks_exact(width).all(is_fit),
        Values::F32(values) => {
            let mut wide = [0.0; 4];
            values.chunks_exact(width).all(|value| {
                wide.iter_mut().zip(value).for_each(|(slot, &x)| *slot = f64::from(x));
                is_fit(&wide[..width])
            })
        }
        _ => false,
    }
}
