"""libigl."""

from importlib.metadata import version as installed

import igl
import numpy as np

from meshes import MANIFOLD, disc_figures, figures, load

JITTER = 0.085


def version():
    return "libigl " + installed("libigl")


def welding(tolerance):
    def weld(file, scratch):
        vertices, triangles = load(file)
        yield
        welded = igl.remove_duplicate_vertices(vertices, triangles, tolerance)
        yield
        return {"vertices": len(welded[0])}

    return weld


def connectivity(file, scratch):
    triangles = load(file)[1]
    yield
    across = igl.triangle_triangle_adjacency(triangles)[0]
    yield
    return {"edges": int((across >= 0).sum() // 2 + (across < 0).sum())}


def orient(file, scratch):
    triangles = load(file)[1]
    yield
    oriented = igl.bfs_orient(triangles)[0]
    yield
    return figures(0, oriented, "faces", "inconsistent_edges")


def split(file, scratch):
    vertices, triangles = load(file)
    yield
    vertices, triangles, _ = igl.split_nonmanifold(vertices, triangles)
    yield
    return figures(len(vertices), triangles, *MANIFOLD)


def cut(file, scratch):
    vertices, triangles = load(file)
    yield
    pairs = [np.array([path[:-1], path[1:]]) for path in map(np.asarray, igl.cut_to_disk(triangles))]
    ends = np.sort(np.concatenate(pairs, axis=1), axis=0)
    keys = ends[0] * len(vertices) + ends[1]
    sides = np.sort(np.stack([triangles, np.roll(triangles, -1, axis=1)]), axis=0)
    is_cut = np.isin(sides[0] * len(vertices) + sides[1], keys)
    open_triangles = igl.cut_mesh(vertices, triangles, is_cut)[1]
    yield
    return disc_figures(open_triangles)


OPERATIONS = {
    "weld": welding(0.0),
    "weld-tolerance": welding(JITTER),
    "connectivity": connectivity,
    "orient": orient,
    "split": split,
    "cut": cut,
}
