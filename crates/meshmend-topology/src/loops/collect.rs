//! The generators of each component, read off its trees and its boundary.

use meshmend_core::{Cancelled, Column, Connectivity, EdgeId, Id};

use super::STEP;
use super::error::GeneratorError;
use super::forest::Forest;
use super::generator::{ComponentGenerators, Generator, GeneratorKind, LoopSystem, Path};
use super::surfaces::Surfaces;
use super::transport::Transport;
use super::trees::{Ground, Trees};
use crate::{ComponentId, Surface};

/// All components with their generators.
///
/// *Cost*: linear, and a logarithm for each left-over edge.
pub(super) fn components<K: Connectivity>(
    ground: &Ground<'_, K>,
    trees: &Trees,
    left_over: &[EdgeId],
) -> Result<Vec<ComponentGenerators>, GeneratorError> {
    let ids = ground.surfaces.components.ids();
    let mut components: Vec<ComponentGenerators> =
        ids.map(|id| without_generators(ground, trees, id)).collect();
    add_closed(ground, trees, left_over, &mut components)?;
    add_boundary(ground, &mut components);
    components.iter().try_for_each(|found| check_count(ground.surfaces, found))?;
    Ok(components)
}

fn without_generators<K: Connectivity>(
    ground: &Ground<'_, K>,
    trees: &Trees,
    component: ComponentId,
) -> ComponentGenerators {
    let system = ground.surfaces.facts[component].surface().zip(trees.roots[component]);
    let measure = ground.weights.measures[component];
    ComponentGenerators {
        component,
        system: system.map(|(surface, root)| LoopSystem { surface, root, measure, length: 0.0 }),
        obstacle: ground.surfaces.obstacles[component].clone(),
        generators: Vec::new(),
    }
}

/// Adds the generators of the left-over edges.
fn add_closed<K: Connectivity>(
    ground: &Ground<'_, K>,
    trees: &Trees,
    left_over: &[EdgeId],
    components: &mut [ComponentGenerators],
) -> Result<(), Cancelled> {
    ground.watch.look(STEP, 0, 0)?;
    let transport = Transport::along(ground.kernel, &ground.surfaces.patches, &trees.forest);
    for (place, &edge) in left_over.iter().enumerate() {
        ground.watch.look_at_times(STEP, place, left_over.len())?;
        let Some(component) = ground.surfaces.of_edge(ground.kernel, edge) else { continue };
        let found = &mut components[component.index()];
        if let Some(system) = &mut found.system {
            system.length += ground.based_length(&trees.forest, edge);
            let surface = system.surface;
            found.generators.push(closed(ground, &trees.forest, &transport, surface, edge));
        }
    }
    Ok(())
}

/// The generator of a left-over edge.
fn closed<K: Connectivity>(
    ground: &Ground<'_, K>,
    forest: &Forest,
    transport: &Transport,
    surface: Surface,
    edge: EdgeId,
) -> Generator {
    let ends = ground.kernel.edge_ends(edge);
    let apex = forest.ancestors.lowest_common(ends[0], ends[1]);
    let beyond = ends.map(|end| forest.distance(end) - forest.distance(apex));
    let steps = ends.map(|end| forest.ancestors.depth(end) - forest.ancestors.depth(apex));
    Generator {
        kind: match surface {
            Surface::Orientable { .. } => GeneratorKind::Handle,
            Surface::NonOrientable { .. } => GeneratorKind::CrossCap,
        },
        length: beyond[0] + beyond[1] + ground.weights.of(edge),
        vertex_count: (steps[0] + steps[1]) as usize + 1,
        is_two_sided: !transport.is_turning(ground.kernel, edge),
        path: Path::Closed { edge, ends, apex },
    }
}

/// Adds the boundary loops, but for the first one of each component.
fn add_boundary<K: Connectivity>(ground: &Ground<'_, K>, components: &mut [ComponentGenerators]) {
    let lengths = boundary_lengths(ground);
    let mut is_first = Column::filled(true, components.len());
    for (place, vertices) in ground.surfaces.boundary.iter().enumerate() {
        let Some(component) = vertices.first().and_then(|&v| ground.surfaces.of_vertex(v)) else { continue };
        if !std::mem::replace(&mut is_first[component], false) {
            components[component.index()].generators.push(Generator {
                kind: GeneratorKind::Boundary,
                length: lengths[place],
                vertex_count: vertices.len(),
                is_two_sided: true,
                path: Path::Boundary(place),
            });
        }
    }
}

/// How long each boundary loop is.
fn boundary_lengths<K: Connectivity>(ground: &Ground<'_, K>) -> Vec<f64> {
    let mut lengths = vec![0.0; ground.surfaces.boundary.count()];
    let is_boundary = |edge: &EdgeId| ground.kernel.edge_corners(*edge).nth(1).is_none();
    for edge in ground.kernel.edges().filter(is_boundary) {
        if ground.surfaces.of_edge(ground.kernel, edge).is_some() {
            lengths[ground.dual.boundary_loop(edge) as usize] += ground.weights.of(edge);
        }
    }
    lengths
}

/// Compares the number of generators of a surface with β₁ = 1 + β₂ − χ.
fn check_count(surfaces: &Surfaces, found: &ComponentGenerators) -> Result<(), GeneratorError> {
    let (component, facts) = (found.component, &surfaces.facts[found.component]);
    let expected = 1 + i64::from(facts.is_closed) - facts.euler_characteristic();
    let count = found.generators.len();
    if found.system.is_some() && i64::try_from(count) != Ok(expected) {
        return Err(GeneratorError::Count { component, found: count, expected });
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use std::ops::ControlFlow;

    use meshmend_core::{VertexId, Watch};
    use meshmend_testkit::assert_every_variant;

    use super::*;
    use crate::shapes::torus;
    use crate::{GeneratorOptions, Roots, generators};

    #[test]
    fn every_failure_says_why_there_are_no_generators() {
        let kernel = torus(3, 4).kernel();
        let surfaces = Surfaces::of(&kernel, &Watch::NOBODY).unwrap();
        let options = GeneratorOptions::default();
        let ground = Ground::new(&kernel, &surfaces, &options).unwrap();
        let trees = ground.trees(options.roots).unwrap();
        let [_, left_over] = ground.dual.split(&trees.order, ground.watch).unwrap();
        assert!(components(&ground, &trees, &left_over).is_ok());
        let failure = |options| generators(&kernel, &options).unwrap_err();
        let lengths = Column::filled(1.0, 3);
        let stop = Watch::new(|_| ControlFlow::Break(()));
        let cases = vec![
            (
                failure(GeneratorOptions { roots: Roots::At(VertexId(99)), ..options }),
                "v99 is in no face, so no path begins there",
            ),
            (
                failure(GeneratorOptions { lengths: Some(&lengths), ..options }),
                "there are 3 lengths for 24 edges",
            ),
            (
                components(&ground, &trees, &left_over[1..]).unwrap_err(),
                "component 0 has 1 generators in place of 2, which is a mistake of this program",
            ),
            (failure(GeneratorOptions { watch: Some(&stop), ..options }), "cancelled"),
        ];
        assert_every_variant!(cases, GeneratorError { NoSuchRoot, Lengths, Count, Cancelled });
    }
}
