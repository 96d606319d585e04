//! Whether triangles are a closed manifold, as `EXT_mesh_manifold` asks it of a mesh.

/// Whether each side of a triangle is that of one other triangle, which runs through it the other way.
pub(super) fn is_closed_manifold(corners: &[u32]) -> bool {
    let sides = |triangle: &[u32]| {
        [[triangle[0], triangle[1]], [triangle[1], triangle[2]], [triangle[2], triangle[0]]]
    };
    let mut there: Vec<[u32; 2]> = corners.chunks_exact(3).flat_map(sides).collect();
    let mut back: Vec<[u32; 2]> = there.iter().map(|&[from, to]| [to, from]).collect();
    there.sort_unstable();
    back.sort_unstable();
    !there.is_empty() && there.windows(2).all(|pair| pair[0] != pair[1]) && there == back
}
