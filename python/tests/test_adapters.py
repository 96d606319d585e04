"""Meshes of other libraries, in and out: what both can hold is the same after a round trip, and the rest is told."""

import subprocess
import sys
import types
import warnings

import meshmend as mm
import numpy as np
import pytest


def library(name):
    return pytest.importorskip(name, reason=f"{name} is not installed")


@pytest.fixture
def coloured(tetrahedron):
    """Triangles with attributes of vertices and of faces."""
    vertices, faces = tetrahedron
    rng = np.random.default_rng(4)
    vertex = {"heat": rng.random(4), "color": rng.integers(0, 255, (4, 4), dtype=np.uint8)}
    return mm.Mesh(vertices, faces, vertex_attributes=vertex, face_attributes={"label": np.arange(4, dtype=np.int32)})


@pytest.fixture
def polygons():
    """A quad, triangles, and a pentagon, with attributes."""
    vertices = np.random.default_rng(5).random((8, 3))
    faces = [[0, 1, 2, 3], [0, 1, 4], [1, 2, 4], [3, 4, 5, 6, 7]]
    return mm.Mesh(vertices, faces, vertex_attributes={"heat": np.arange(8.0)}, face_attributes={"label": np.arange(4.0)})


def assert_same(one, other, attributes=True):
    assert (one.vertices == other.vertices).all()
    assert one.corners.tolist() == other.corners.tolist() and one.offsets.tolist() == other.offsets.tolist()
    assert (one.loose_edges == other.loose_edges).all() and (one.loose_points == other.loose_points).all()
    for mine, theirs in ((one.vertex_attributes, other.vertex_attributes), (one.face_attributes, other.face_attributes)):
        assert mine.keys() == theirs.keys() or not attributes
        for name in mine.keys() & theirs.keys():
            assert (mine[name] == theirs[name]).all(), name


@pytest.fixture
def no_losses():
    """What is lost fails the test."""
    with warnings.catch_warnings():
        warnings.simplefilter("error", mm.LossWarning)
        yield


def test_trimesh_and_back(coloured, no_losses):
    library("trimesh")
    there = coloured.to_trimesh()
    assert there.vertices.shape == (4, 3) and (there.visual.vertex_colors == coloured.vertex_attributes["color"]).all()
    assert_same(mm.Mesh.of(there), coloured)


def test_trimesh_merges_nothing():
    library("trimesh")
    vertices = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 0], [1, 0, 0], [0, 1, 0], [9, 9, 9]], dtype=float)
    mesh = mm.Mesh(vertices, [[0, 1, 2], [3, 4, 5], [3, 4, 5]])
    there = mesh.to_trimesh()
    assert len(there.vertices) == 7 and len(there.faces) == 3
    assert_same(mm.Mesh.of(there), mesh)


def test_trimesh_has_triangles_alone(polygons):
    library("trimesh")
    with pytest.raises(ValueError, match="triangulate='all'"):
        polygons.to_trimesh()


def test_texture_coordinates_go_to_trimesh(tetrahedron, no_losses):
    library("trimesh")
    mesh = mm.Mesh(*tetrahedron, vertex_attributes={"texcoord": np.random.default_rng(6).random((4, 2))})
    assert_same(mm.Mesh.of(mesh.to_trimesh()), mesh)


def test_pyvista_and_back(polygons, no_losses):
    library("pyvista")
    there = polygons.to_pyvista()
    assert there.n_cells == 4 and there.point_data["heat"].tolist() == list(range(8))
    assert_same(mm.Mesh.of(there), polygons)


def test_loose_elements_go_to_pyvista_without_attributes_of_faces(tetrahedron):
    library("pyvista")
    mesh = mm.Mesh(*tetrahedron, loose_edges=[[0, 1]], loose_points=[3], face_attributes={"label": np.arange(4)})
    with pytest.warns(mm.LossWarning, match="`label` of faces"):
        there = mesh.to_pyvista()
    assert_same(mm.Mesh.of(there), mesh, attributes=False)


def test_pyvista_lines_are_edges_between_their_points():
    pyvista = library("pyvista")
    there = pyvista.PolyData(np.random.default_rng(7).random((5, 3)), lines=[3, 0, 1, 2, 2, 3, 4])
    assert mm.Mesh.of(there).loose_edges.tolist() == [[0, 1], [1, 2], [3, 4]]


def test_meshio_and_back(polygons, no_losses):
    library("meshio")
    there = polygons.to_meshio()
    assert [block.type for block in there.cells] == ["quad", "triangle", "polygon"]
    assert_same(mm.Mesh.of(there), polygons)


def test_meshio_cells_that_are_no_faces_are_refused():
    meshio = library("meshio")
    with pytest.raises(ValueError, match="`tetra` are no faces"):
        mm.Mesh.of(meshio.Mesh(np.zeros((4, 3)), [("tetra", [[0, 1, 2, 3]])]))


def test_open3d_and_back(tetrahedron, no_losses):
    library("open3d")
    colours = np.random.default_rng(8).random((4, 3))
    mesh = mm.Mesh(*tetrahedron, vertex_attributes={"color": colours})
    for tensor in (False, True):
        back = mm.Mesh.of(mesh.to_open3d(tensor=tensor))
        assert np.allclose(back.vertices, mesh.vertices) and back.corners.tolist() == mesh.corners.tolist()
        assert np.allclose(back.vertex_attributes["color"], colours)


def test_attributes_of_corners_are_told(tetrahedron):
    library("trimesh")
    mesh = mm.Mesh(*tetrahedron, corner_attributes={"texcoord": np.zeros((12, 2))})
    with pytest.warns(mm.LossWarning, match="`texcoord` of corners is left out") as told:
        mesh.to_trimesh()
    assert told[0].filename == __file__


def test_a_library_is_known_by_its_module_and_not_imported():
    """What has the form of an object of pymeshlab or manifold3d is read without them."""

    class Matrices:
        __module__ = "pymeshlab.pmeshlab"

        def vertex_matrix(self):
            return np.eye(3)

        def face_matrix(self):
            return np.array([[0, 1, 2]])

    class Manifold:
        __module__ = "manifold3d"

        def to_mesh(self):
            properties = np.hstack([np.eye(3), np.arange(3.0).reshape(3, 1)])
            return types.SimpleNamespace(vert_properties=properties, tri_verts=np.array([[0, 1, 2]], dtype=np.uint32))

    assert mm.Mesh.of(Matrices()).faces.tolist() == [[0, 1, 2]]
    assert mm.Mesh.of(Manifold()).vertex_attributes["properties"].tolist() == [0.0, 1.0, 2.0]
    with pytest.raises(TypeError, match="int is no mesh: give a pair"):
        mm.check(3)


def test_no_library_is_imported_before_it_is_asked_for():
    peers = "trimesh pyvista vtkmodules open3d meshio tqdm daft pyarrow"
    text = f"import sys, meshmend; print([name for name in {peers.split()} if name in sys.modules])"
    assert subprocess.run([sys.executable, "-c", text], capture_output=True, text=True).stdout.strip() == "[]"
