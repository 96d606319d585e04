"""A check: its figures, its defects as columns, and its documents, which are the command's."""

import json
import pickle

import meshmend as mm
import numpy as np
import pytest
from conftest import EXAMPLES, corpus

FILES = sorted(path for path in EXAMPLES.iterdir() if path.suffix in {".obj", ".off", ".ply", ".stl", ".glb"})


def test_every_key_of_the_document_is_an_attribute(book):
    check = mm.check(book, geometry=True)
    document = check.to_dict()
    converted = {"betti", "defects", "kernels", "notes", "undefined", "geometry"}
    for key in document.keys() - converted:
        assert getattr(check, key) == document[key], key
    assert check.betti.z2 == tuple(document["betti"]["z2"])
    assert check.geometry["loops"] is not None
    assert check.undefined == {row["figure"]: row["reason"] for row in document["undefined"]}
    assert check.kernels["half-edge"] and not check.kernels["edge-use"]
    assert mm.check(book).geometry is None
    with pytest.raises(AttributeError):
        check.colour  # noqa: B018


def test_defects_are_columns(book):
    edges = mm.check(book).defects["non-manifold-edge"]
    assert len(edges) == 1 and edges.severity == "defect" and edges.title == "non-manifold edges"
    assert edges.vertices.dtype == np.int32 and edges.vertices.tolist() == [[0, 1]]
    assert edges.data["degree"].tolist() == [3] and "sides" in edges.explanation
    check = mm.check(book)
    assert check.mesh.edges[edges.edges].tolist() == edges.vertices.tolist()
    assert mm.check(book).defects["boundary-edge"].vertices.shape == (6, 2)
    assert check.counts() == {"boundary-edge": 6, "non-manifold-edge": 1, "singular-vertex": 2}
    assert len(check.defects["pinched-vertex"]) == 0 and check.defects["pinched-vertex"].vertices.shape == (0,)


def test_defects_are_the_items_of_the_document():
    check = mm.check(EXAMPLES / "broken.obj", geometry=True)
    for group in check.to_dict(limit=None)["defects"]:
        defects = check.defects[group["kind"]]
        assert list(defects) == group["items"] and len(defects) == group["count"]
        for name, column in defects.data.items():
            assert len(column) == len(defects), name


def test_other_columns(tetrahedron):
    vertices, faces = tetrahedron
    check = mm.check((np.vstack([vertices, vertices[:1]]), np.vstack([faces, faces[:1]])))
    again = check.defects["duplicate-face"]
    assert again.faces.tolist() == [4] and again.data["beside"].tolist() == [0]
    same = check.defects["coincident-vertex"]
    assert same.vertices.tolist() == [4] and same.data["beside"].tolist() == [0]
    with pytest.raises(ValueError, match="read-only"):
        again.faces[0] = 1
    strip = mm.check(EXAMPLES / "moebius.off").defects["non-orientable-patch"]
    assert len(strip.strips) == 1 and strip.strips[0].dtype == np.int32 and len(strip.strips[0]) > 2
    pinched = mm.check(EXAMPLES / "pinched.ply").defects["pinched-vertex"]
    assert pinched.data["umbrellas"].tolist() == [2] and pinched.data["boundary_only"].dtype == bool


def test_in_a_welded_view_ids_are_those_that_are_stored():
    check = mm.check(EXAMPLES / "soup.stl")
    assert check.view == "welded" and check.stored["vertices"] > check.vertices == len(check.mesh.vertices)
    assert mm.check(EXAMPLES / "soup.stl", view="indexed").view == "indexed"
    assert mm.check(EXAMPLES / "broken.obj", weld="exact").view == "welded"
    assert mm.check(EXAMPLES / "broken.obj", weld=0.5).weld == {"absolute": 0.5}
    with pytest.raises(ValueError, match="weld has no meaning"):
        mm.check(EXAMPLES / "broken.obj", view="indexed", weld=0.5)


def test_a_kind_that_was_not_looked_for_has_no_answer(book):
    check = mm.check(book)
    with pytest.raises(KeyError, match="ask for it by `geometry=True`"):
        check.defects["sliver-face"]
    with pytest.raises(KeyError, match="did you mean `boundary-edge`"):
        check.defects["boundary-edges"]
    assert "sliver-face" not in check.defects and "sliver-face" in mm.check(book, geometry="shape").defects
    assert "crossing-faces" not in mm.check(book, geometry=["shape"]).defects
    assert "sliver-face" in mm.check(book, fail_on=["sliver-face"]).defects


def test_a_check_is_neither_true_nor_false(book, tetrahedron):
    with pytest.raises(TypeError, match="is_sound"):
        bool(mm.check(book))
    assert mm.check(tetrahedron).is_sound and not mm.check(book).is_sound
    with pytest.raises(TypeError, match="meshmend.check"):
        mm.Check()


def test_require_raises_what_is_wrong(book, tetrahedron):
    check = mm.check(tetrahedron)
    assert check.require("non-manifold-edge", "boundary-edge", closed=True, genus=0) is check
    with pytest.raises(mm.DefectError, match="non-manifold edges: 1, the first: e0 v0-v1 has 3 sides") as caught:
        mm.check(book).require("non-manifold-edge", closed=True)
    assert "closed is False, not True" in str(caught.value) and isinstance(caught.value, AssertionError)
    assert caught.value.check.counts()["non-manifold-edge"] == 1
    with pytest.raises(TypeError, match="no figure `closd`; did you mean `closed`"):
        check.require(closd=True)
    with pytest.raises(KeyError, match="non-manifold-edge"):
        check.require("non-manifold-edges")


def test_unknown_words_are_told_with_those_that_are_known(book):
    for options, message in [
        ({"kernel": "edge"}, "kernel can't be `edge`; it can be edge-use, "),
        ({"witness": "long"}, "witness can't be `long`; it can be breadth-first, shortest"),
        ({"view": "flat"}, "view can't be `flat`; it can be indexed, welded"),
        ({"weld": "near"}, "weld can't be `near`: expected none, exact"),
        ({"geometry": "all"}, "geometry can't be `all`; it can be crossings, t-junctions"),
        ({"geometry": True, "near": "single"}, "near can be exact, a length or a percentage"),
        ({"fail_on": ["hole"]}, "can't be `hole`; it can be degenerate-face"),
        ({"threads": 0}, "threads = 0: it is between 1 and 1024"),
    ]:
        with pytest.raises(ValueError, match=message):
            mm.check(book, **options)
    with pytest.raises(TypeError, match="threads"):
        mm.check(book, threads="two")


def test_a_kernel_that_cannot_hold_the_mesh_says_why(book):
    with pytest.raises(mm.RefusedError, match="half-edge kernel can't hold") as caught:
        mm.check(book, kernel="half-edge")
    assert caught.value.kernel == "half-edge" and len(caught.value.defects["non-manifold-edge"]) == 1
    assert str(pickle.loads(pickle.dumps(mm.PlanError("line 3: x")))) == "line 3: x"


@pytest.mark.parametrize("path", FILES, ids=lambda path: path.name)
@pytest.mark.parametrize("options", [{}, {"geometry": True}, {"weld": "exact"}, {"limit": 1}])
def test_the_document_is_that_of_the_command(command, path, options):
    assert_same_document(command, path, options)


@pytest.mark.parametrize("path", corpus(), ids=lambda path: "/".join(path.parts[-2:]))
def test_the_document_of_a_corpus_file_is_that_of_the_command(command, path):
    assert_same_document(command, path, {})


def assert_same_document(command, path, options):
    words = ["--weld", options["weld"]] if "weld" in options else []
    words += ["--geometry"] if options.get("geometry") else []
    limit = options.get("limit", 10)
    ran = command("check", "--json", "--limit", limit, *words, path)
    try:
        document = mm.read_document(path)
    except (mm.ReadError, ValueError) as error:
        assert ran.returncode == 3 and isinstance(error, mm.ReadError)
        return
    options = {name: value for name, value in options.items() if name != "limit"}
    if ran.returncode == 5:
        with pytest.raises(mm.RefusedError):
            document.check(**options)
        return
    assert ran.returncode in (0, 1), ran.stderr
    found = document.check(**options)
    assert found.to_json(limit).encode() + b"\n" == ran.stdout
    assert found.to_dict(limit) == json.loads(ran.stdout)


def test_a_file_of_one_mesh_gives_the_same_alone():
    path = EXAMPLES / "broken.obj"
    assert mm.check(path).to_json() == mm.read_document(path).check().to_json() == mm.read(path).check().to_json()


def test_a_document_is_checked_part_by_part():
    checked = mm.read_document(EXAMPLES / "box.glb").check()
    assert list(checked) == ["Body (mesh 0)", "Lid (mesh 1)"] and len(checked) == 2
    assert checked.is_sound == all(check.is_sound for check in checked.values())
    one = mm.read_document(EXAMPLES / "box.glb").check(parts=["Lid"])
    assert list(one) == ["Lid (mesh 1)"] and one.to_json() == mm.read_document(EXAMPLES / "box.glb").parts[1].mesh.check().to_json()
    with pytest.raises(TypeError, match="is_sound"):
        bool(checked)
    assert "Body (mesh 0)" in str(checked)


def test_the_text_is_what_the_command_prints(command):
    for path in FILES:
        if path.suffix != ".glb":
            assert str(mm.check(path)) + "\n" == command("check", path).stdout.decode()


def test_a_page_is_explained(command):
    assert mm.explain("pinched-vertex") == command("explain", "pinched-vertex").stdout.decode()
    with pytest.raises(ValueError, match="there is no kind of defect, pass, kernel, law or word `x`"):
        mm.explain("x")
