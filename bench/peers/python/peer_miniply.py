"""miniply, as pyvista wraps it."""

from importlib.metadata import version as installed

import pyvista_miniply


def version():
    return "miniply (pyvista-miniply " + installed("pyvista-miniply") + ")"


def read(file, scratch):
    yield
    vertices, triangles, *_ = pyvista_miniply.read(file, read_normals=False, read_uv=False, read_color=False)
    yield
    return {"vertices": len(vertices), "faces": len(triangles)}


OPERATIONS = {"read-ply": read, "read-ply-ascii": read}
