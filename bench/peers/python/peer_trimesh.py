"""trimesh."""

import trimesh

from meshes import load

JITTER = 0.085


def version():
    return "trimesh " + trimesh.__version__


def mesh_of(file):
    return trimesh.Trimesh(*load(file), process=False)


def weld(file, scratch):
    mesh = mesh_of(file)
    yield
    mesh.merge_vertices()
    yield
    return {"vertices": len(mesh.vertices)}


def weld_with_tolerance(file, scratch):
    mesh = mesh_of(file)
    yield
    # Whole digits are all that it can round to: one after the point is the least that joins the copies of a vertex.
    mesh.merge_vertices(digits_vertex=1)
    yield
    return {"vertices": len(mesh.vertices)}


def read(file, scratch):
    yield
    mesh = trimesh.load_mesh(file, process=False)
    yield
    return {"vertices": len(mesh.vertices), "faces": len(mesh.faces)}


OPERATIONS = {
    "weld": weld,
    "weld-tolerance": weld_with_tolerance,
    "read-ply": read,
    "read-ply-ascii": read,
    "read-obj": read,
    "read-off": read,
    "read-stl": read,
    "read-stl-ascii": read,
}
