"""Arrays in and out: what is accepted, and how what is wrong is named."""

import copy
import pickle
import threading

import meshmend as mm
import numpy as np
import pytest


def test_arrays_come_out_as_they_went_in(tetrahedron):
    vertices, faces = tetrahedron
    mesh = mm.Mesh(vertices, faces)
    assert mesh.vertices.dtype == np.float64 and np.array_equal(mesh.vertices, vertices)
    assert mesh.faces.dtype == np.int32 and np.array_equal(mesh.faces, faces)
    assert np.array_equal(mesh.offsets, [0, 3, 6, 9, 12]) and len(mesh) == 4 and mesh.is_triangles
    assert np.array_equal(mesh.edges, [[0, 1], [0, 2], [0, 3], [1, 2], [1, 3], [2, 3]])
    assert mesh.notes == () and mesh.format is None


def test_arrays_that_come_out_are_made_once_and_cannot_be_written(tetrahedron):
    mesh = mm.Mesh(*tetrahedron, vertex_attributes={"heat": np.arange(4.0)})
    for name in ("vertices", "faces", "corners", "offsets", "edges", "loose_edges", "loose_points"):
        array = getattr(mesh, name)
        assert getattr(mesh, name) is array
        with pytest.raises(ValueError, match="read-only"):
            array[...] = 0
    with pytest.raises(ValueError, match="read-only"):
        mesh.vertex_attributes["heat"][0] = 1


def test_an_array_that_another_thread_changes_is_read_once(grid):
    vertices, faces = grid(150)
    faces = faces.copy()
    stop = threading.Event()

    def change():
        while not stop.is_set():
            faces[-1, 0], faces[-1, 1] = faces[-1, 1], faces[-1, 0]

    other = threading.Thread(target=change)
    other.start()
    try:
        for _ in range(20):
            mesh = mm.Mesh(vertices, faces)
            assert mesh.corners.max() < len(vertices) and mm.check(mesh).to_json() == mm.check(mesh).to_json()
    finally:
        stop.set()
        other.join()


def test_the_mesh_is_a_copy(tetrahedron):
    vertices, faces = tetrahedron
    mesh = mm.Mesh(vertices, faces)
    before = vertices.copy()
    vertices[:] = 7
    faces[:] = 0
    assert np.array_equal(mesh.vertices, before) and mesh.faces.max() == 3


@pytest.mark.parametrize("dtype", ["i1", "u1", "i2", "u2", "i4", "u4", "i8", "u8", ">i4", ">u8"])
def test_each_type_of_whole_numbers_is_taken(tetrahedron, dtype):
    vertices, faces = tetrahedron
    assert mm.Mesh(vertices, faces.astype(dtype)) == mm.Mesh(vertices, faces)


@pytest.mark.parametrize("dtype", ["f2", "f4", "f8", ">f4", "i4", "u8"])
def test_each_type_of_numbers_is_taken_for_positions(tetrahedron, dtype):
    vertices, faces = tetrahedron
    assert mm.Mesh(vertices.astype(dtype), faces) == mm.Mesh(vertices, faces)


def test_layouts_of_memory_do_not_matter(tetrahedron):
    vertices, faces = tetrahedron
    expected = mm.Mesh(vertices, faces)
    fixed = vertices.copy(), faces.copy()
    for array in fixed:
        array.flags.writeable = False
    wide = np.zeros((4, 6)), np.zeros((8, 3), dtype=np.int64)
    wide[0][:, ::2], wide[1][::2] = vertices, faces
    odd = [np.frombuffer(b"?" + array.tobytes(), dtype=array.dtype, offset=1).reshape(-1, 3) for array in (vertices, faces)]
    assert not any(array.flags.aligned for array in odd)
    for points, rows in [
        fixed,
        odd,
        (np.asfortranarray(vertices), np.asfortranarray(faces)),
        (wide[0][:, ::2], wide[1][::2]),
        (vertices.tolist(), faces.tolist()),
        ([tuple(point) for point in vertices.tolist()], [tuple(face) for face in faces.tolist()]),
    ]:
        assert mm.Mesh(points, rows) == expected


def test_faces_of_any_size_are_lists_or_padded_or_flat():
    vertices = np.arange(15.0).reshape(5, 3)
    lists = mm.Mesh(vertices, [[0, 1, 2], [0, 2, 3, 4]])
    padded = mm.Mesh(vertices, np.array([[0, 1, 2, -1], [0, 2, 3, 4]]), pad=-1)
    flat = mm.Mesh(vertices, (np.array([0, 1, 2, 0, 2, 3, 4]), np.array([0, 3, 7])))
    plain = mm.Mesh(vertices, ([0, 1, 2, 0, 2, 3, 4], [0, 3, 7]))
    assert lists == padded == flat == plain and not lists.is_triangles
    assert np.array_equal(lists.corners, [0, 1, 2, 0, 2, 3, 4]) and np.array_equal(lists.offsets, [0, 3, 7])
    with pytest.raises(ValueError, match="different sizes"):
        lists.faces  # noqa: B018
    quads = mm.Mesh(vertices, [[0, 1, 2, 3]])
    assert quads.faces.shape == (1, 4)


def test_empty_arrays_are_empty_meshes():
    for vertices in ([], np.zeros((0, 3))):
        for faces in ([], (), np.zeros((0, 3), dtype=int), np.zeros((0, 4), dtype=np.int32)):
            mesh = mm.Mesh(vertices, faces)
            assert len(mesh) == 0 and mesh.vertices.shape == (0, 3) and mesh.faces.shape == (0, 3)
    assert bool(mm.Mesh([], []))


def test_not_a_number_and_infinity_are_positions(tetrahedron):
    vertices, faces = tetrahedron
    vertices[1, 0], vertices[2, 1] = np.nan, np.inf
    mesh = mm.Mesh(vertices, faces)
    assert np.isnan(mesh.vertices[1, 0]) and mesh.check().counts()["non-finite-vertex"] == 2


@pytest.mark.parametrize(
    ("faces", "message"),
    [
        ([[-1, 1, 2]], r"faces\[0, 0\] = -1 is no vertex: there are 4"),
        ([[0, 1, 2], [0, 1, 4]], r"faces\[1, 2\] = 4 is no vertex: there are 4"),
        (np.array([[0, 2**32, 1]]), r"faces\[0, 1\] = 4294967296 is no vertex: there are 4"),
        (np.array([[0, 1, 2**64 - 1]], dtype=np.uint64), r"faces\[0, 2\] = 18446744073709551615 is no vertex"),
        ([[0, 1, 2], [0, 1, 2, 9]], r"faces\[1, 3\] = 9 is no vertex: there are 4"),
        ((np.array([0, 1, 7]), np.array([0, 3])), r"corners\[2\] = 7 is no vertex: there are 4"),
    ],
)
def test_an_index_that_is_no_vertex_is_named_by_its_place(tetrahedron, faces, message):
    with pytest.raises(IndexError, match=message):
        mm.Mesh(tetrahedron[0], faces)


@pytest.mark.parametrize(
    ("faces", "message"),
    [
        (np.zeros((2, 3)), "whole numbers"),
        (np.zeros((2, 3), dtype=bool), "whole numbers"),
        (np.array([[0, 1, None]], dtype=object), "whole numbers"),
        ([["0", "1", "2"]], "whole numbers"),
        ([[0, 1, 2], [0, 1.5, 2, 3]], "whole numbers"),
    ],
)
def test_faces_that_are_no_whole_numbers_are_a_type_error(tetrahedron, faces, message):
    with pytest.raises(TypeError, match=message):
        mm.Mesh(tetrahedron[0], faces)


@pytest.mark.parametrize(
    ("faces", "message"),
    [
        (np.array([0, 1, 2]), r"faces has the shape \(3,\)"),
        (np.zeros((1, 3, 1), dtype=int), "faces has the shape"),
        ((np.array([0, 1, 2]), np.array([0, 2, 1, 3])), r"offsets\[2\] = 1 is less than 2 before it"),
        ((np.array([0, 1, 2]), np.array([0, 4])), "offsets ends with 4: there are 3 corners"),
        ((np.array([0, 1, 2]), np.array([1, 3])), "offsets begins with 0"),
        ((np.array([0, 1, 2]), np.array([], dtype=int)), "offsets begins with 0"),
        (((0, 1, 2), (0, 2, 3)), "give two faces as a list"),
    ],
)
def test_faces_of_a_wrong_form_are_a_value_error(tetrahedron, faces, message):
    with pytest.raises(ValueError, match=message):
        mm.Mesh(tetrahedron[0], faces)


def test_a_pad_in_the_middle_of_a_row_is_named(tetrahedron):
    with pytest.raises(ValueError, match=r"faces\[1, 1\] = -1 ends the row, and faces\[1, 2\] = 2"):
        mm.Mesh(tetrahedron[0], np.array([[0, 1, 2, -1], [0, -1, 2, 3]]), pad=-1)
    with pytest.raises(IndexError, match=r"faces\[0, 2\] = -2 is no vertex"):
        mm.Mesh(tetrahedron[0], np.array([[0, 1, -2, -1]]), pad=-1)


@pytest.mark.parametrize("vertices", [np.zeros((4, 2)), np.zeros(12), [[0, 0, 0], [1, 1]], np.zeros((2, 2, 3))])
def test_positions_of_a_wrong_form_are_a_value_error(vertices):
    with pytest.raises(ValueError, match="vertices has"):
        mm.Mesh(vertices, [])


@pytest.mark.parametrize("vertices", [np.zeros((4, 3), dtype=complex), np.zeros((4, 3), dtype=bool), [["a", "b", "c"]]])
def test_positions_that_are_no_numbers_are_a_type_error(vertices):
    with pytest.raises(TypeError, match="vertices has the type"):
        mm.Mesh(vertices, [])


def test_whole_numbers_that_a_double_cannot_hold_are_refused():
    with pytest.raises(ValueError, match="exactly"):
        mm.Mesh(np.array([[2**53 + 1, 0, 0]]), [])


def test_more_corners_than_a_mesh_holds_are_refused_before_room_is_made():
    many = np.broadcast_to(np.int32(0), (2**30, 3))
    with pytest.raises(ValueError, match="fewer than 2147483648"):
        mm.Mesh(np.zeros((1, 3)), many)
    with pytest.raises(ValueError, match="fewer than 2147483648"):
        mm.Mesh(np.broadcast_to(0.0, (2**31, 3)), [])


def test_loose_elements_come_out_again():
    mesh = mm.Mesh(np.eye(3), [], loose_edges=[[2, 0]], loose_points=[1])
    assert np.array_equal(mesh.loose_edges, [[2, 0]]) and np.array_equal(mesh.loose_points, [1])
    with pytest.raises(IndexError, match=r"loose_edges\[0, 1\] = 3"):
        mm.Mesh(np.eye(3), [], loose_edges=[[0, 3]])
    with pytest.raises(IndexError, match=r"loose_points\[0\] = -1"):
        mm.Mesh(np.eye(3), [], loose_points=[-1])


def test_attributes_keep_their_types(tetrahedron):
    given = {
        "heat": np.linspace(0, 1, 4, dtype=np.float32),
        "id": np.array([3, 1, 2, 2**31 - 1], dtype=np.int64),
        "mask": np.array([True, False, True, False]),
        "color": np.arange(12, dtype=np.uint8).reshape(4, 3),
        "name": ["a", "b", "ä", "a"],
    }
    mesh = mm.Mesh(*tetrahedron, vertex_attributes=given, face_attributes={"label": [1, 2, 3, 4]})
    found = mesh.vertex_attributes
    assert list(found) == list(given)
    types = ["float32", "int32", "uint8", "uint8", "object"]
    assert [found[name].dtype.name for name in given] == types
    for name, values in given.items():
        assert np.array_equal(found[name], values)
    assert mesh.face_attributes["label"].tolist() == [1, 2, 3, 4] and not mesh.corner_attributes


@pytest.mark.parametrize(
    ("values", "error", "message"),
    [
        (np.arange(3.0), ValueError, r"vertex_attributes\['heat'\] has 3 values: there are 4 vertices"),
        (1.0, ValueError, "has one value"),
        (np.zeros((4, 2, 2)), ValueError, "shape"),
        (np.array([0, 1, 2, 2**40]), ValueError, "beyond 32 bits"),
        (np.array([{}, {}, {}, {}]), TypeError, "objects"),
        (np.zeros(4, dtype=complex), TypeError, "complex128"),
    ],
)
def test_attributes_that_do_not_fit_are_named(tetrahedron, values, error, message):
    with pytest.raises(error, match=message):
        mm.Mesh(*tetrahedron, vertex_attributes={"heat": values})


def test_equality_is_bit_by_bit(tetrahedron):
    vertices, faces = tetrahedron
    mesh = mm.Mesh(vertices, faces, vertex_attributes={"heat": [0.0, np.nan, 1.0, 2.0]})
    assert mesh == mm.Mesh(vertices, faces, vertex_attributes={"heat": [0.0, np.nan, 1.0, 2.0]})
    assert mesh != mm.Mesh(vertices, faces, vertex_attributes={"heat": [-0.0, np.nan, 1.0, 2.0]})
    assert mesh != mm.Mesh(vertices, faces) and mesh != 1
    minus = vertices.copy()
    minus[0, 0] = -0.0
    assert mm.Mesh(vertices, faces) != mm.Mesh(minus, faces)
    assert copy.copy(mesh) is mesh and copy.deepcopy(mesh) is mesh
    with pytest.raises(TypeError, match="unhashable"):
        hash(mesh)


def test_a_mesh_is_pickled_with_its_buffers_beside_it(grid):
    vertices, faces = grid(100)
    labels = {"label": np.arange(len(faces)), "name": ["x"] * len(faces)}
    mesh = mm.Mesh(vertices, faces, face_attributes=labels, loose_points=[0])
    assert pickle.loads(pickle.dumps(mesh)) == mesh
    buffers = []
    small = pickle.dumps(mm.Mesh(vertices, faces), protocol=5, buffer_callback=buffers.append)
    assert len(small) < 2000 and sum(len(buffer.raw()) for buffer in buffers) > vertices.nbytes
    assert pickle.loads(small, buffers=buffers) == mm.Mesh(vertices, faces)


def test_the_repr_says_how_large_it_is(tetrahedron):
    assert repr(mm.Mesh(*tetrahedron)) == "<Mesh: 4 vertices, 4 faces>"
