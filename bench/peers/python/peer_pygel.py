"""GEL, through PyGEL3D."""

from importlib.metadata import version as installed

from pygel3d import hmesh

from meshes import load


def version():
    return "GEL (PyGEL3D " + installed("pygel3d") + ")"


def connectivity(file, scratch):
    vertices, triangles = load(file)
    yield
    mesh = hmesh.Manifold.from_triangles(vertices, triangles)
    yield
    return {"edges": mesh.no_allocated_halfedges() // 2}


OPERATIONS = {"connectivity": connectivity}
