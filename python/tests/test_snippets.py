"""The fragments of use, each run on inputs that a fixture makes. That of many files on a store is with the fleet's tests."""

import warnings

import meshmend as mm
import numpy as np
import pytest
import snippets


@pytest.fixture
def folder(tmp_path, tetrahedron, book):
    """Files of the names that the fragments use."""
    for name in ("asset.obj", "bunny.ply"):
        mm.Mesh(*tetrahedron).write(tmp_path / name)
    for name in ("broken.stl", "scan.ply"):
        mm.Mesh(*book).write(tmp_path / name)
    (tmp_path / "print.toml").write_text("[orient]\nside = 'outward'\n")
    return tmp_path


def test_1_arrays_in_arrays_out(book):
    V2, F2 = snippets.arrays_in_arrays_out(*book)
    assert V2.dtype == np.float64 and F2.dtype == book[1].dtype and len(V2) == 7


def test_2_a_file_and_the_record(folder, capsys):
    snippets.a_file_and_the_record(folder)
    assert mm.check(folder / "mended.ply").manifold and "non-manifold edges: 1" in capsys.readouterr().out


def test_3_a_gate_in_ci(folder, book):
    snippets.a_gate_in_ci(folder)
    mm.Mesh(*book).write(folder / "asset.obj")
    with pytest.raises(mm.DefectError, match="non-manifold edges: 1"):
        snippets.a_gate_in_ci(folder)


def test_4_where_is_it_wrong(book):
    ends, degree = snippets.where_is_it_wrong(book)
    assert ends.tolist() == [[0, 1]] and degree.tolist() == [3]


def test_5_carry_values_through(book):
    vertices, faces = book
    heat, label = snippets.carry_values_through(vertices, faces, np.arange(5.0), np.array([7, 8, 9]))
    assert heat.tolist() == [0, 1, 2, 3, 4, 0, 1] and label.tolist() == [7, 8, 9]


def test_6_which_vertex_is_this(grid):
    repair = mm.repair(grid(4))
    assert snippets.which_vertex_is_this(repair, 3) == (3, [17])


def test_7_trimesh_in_trimesh_out(book):
    trimesh = pytest.importorskip("trimesh", reason="trimesh is not installed")
    mended = snippets.trimesh_in_trimesh_out(trimesh.Trimesh(*book, process=False))
    assert len(mended.vertices) == 7 and len(mended.faces) == 3


def test_8_polygons_stay_polygons():
    pyvista = pytest.importorskip("pyvista", reason="PyVista is not installed")
    vertices = np.array([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0], [2, 0, 0]], dtype=float)
    mended = snippets.polygons_stay_polygons(pyvista.PolyData(vertices, faces=[4, 0, 1, 2, 3, 3, 1, 4, 2]))
    assert mended.faces.tolist() == [4, 0, 1, 2, 3, 3, 1, 4, 2]


def test_9_quads_and_triangles():
    vertices = np.random.default_rng(1).random((5, 3))
    table = np.array([[0, 1, 2, -1], [0, 2, 3, 4]])
    meshes = snippets.quads_and_triangles(vertices, table, np.array([0, 1, 2, 0, 2, 3, 4]), np.array([0, 3, 7]))
    assert meshes[0] == meshes[1] == meshes[2] and not meshes[0].is_triangles


def test_10_bytes_from_anywhere(tetrahedron):
    content = mm.encode(mm.Mesh(*tetrahedron), "stl")
    assert len(snippets.bytes_from_anywhere(content)) == 4


def test_11_a_bar_that_can_be_stopped(folder, capsys):
    assert snippets.a_bar_that_can_be_stopped(folder).changed


def test_12_policies_as_a_file(folder):
    assert mm.Plan.from_toml(snippets.policies_as_a_file(folder)) == mm.Plan(weld="0.001%", non_orientable="cut")


def test_13_many_files_on_this_machine(folder):
    paths = [folder / "asset.obj", folder / "scan.ply"] * 4
    assert [document["manifold"] for document in snippets.many_files_on_this_machine(paths)] == [True, False] * 4


def test_14_in_a_notebook(folder):
    page = snippets.in_a_notebook(folder)._repr_html_()
    assert "sound" in page and "data:image/png;base64," in page


HOSTILE = '<script>alert("&")</script>.obj'


def test_a_page_escapes_every_name_and_has_nothing_from_elsewhere(tmp_path, book):
    content = mm.encode(mm.Mesh(*book, vertex_attributes={"<b>": np.zeros(5)}), "ply")
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", mm.LossWarning)
        mesh = mm.read(content, name=HOSTILE.replace("/", "") + "x.ply", format="ply")
    pages = [mesh._repr_html_(), mesh.check()._repr_html_(), mesh.repair()._repr_html_()]
    for page in pages:
        assert "<script" not in page and "<b>" not in page and "http" not in page and " src=\"data:" in page
    assert "&lt;script&gt;" in pages[1] and "&lt;b&gt;" in pages[0]
    assert "non-manifold edges" in pages[1] and "what is that?" in pages[1] and ">defect<" in pages[1]
    assert "split" in pages[2] and "non-manifold-edge: 1" in pages[2]


def test_large_meshes_have_no_picture(grid):
    page = mm.Mesh(*grid(320))._repr_html_()
    assert "<img" not in page and "204800" in page
    assert "<img" not in mm.Mesh([[0, 0, 0]])._repr_html_()
