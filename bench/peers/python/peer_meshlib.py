"""MeshLib."""

from importlib.metadata import version as installed

import meshlib.mrmeshnumpy as arrays
import meshlib.mrmeshpy as meshlib
import numpy as np

from meshes import MANIFOLD, figures, load, stl_counts


def version():
    return "MeshLib " + installed("meshlib")


def mesh_of(vertices, triangles, is_splitting=False):
    return arrays.meshFromFacesVerts(triangles, vertices, duplicateNonManifoldVertices=is_splitting)


def single(file):
    vertices, triangles = load(file)
    return vertices.astype(np.float32), triangles.astype(np.int32)


def counts(mesh):
    return {"vertices": mesh.topology.numValidVerts(), "faces": mesh.topology.numValidFaces()}


def connectivity(file, scratch):
    vertices, triangles = single(file)
    yield
    mesh = mesh_of(vertices, triangles)
    yield
    return {"edges": mesh.topology.computeNotLoneUndirectedEdges()}


def split(file, scratch):
    vertices, triangles = single(file)
    yield
    mesh = mesh_of(vertices, triangles, is_splitting=True)
    yield
    return figures(mesh.topology.numValidVerts(), arrays.getNumpyFaces(mesh.topology), *MANIFOLD)


def generators(file, scratch):
    mesh = mesh_of(*single(file))
    yield
    loops = meshlib.detectBasisTunnels(mesh)
    yield
    return {"generators": len(loops)}


def reading(file, scratch):
    yield
    mesh = meshlib.loadMesh(file)
    yield
    return counts(mesh)


def intersections(file, scratch):
    mesh = mesh_of(*single(file))
    yield
    found = meshlib.findSelfCollidingTrianglesBS(mesh)
    yield
    return {"crossing_faces": found.count()}


def fill(file, scratch):
    mesh = mesh_of(*single(file))
    yield
    for edge in mesh.topology.findHoleRepresentiveEdges():
        parameters = meshlib.FillHoleParams()
        parameters.metric = meshlib.getUniversalMetric(mesh)
        meshlib.fillHole(mesh, edge, parameters)
    yield
    return figures(0, arrays.getNumpyFaces(mesh.topology), "boundary_edges", "non_manifold_edges")


def writing(extension):
    def write(file, scratch):
        mesh, path = mesh_of(*single(file)), f"{scratch}/meshlib.{extension}"
        yield
        meshlib.saveMesh(mesh, path)
        yield
        return stl_counts(path) if extension == "stl" else counts(meshlib.loadMesh(path))

    return write


OPERATIONS = {
    "connectivity": connectivity,
    "split": split,
    "generators": generators,
    "intersections": intersections,
    "intersections-crossed": intersections,
    "fill-12": fill,
    "fill-32": fill,
    "read-ply": reading,
    "read-ply-ascii": reading,
    "read-obj": reading,
    "read-off": reading,
    "read-stl-welded": reading,
    "write-ply": writing("ply"),
    "write-obj": writing("obj"),
    "write-off": writing("off"),
    "write-stl": writing("stl"),
}
