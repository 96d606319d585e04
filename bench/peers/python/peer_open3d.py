"""Open3D."""

import numpy as np
import open3d

from meshes import figures, load, stl_counts


def version():
    return "Open3D " + open3d.__version__


def mesh_of(file):
    vertices, triangles = load(file)
    mesh = open3d.geometry.TriangleMesh()
    mesh.vertices = open3d.utility.Vector3dVector(vertices)
    mesh.triangles = open3d.utility.Vector3iVector(triangles.astype(np.int32))
    return mesh


def counts(mesh):
    return {"vertices": len(mesh.vertices), "faces": len(mesh.triangles)}


def weld(file, scratch):
    mesh = mesh_of(file)
    yield
    mesh.remove_duplicated_vertices()
    yield
    return {"vertices": len(mesh.vertices)}


def clean(file, scratch):
    mesh = mesh_of(file)
    yield
    mesh.remove_duplicated_triangles()
    mesh.remove_degenerate_triangles()
    mesh.remove_unreferenced_vertices()
    yield
    return counts(mesh)


def orient(file, scratch):
    mesh = mesh_of(file)
    yield
    mesh.orient_triangles()
    yield
    return figures(len(mesh.vertices), np.asarray(mesh.triangles), "faces", "inconsistent_edges")


def read(file, scratch):
    yield
    mesh = open3d.io.read_triangle_mesh(file)
    yield
    return counts(mesh)


def writing(extension):
    def write(file, scratch):
        mesh, path = mesh_of(file), f"{scratch}/open3d.{extension}"
        if extension == "stl":
            # It writes no STL file without them.
            mesh.compute_triangle_normals()
        yield
        open3d.io.write_triangle_mesh(path, mesh)
        yield
        return stl_counts(path) if extension == "stl" else counts(open3d.io.read_triangle_mesh(path))

    return write


OPERATIONS = {
    "weld": weld,
    "orient": orient,
    "clean": clean,
    "read-ply": read,
    "read-ply-ascii": read,
    "read-obj": read,
    "read-off": read,
    "read-stl": read,
    "write-ply": writing("ply"),
    "write-obj": writing("obj"),
    "write-off": writing("off"),
    "write-stl": writing("stl"),
}
