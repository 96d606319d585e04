"""MeshFix, through pymeshfix. It keeps one body and closes what is open, so it answers another question."""

from importlib.metadata import version as installed

import numpy as np
import pymeshfix

from meshes import figures, load


def version():
    return "MeshFix (pymeshfix " + installed("pymeshfix") + ")"


def process(file, scratch):
    yield
    vertices, triangles = pymeshfix.clean_from_arrays(*load(file))
    yield
    names = ["vertices", "faces", "inconsistent_edges", "non_manifold_edges"]
    return figures(len(vertices), np.asarray(triangles), *names)


OPERATIONS = {"process-ply": process}
