"""Inputs and answers that owe nothing to the program that is measured: arrays, and counts by sorting."""

import os

import numpy as np
from scipy.sparse import coo_array
from scipy.sparse.csgraph import connected_components

# What is asked of a mesh that was split: it has all its faces, and it is manifold.
MANIFOLD = ["faces", "non_manifold_edges", "non_manifold_vertices"]


def load(file):
    """The vertices (float64) and triangles (int64) of a binary PLY file that meshmend-bench wrote."""
    with open(file, "rb") as rows:
        counts = []
        while (line := rows.readline()) != b"end_header\n":
            if line.startswith(b"element"):
                counts.append(int(line.split()[2]))
        vertices = np.fromfile(rows, "<f4", 3 * counts[0]).reshape(-1, 3)
        faces = np.fromfile(rows, [("size", "u1"), ("vertices", "<i4", 3)], counts[1])
    if not (faces["size"] == 3).all():
        raise ValueError(f"{file}: not all faces are triangles")
    return vertices.astype(np.float64), np.ascontiguousarray(faces["vertices"].astype(np.int64))


def stl_counts(file):
    """The figures of a binary STL file, by its size."""
    faces = (os.path.getsize(file) - 84) // 50
    return {"vertices": 3 * faces, "faces": faces}


def edge_counts(triangles):
    """How many edges there are, with one side, with three or more, and with two that run the same way."""
    triangles = np.asarray(triangles, np.int64)
    start, end = triangles.ravel(), np.roll(triangles, -1, axis=1).ravel()
    key = np.minimum(start, end) * (int(triangles.max(initial=0)) + 1) + np.maximum(start, end)
    order = np.argsort(key, kind="stable")
    _, first, degree = np.unique(key[order], return_index=True, return_counts=True)
    forward = np.add.reduceat((start < end)[order].astype(np.int64), first)
    return {
        "edges": len(first),
        "boundary_edges": int((degree == 1).sum()),
        "non_manifold_edges": int((degree > 2).sum()),
        "inconsistent_edges": int(((degree == 2) & (forward != 1)).sum()),
    }


def non_manifold_vertices(triangles):
    """How many vertices have faces round them that do not all hang together across edges there."""
    triangles = np.asarray(triangles, np.int64)
    corners = np.arange(triangles.size).reshape(-1, 3)
    start, end = triangles.ravel(), np.roll(triangles, -1, axis=1).ravel()
    at_start, at_end = corners.ravel(), np.roll(corners, -1, axis=1).ravel()
    is_forward = start < end
    key = np.where(is_forward, start, end) * (int(triangles.max(initial=0)) + 1) + np.where(is_forward, end, start)
    low, high = np.where(is_forward, at_start, at_end), np.where(is_forward, at_end, at_start)
    order = np.argsort(key, kind="stable")
    one, other = order[:-1], order[1:]
    is_same = key[one] == key[other]
    one, other = one[is_same], other[is_same]
    pairs = np.concatenate([low[one], high[one]]), np.concatenate([low[other], high[other]])
    graph = coo_array((np.ones(len(pairs[0]), bool), pairs), shape=(triangles.size, triangles.size))
    umbrella = connected_components(graph, directed=False)[1]
    met = np.unique(np.stack([start, umbrella]), axis=1)[0]
    return int((np.unique(met, return_counts=True)[1] > 1).sum())


def figures(vertex_count, triangles, *names):
    """The figures of a result that have these names."""
    known = {"vertices": int(vertex_count), "faces": len(triangles)}
    if not known.keys() >= set(names):
        known |= edge_counts(triangles)
    if "non_manifold_vertices" in names:
        known["non_manifold_vertices"] = non_manifold_vertices(triangles)
    return {name: known[name] for name in names}


def disc_figures(triangles):
    """The figures that tell a disc."""
    counts = edge_counts(triangles)
    vertices = len(np.unique(triangles))
    start, end = triangles.ravel(), np.roll(triangles, -1, axis=1).ravel()
    low, high = np.minimum(start, end), np.maximum(start, end)
    _, index, degree = np.unique(low * (int(high.max()) + 1) + high, return_index=True, return_counts=True)
    rim = index[degree == 1]
    following = dict(zip(start[rim].tolist(), end[rim].tolist()))
    loops = 0
    while following:
        vertex = next(iter(following))
        while (vertex := following.pop(vertex, None)) is not None:
            pass
        loops += 1
    characteristic = vertices - counts["edges"] + len(triangles)
    return {"faces": len(triangles), "euler_characteristic": characteristic, "boundary_loops": loops}
