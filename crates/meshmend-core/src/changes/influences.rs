//! What moves a created vertex: the joints of all that it lies between, with their shares.

use std::collections::BTreeMap;

use crate::{Blend, CornerId, Domain, Draft, Id, Layer, NO_VALUE, PolygonMesh, Role, Values};

/// The joints and the weights of one set, by their places in the list of layers.
#[derive(Clone, Copy)]
struct Pair {
    joints: usize,
    weights: usize,
}

/// Gives created elements the joints of those that they lie between: the union of them, as many of the largest shares as
/// there is room for, together 1.
///
/// *Cost*: nothing without joints or created elements; else linear in the layers of joints.
pub(super) fn blend_influences(mesh: &PolygonMesh, draft: &Draft, layers: &mut [Layer]) {
    let pairs = pairs(layers);
    if pairs.is_empty() || draft.created_vertices.is_empty() {
        return;
    }
    let first = draft.vertex_sources.len() - draft.created_vertices.len();
    let mut given = Given { mesh, pairs: &pairs, old: mesh.layers(), layers, at: Vec::new() };
    for (at, created) in draft.created_vertices.iter().enumerate() {
        if let Some(place) = created.place {
            given.add(Domain::Vertex, first + at, place);
        }
    }
    for &(corner, place) in &draft.created_corners {
        given.add(Domain::Corner, corner.index(), place);
    }
    let at = given.at;
    for (place, layer) in layers.iter_mut().enumerate() {
        *layer = with_uses(layer, at.iter().filter(|use_| use_.layer == place));
    }
}

/// Each layer of joints with each of weights of its set: a set may have several, of different types.
fn pairs(layers: &[Layer]) -> Vec<Pair> {
    let mut pairs = Vec::new();
    for (joints, layer) in layers.iter().enumerate() {
        let Role::Joints(set) = layer.role() else { continue };
        let fits = |other: &Layer| other.role() == Role::Weights(set) && other.width() == layer.width();
        let weights = layers.iter().enumerate().filter(|(_, other)| fits(other));
        pairs.extend(weights.map(|(weights, _)| Pair { joints, weights }));
    }
    pairs
}

/// A value that an element is to have.
struct Use {
    layer: usize,
    domain: Domain,
    element: usize,
    value: u32,
}

struct Given<'a> {
    mesh: &'a PolygonMesh,
    pairs: &'a [Pair],
    old: &'a [Layer],
    layers: &'a mut [Layer],
    at: Vec<Use>,
}

impl Given<'_> {
    /// Adds the values of a created element.
    fn add(&mut self, domain: Domain, element: usize, place: Blend) {
        let parts = place.parts(self.mesh.faces());
        let has_all = |pair: &&Pair| {
            parts.iter().all(|&(corner, _)| {
                [pair.joints, pair.weights].iter().all(|&layer| self.old_use(layer, corner) != NO_VALUE)
            })
        };
        let pairs: Vec<Pair> = self.pairs.iter().filter(has_all).copied().collect();
        let shares = self.shares(&pairs, &parts);
        let total: f64 = shares.iter().map(|share| share.1).sum();
        if total <= 0.0 || self.is_one_value(&pairs, &parts) {
            return;
        }
        let (mut rest, mut before) = (shares.as_slice(), 0.0);
        for pair in pairs {
            let width = self.layers[pair.joints].width();
            let (own, others) = rest.split_at(width.min(rest.len()));
            let own: Vec<(u32, f64)> = own.iter().map(|&(joint, share)| (joint, share / total)).collect();
            let rows = rows(&own, before, unit(&self.layers[pair.weights]), width);
            before += own.iter().map(|share| share.1).sum::<f64>();
            rest = others;
            for (layer, row) in [pair.joints, pair.weights].into_iter().zip(rows) {
                let value = self.layers[layer].push_numbers(&row);
                self.at.push(Use { layer, domain, element, value });
            }
        }
    }

    /// The joints of some corners with their shares, the largest first, as many as there is room for.
    fn shares(&self, pairs: &[Pair], parts: &[(CornerId, f64)]) -> Vec<(u32, f64)> {
        let mut share_of: BTreeMap<u32, f64> = BTreeMap::new();
        for (&(corner, part), pair) in
            parts.iter().flat_map(|part| pairs.iter().map(move |pair| (part, pair)))
        {
            let [joints, weights] = [pair.joints, pair.weights].map(|layer| {
                let (layer, value) = (&self.old[layer], self.old_use(layer, corner) as usize);
                let range = value * layer.width()..(value + 1) * layer.width();
                range.map(|place| layer.values().number(place).unwrap_or(0.0))
            });
            let unit = unit(&self.old[pair.weights]).unwrap_or(1.0);
            for (joint, weight) in joints.zip(weights).filter(|&(_, weight)| weight > 0.0) {
                *share_of.entry(joint as u32).or_default() += part * weight / unit;
            }
        }
        let mut shares: Vec<(u32, f64)> = share_of.into_iter().collect();
        shares.sort_by(|one, other| other.1.total_cmp(&one.1).then(one.0.cmp(&other.0)));
        shares.truncate(pairs.iter().map(|pair| self.layers[pair.joints].width()).sum());
        shares
    }

    fn is_one_value(&self, pairs: &[Pair], parts: &[(CornerId, f64)]) -> bool {
        let layers = pairs.iter().flat_map(|pair| [pair.joints, pair.weights]);
        let mut layers = layers.map(|layer| parts.iter().map(move |part| self.old_use(layer, part.0)));
        layers.all(|mut uses| uses.next().is_none_or(|first| uses.all(|other| other == first)))
    }

    fn old_use(&self, layer: usize, corner: CornerId) -> u32 {
        let layer = &self.old[layer];
        match layer.domain() {
            Domain::Corner => layer.element_use(corner.index()),
            Domain::Vertex => layer.element_use(self.mesh.faces().corner_vertex(corner).index()),
            Domain::Face | Domain::LooseEdge | Domain::LoosePoint => NO_VALUE,
        }
    }
}

/// What the whole is in whole numbers; `None` for numbers with fractions.
fn unit(weights: &Layer) -> Option<f64> {
    match weights.values() {
        Values::U8(_) => Some(f64::from(u8::MAX)),
        Values::U16(_) => Some(f64::from(u16::MAX)),
        _ => None,
    }
}

/// The joints and the weights of one set, the shares before it known, so that whole numbers come to the whole in all sets.
fn rows(shares: &[(u32, f64)], before: f64, unit: Option<f64>, width: usize) -> [Vec<f64>; 2] {
    let mut weights: Vec<f64> = shares.iter().map(|share| share.1).collect();
    if let Some(unit) = unit {
        let end = ((before + weights.iter().sum::<f64>()) * unit).round();
        let exact: Vec<f64> = weights.iter().map(|weight| weight * unit).collect();
        weights = exact.iter().map(|weight| weight.floor()).collect();
        let missing = end - (before * unit).round() - weights.iter().sum::<f64>();
        let mut order: Vec<usize> = (0..exact.len()).collect();
        order.sort_by(|&one, &other| {
            exact[other].fract().total_cmp(&exact[one].fract()).then(one.cmp(&other))
        });
        order.into_iter().take(missing.max(0.0) as usize).for_each(|at| weights[at] += 1.0);
    }
    // A joint without weight is 0, as the format has it.
    let joint = |(share, weight): (&(u32, f64), &f64)| if *weight > 0.0 { f64::from(share.0) } else { 0.0 };
    let mut joints: Vec<f64> = shares.iter().zip(&weights).map(joint).collect();
    joints.resize(width, 0.0);
    weights.resize(width, 0.0);
    [joints, weights]
}

fn with_uses<'a>(layer: &Layer, given: impl Iterator<Item = &'a Use> + Clone) -> Layer {
    let mut of_domain = given.clone().filter(|given| given.domain == layer.domain()).peekable();
    if of_domain.peek().is_none() {
        return layer.clone();
    }
    let mut uses: Vec<u32> = (0..layer.element_count()).map(|element| layer.element_use(element)).collect();
    of_domain.for_each(|given| uses[given.element] = given.value);
    let changed = layer.with_uses(layer.domain(), uses);
    if layer.domain() == Domain::Vertex || layer.home() != Domain::Vertex {
        return changed;
    }
    // The layer stands at the corners for now: each vertex has a value of its own beside.
    let of_vertices: Vec<&Use> = given.filter(|given| given.domain == Domain::Vertex).collect();
    let count = of_vertices.iter().map(|given| given.element + 1).max().unwrap_or(0);
    let mut vertex_uses = layer.all_vertex_uses(count);
    of_vertices.iter().for_each(|given| vertex_uses[given.element] = given.value);
    changed.with_vertex_uses(vertex_uses)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn whole_numbers_come_to_the_whole_in_all_sets() {
        let shares = [(7, 0.5), (2, 0.3), (1, 0.199), (4, 0.001)];
        let [joints, weights] = rows(&shares, 0.0, Some(255.0), 4);
        assert_eq!((joints, weights), (vec![7.0, 2.0, 1.0, 0.0], vec![128.0, 76.0, 51.0, 0.0]));
        let [first, second] =
            [rows(&shares[..2], 0.0, Some(255.0), 2), rows(&shares[2..], 0.8, Some(255.0), 2)];
        let sum: f64 = first[1].iter().chain(&second[1]).sum();
        assert_eq!(sum, 255.0);
    }

    #[test]
    fn fractions_stay_as_they_are() {
        let [joints, weights] = rows(&[(3, 0.75), (5, 0.25)], 0.0, None, 4);
        assert_eq!((joints, weights), (vec![3.0, 5.0, 0.0, 0.0], vec![0.75, 0.25, 0.0, 0.0]));
    }
}
