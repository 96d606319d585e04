//! The nodes of a file: a forest whose nodes place meshes.

use crate::formats::gltf::asset::Asset;
use crate::formats::gltf::fault::{Fault, Pointer};
use crate::formats::gltf::json::{Object, Value};

/// A node of the forest.
#[derive(Default)]
pub(super) struct Node {
    pub(super) name: Option<String>,
    pub(super) children: Vec<usize>,
    pub(super) mesh: Option<usize>,
    pub(super) is_skinned: bool,
    /// From its space to that of its parent: rows of 4 numbers.
    pub(super) matrix: Matrix,
}

/// The first three rows of a transform: x' = M · (x, y, z, 1).
pub(super) type Matrix = [[f64; 4]; 3];

/// What moves nothing.
pub(super) const IDENTITY: Matrix = [[1.0, 0.0, 0.0, 0.0], [0.0, 1.0, 0.0, 0.0], [0.0, 0.0, 1.0, 0.0]];

/// Opens all nodes.
///
/// # Errors
/// If a node is a child twice, or below itself; if one names what does not exist.
pub(super) fn nodes(asset: &Asset<'_>) -> Result<Vec<Node>, Fault> {
    let skins = skins(asset)?;
    let nodes: Vec<Node> =
        (0..asset.nodes.len()).map(|index| node(asset, index, skins)).collect::<Result<_, _>>()?;
    let mut parent: Vec<Option<usize>> = vec![None; nodes.len()];
    for (index, node) in nodes.iter().enumerate() {
        for &child in &node.children {
            if let Some(other) = parent[child].replace(index) {
                let reason = format!("is a child of node {other} and of node {index}: nodes must form trees");
                return Err(Pointer::item("nodes", child).fault(reason));
            }
        }
    }
    check_cycles(&nodes, &parent)?;
    Ok(nodes)
}

/// Every node that has no parent, and all below, is in a tree; the others are below themselves.
fn check_cycles(nodes: &[Node], parent: &[Option<usize>]) -> Result<(), Fault> {
    let mut is_in_tree = vec![false; nodes.len()];
    let mut open: Vec<usize> = (0..nodes.len()).filter(|&node| parent[node].is_none()).collect();
    while let Some(node) = open.pop() {
        is_in_tree[node] = true;
        open.extend(&nodes[node].children);
    }
    match is_in_tree.iter().position(|&is_in_tree| !is_in_tree) {
        Some(node) => Err(Pointer::item("nodes", node).fault("is below itself: the nodes form a cycle")),
        None => Ok(()),
    }
}

/// How many skins there are, checked.
fn skins(asset: &Asset<'_>) -> Result<usize, Fault> {
    let skins = asset.root.items("skins")?;
    for (index, &skin) in skins.iter().enumerate() {
        let skin = Object::of(skin, Pointer::item("skins", index))?;
        skin.index("inverseBindMatrices", asset.accessors.len(), "accessor")?;
        skin.index("skeleton", asset.nodes.len(), "node")?;
        skin.indices("joints", asset.nodes.len(), "node")?;
    }
    Ok(skins.len())
}

fn node(asset: &Asset<'_>, index: usize, skins: usize) -> Result<Node, Fault> {
    let object = Object::of(asset.nodes[index], Pointer::item("nodes", index))?;
    Ok(Node {
        name: object.text("name")?,
        children: object.indices("children", asset.nodes.len(), "node")?,
        mesh: object.index("mesh", asset.meshes.len(), "mesh")?,
        is_skinned: object.index("skin", skins, "skin")?.is_some(),
        matrix: matrix_of(&object)?,
    })
}

fn matrix_of(node: &Object<'_>) -> Result<Matrix, Fault> {
    if let Some(matrix) = node.get("matrix") {
        let m: [f64; 16] = numbers(matrix).ok_or_else(|| node.fault_in("matrix", "is not 16 numbers"))?;
        return Ok([0, 1, 2].map(|row| [0, 1, 2, 3].map(|column| m[column * 4 + row])));
    }
    let [tx, ty, tz] = member(node, "translation", [0.0; 3])?;
    let [x, y, z, w] = member(node, "rotation", [0.0, 0.0, 0.0, 1.0])?;
    let scale = member(node, "scale", [1.0; 3])?;
    let rotation = [
        [1.0 - 2.0 * (y * y + z * z), 2.0 * (x * y - z * w), 2.0 * (x * z + y * w)],
        [2.0 * (x * y + z * w), 1.0 - 2.0 * (x * x + z * z), 2.0 * (y * z - x * w)],
        [2.0 * (x * z - y * w), 2.0 * (y * z + x * w), 1.0 - 2.0 * (x * x + y * y)],
    ];
    let row = |row: usize, moved: f64| {
        let [a, b, c] = rotation[row];
        [a * scale[0], b * scale[1], c * scale[2], moved]
    };
    Ok([row(0, tx), row(1, ty), row(2, tz)])
}

fn member<const N: usize>(node: &Object<'_>, name: &str, default: [f64; N]) -> Result<[f64; N], Fault> {
    let Some(value) = node.get(name) else { return Ok(default) };
    numbers(value).ok_or_else(|| node.fault_in(name, format!("is not {N} numbers")))
}

fn numbers<const N: usize>(value: Value<'_>) -> Option<[f64; N]> {
    let numbers: Option<Vec<f64>> = value.items()?.into_iter().map(Value::as_number).collect();
    numbers?.try_into().ok()
}

/// The nodes at which the default scene begins, or the first one if none is the default; all that have no parent if
/// there is no scene.
///
/// # Errors
/// If a scene names what does not exist.
pub(super) fn roots(asset: &Asset<'_>, nodes: &[Node]) -> Result<Vec<usize>, Fault> {
    let scenes = asset.root.items("scenes")?;
    // A file without scenes may name the first all the same, as exporters of empty files do.
    let shown = if scenes.is_empty() { None } else { asset.root.index("scene", scenes.len(), "scene")? };
    let shown = shown.unwrap_or(0);
    let mut roots = None;
    for (index, &scene) in scenes.iter().enumerate() {
        let scene = Object::of(scene, Pointer::item("scenes", index))?;
        let begins = scene.indices("nodes", nodes.len(), "node")?;
        roots = if index == shown { Some(begins) } else { roots };
    }
    Ok(roots.unwrap_or_else(|| {
        let mut is_child = vec![false; nodes.len()];
        nodes.iter().flat_map(|node| &node.children).for_each(|&child| is_child[child] = true);
        (0..nodes.len()).filter(|&node| !is_child[node]).collect()
    }))
}

/// A node that places a mesh, and how.
pub(super) struct Placed {
    pub(super) node: usize,
    pub(super) mesh: usize,
    pub(super) matrix: Matrix,
}

/// All nodes of a scene that place a mesh, each node before those below it. The joints place a skinned mesh, not its node.
pub(super) fn placed(nodes: &[Node], roots: &[usize]) -> Vec<Placed> {
    let mut placed = Vec::new();
    let mut is_seen = vec![false; nodes.len()];
    let mut open: Vec<(usize, Matrix)> = roots.iter().rev().map(|&root| (root, IDENTITY)).collect();
    while let Some((index, above)) = open.pop() {
        if std::mem::replace(&mut is_seen[index], true) {
            continue;
        }
        let node = &nodes[index];
        let matrix = product(&above, &node.matrix);
        if let Some(mesh) = node.mesh {
            placed.push(Placed {
                node: index,
                mesh,
                matrix: if node.is_skinned { IDENTITY } else { matrix },
            });
        }
        open.extend(node.children.iter().rev().map(|&child| (child, matrix)));
    }
    placed
}

fn product(one: &Matrix, other: &Matrix) -> Matrix {
    one.map(|row| {
        [0, 1, 2, 3].map(|column| {
            let moved = if column == 3 { row[3] } else { 0.0 };
            row[0] * other[0][column] + row[1] * other[1][column] + row[2] * other[2][column] + moved
        })
    })
}
