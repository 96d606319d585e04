//! How objects are put together: what each is made of, and what is to be built.

use std::collections::BTreeMap;

use crate::document::Placement;
use crate::formats::threemf::model::{Content, Model, Use};
use crate::formats::threemf::package::Fault;
use crate::formats::threemf::relations::entry_name;
use crate::limits::{Limits, NODES};

/// The objects of all models as one list, and their uses by number.
#[derive(Debug)]
pub(super) struct Assembly {
    nodes: Vec<Node>,
    items: Vec<Child>,
}

#[derive(Debug)]
struct Node {
    name: String,
    /// The part that it is, if it has a content of its own.
    part: Option<usize>,
    children: Vec<Child>,
}

#[derive(Debug)]
struct Child {
    node: usize,
    matrix: [[f64; 4]; 3],
    name: String,
}

impl Assembly {
    /// Puts the objects of a package together. The first model is the one whose items are built. Parts are numbered
    /// in the order of models and objects.
    ///
    /// # Errors
    /// If an object is named that does not exist, objects are made of each other in a circle, or there would be more
    /// instances than the limits allow.
    ///
    /// *Cost*: O(n log n) in objects and uses.
    pub(super) fn of(models: &[Model], limits: &Limits) -> Result<Self, Fault> {
        let names = Names::of(models);
        let (mut nodes, mut parts) = (Vec::new(), 0..);
        for model in models {
            for object in &model.objects {
                let (part, uses) = match &object.content {
                    Content::Components(uses) => (None, uses.as_slice()),
                    Content::Mesh(_) | Content::Other(_) => (parts.next(), &[][..]),
                };
                let wrong = |reason| Fault::of_object(&model.entry, object.id, reason);
                let children =
                    uses.iter().map(|used| names.child(&model.entry, used)).collect::<Result<_, _>>();
                nodes.push(Node { name: object.name.clone(), part, children: children.map_err(wrong)? });
            }
        }
        let Some(root) = models.first() else { return Ok(Assembly { nodes, items: Vec::new() }) };
        let wrong = |reason| Fault::of_entry(&root.entry, reason);
        let items = root.items.iter().map(|used| names.child(&root.entry, used)).collect::<Result<_, _>>();
        let assembly = Assembly { nodes, items: items.map_err(wrong)? };
        assembly.check_instances(models, &root.entry, limits)?;
        Ok(assembly)
    }

    /// Each part at each place where it is to be built, in the order of the file. `None` if nothing is to be built.
    ///
    /// *Cost*: linear in the instances, which the limits bound.
    pub(super) fn placements(&self) -> Option<Vec<Placement>> {
        if self.items.is_empty() {
            return None;
        }
        let mut placements = Vec::new();
        let mut open: Vec<(usize, [[f64; 4]; 3], &str)> = Vec::new();
        open.extend(self.items.iter().rev().map(|item| (item.node, item.matrix, item.name.as_str())));
        while let Some((node, matrix, given)) = open.pop() {
            let node = &self.nodes[node];
            let name = if node.name.is_empty() { given } else { &node.name };
            if let Some(part) = node.part {
                placements.push(Placement { part, name: name.as_bytes().to_vec(), matrix });
            }
            let inner = |child: &'_ Child| (child.node, product(&matrix, &child.matrix));
            for child in node.children.iter().rev() {
                let (inside, matrix) = inner(child);
                open.push((inside, matrix, name));
            }
        }
        Some(placements)
    }

    /// Checks that no object is part of itself, and counts the instances before any is made.
    fn check_instances(&self, models: &[Model], root: &str, limits: &Limits) -> Result<(), Fault> {
        let mut instances: Vec<Option<u64>> = vec![None; self.nodes.len()];
        for start in 0..self.nodes.len() {
            self.count(start, &mut instances).map_err(|node| {
                let objects =
                    models.iter().flat_map(|model| model.objects.iter().map(move |object| (model, object)));
                match objects.skip(node).map(|(model, object)| (&model.entry, object.id)).next() {
                    Some((entry, id)) => {
                        Fault::of_object(entry, id, format!("object {id} is a component of itself"))
                    }
                    None => Fault::of_entry(root, "an object is a component of itself"),
                }
            })?;
        }
        let items = self.items.iter().map(|item| instances[item.node].unwrap_or(0));
        let (found, limit) = (items.fold(0, u64::saturating_add), limits.max_nodes);
        if found > limit { Err(Fault::limit(root, NODES, found, limit)) } else { Ok(()) }
    }

    /// How many nodes one node and all below it make, each as often as it is used. An error is a node within itself.
    fn count(&self, start: usize, instances: &mut [Option<u64>]) -> Result<(), usize> {
        const OPEN: Option<u64> = Some(0);
        let mut path = vec![(start, 0)];
        while let Some((node, next)) = path.pop() {
            if next == 0 && instances[node].is_some() {
                continue;
            }
            let Some(child) = self.nodes[node].children.get(next) else {
                let below = self.nodes[node].children.iter().map(|child| instances[child.node].unwrap_or(0));
                instances[node] = Some(below.fold(1, u64::saturating_add));
                continue;
            };
            instances[node] = OPEN;
            path.push((node, next + 1));
            match instances[child.node] {
                OPEN => return Err(child.node),
                Some(_) => {}
                None => path.push((child.node, 0)),
            }
        }
        Ok(())
    }
}

/// The number of each object of each model.
struct Names {
    nodes: BTreeMap<(String, u32), usize>,
}

impl Names {
    fn of(models: &[Model]) -> Self {
        let objects = models.iter().flat_map(|model| model.objects.iter().map(move |object| (model, object)));
        let named =
            objects.enumerate().map(|(node, (model, object))| ((folded(&model.entry), object.id), node));
        Names { nodes: named.collect() }
    }

    fn child(&self, entry: &str, used: &Use) -> Result<Child, String> {
        let id = used.object;
        let target = used.path.as_deref().map_or_else(|| Some(entry.to_owned()), entry_name);
        let node = target.and_then(|target| self.nodes.get(&(folded(&target), id)).copied());
        match (node, &used.path) {
            (Some(node), _) => Ok(Child { node, matrix: used.matrix, name: used.part_number.clone() }),
            (None, None) => Err(format!("object {id} does not exist")),
            (None, Some(path)) => {
                Err(format!("object {id} of `{}` does not exist", crate::text::shown(path.as_bytes())))
            }
        }
    }
}

/// The name of an entry, in whatever case it is given.
fn folded(entry: &str) -> String {
    entry.to_ascii_lowercase()
}

/// First the inner change of place, then the outer one.
fn product(outer: &[[f64; 4]; 3], inner: &[[f64; 4]; 3]) -> [[f64; 4]; 3] {
    std::array::from_fn(|row| {
        std::array::from_fn(|column| {
            let turned = (0..3).map(|k| outer[row][k] * inner[k][column]).sum::<f64>();
            if column == 3 { turned + outer[row][3] } else { turned }
        })
    })
}
