"""Mending: arrays in and out, which elements are which, plans and policies, and what is refused."""

import copy
import os
import pickle
import re
import sys
import warnings

import meshmend as mm
import numpy as np
import pytest
from conftest import EXAMPLES, SHARED
from hypothesis import given, settings
from hypothesis import strategies as st
from meshmend import _native


def test_arrays_come_out_in_the_types_that_came_in(book):
    vertices, faces = book
    for floats in (np.float32, np.float64, ">f4"):
        for integers in (np.uint8, np.int16, np.int64, np.uint64):
            points, mended = mm.mend(vertices.astype(floats), faces.astype(integers))
            assert points.dtype == np.dtype(floats) and mended.dtype == np.dtype(integers)
            assert points.shape == (7, 3) and mended.shape == (3, 3)
    points, (corners, offsets) = mm.mend(vertices, (faces.ravel(), np.array([0, 3, 6, 9], dtype=np.int16)))
    assert corners.dtype == faces.dtype and offsets.dtype == np.int16 and offsets.tolist() == [0, 3, 6, 9]
    points, mended = mm.mend([[0, 0, 0], [1, 0, 0], [0, 1, 0]], [[0, 1, 2], [0, 1, 2]])
    assert points.dtype == np.array([0]).dtype and mended.tolist() == [[0, 1, 2]] and mended.dtype == np.int32
    assert mm.mend(vertices, faces, split="off")[0].shape == (5, 3)


@pytest.mark.parametrize("size", [3, 4])
@pytest.mark.parametrize("integers", [np.int32, np.int64, np.uint32])
def test_arrays_that_come_out_are_those_of_who_asked(size, integers):
    vertices, rows = np.eye(4, 3), np.arange(size, dtype=integers).reshape(1, size)
    given = vertices.copy(), rows.copy()
    for faces in (rows, (rows.ravel(), np.array([0, size], dtype=integers))):
        points, mended = mm.mend(vertices, faces)
        for array in (points, *(mended if isinstance(mended, tuple) else [mended])):
            array[...] = 0
        assert np.array_equal(vertices, given[0]) and np.array_equal(rows, given[1])


def test_created_vertices_are_rounded_with_a_warning():
    # A pentagon whose only triangulation without a new vertex would repeat an edge that is there already.
    spots = np.random.default_rng(3).random((12, 3)).astype(np.float32)
    faces = [[0, 1, 2, 3], [0, 2, 4], [1, 3, 5], [0, 2, 6], [1, 3, 7]]
    with warnings.catch_warnings(record=True) as told:
        warnings.simplefilter("always")
        mended = mm.repair((spots[:8], faces), triangulate="all")
        points, table = mm.mend(spots[:8], faces, triangulate="all")
    created = mended.vertices.created
    kept = np.setdiff1d(np.arange(len(points)), created)
    assert (points[kept] == mended.mesh.vertices[kept]).all() and points.dtype == np.float32
    assert len(created) > 0
    losses = [loss for warning in told for loss in warning.message.losses]
    assert [loss.kind for loss in losses] == ["precision"] and 0 < losses[0].count <= len(created)
    assert {warning.filename for warning in told} == {__file__}


def test_a_record_says_which_elements_are_which(book):
    vertices, faces = book
    mended = mm.repair((vertices, np.vstack([faces, [[0, 0, 1]]])))
    assert mended.changed and mended.vertices.all_new_of(0).tolist() == [0, 5]
    assert mended.vertices.pairs.tolist() == [[0, 0], [0, 5], [1, 1], [1, 6], [2, 2], [3, 3], [4, 4]]
    assert mended.vertices.new_of_old.tolist() == [0, 1, 2, 3, 4] and mended.vertices.created.tolist() == []
    assert mended.faces.removed.tolist() == [3] == mended.removed_faces.faces.tolist()
    assert (mended.removed_faces.passes, mended.removed_faces.reasons) == (("clean",), ("degenerate-face",))
    assert mended.faces.carry(["a", "b", "c", "d"]).tolist() == ["a", "b", "c"]
    assert mended.vertices.carry(np.arange(10.0).reshape(5, 2))[5].tolist() == [0.0, 1.0]
    assert mended.corners.old_of_new.tolist() == list(range(9))
    passes = {record.name: record for record in mended.passes}
    assert passes["clean"].mended["degenerate-face"].faces.tolist() == [3] and not passes["weld"].changed
    assert passes["split"].delta == {"euler_characteristic": 1, "components": 1, "boundary_loops": None}
    assert not mended.before.manifold and mended.after.manifold
    with pytest.raises(ValueError, match="read-only"):
        mended.vertices.pairs[0, 0] = 1
    with pytest.raises(IndexError, match="no vertex 5"):
        mended.vertices.all_new_of(5)
    with pytest.raises(ValueError, match="3 values: there were 4"):
        mended.faces.carry([1, 2, 3])


def test_what_was_created_needs_a_value():
    # Four triangles round a hole that is filled.
    vertices = [[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0], [0.5, 0.5, 1]]
    mended = mm.repair((vertices, [[0, 1, 4], [1, 2, 4], [2, 3, 4], [3, 0, 4]]), fill="all", fill_rims=True)
    assert mended.faces.created.tolist() == [4, 5] and mended.after.closed
    assert np.isnan(mended.faces.carry([0.0, 1.0, 2.0, 3.0])[4:]).all()
    assert mended.faces.carry([0, 1, 2, 3], fill=-1).tolist() == [0, 1, 2, 3, -1, -1]
    with pytest.raises(ValueError, match="say `fill`"):
        mended.faces.carry([0, 1, 2, 3])


def test_welded_vertices_are_all_in_the_pairs():
    mended = mm.repair(EXAMPLES / "soup.stl")
    before = mm.read(EXAMPLES / "soup.stl")
    pairs = mended.vertices.pairs
    assert len(pairs) == len(before.vertices) and len(np.unique(pairs[:, 0])) == len(before.vertices)
    assert (before.vertices[pairs[:, 0]] == mended.mesh.vertices[pairs[:, 1]]).all()
    assert len(mended.vertices.removed) == 0 and len(mended.mesh.vertices) < len(before.vertices)


def test_flipped_faces_are_named(tetrahedron):
    vertices, faces = tetrahedron
    faces = faces.copy()
    faces[2] = faces[2][::-1]
    mended = mm.repair((vertices, faces))
    assert mended.flipped.tolist() == [2] and mended.after.consistently_oriented and mended.changed
    assert not mm.repair(mended.mesh).changed


def test_plans_are_the_text_of_the_command():
    plan = mm.Plan(weld="0.001%", non_orientable="cut")
    assert mm.Plan.from_toml(plan.to_toml()) == plan != mm.Plan()
    assert pickle.loads(pickle.dumps(plan)) == plan and copy.copy(plan) == plan
    assert plan.passes == ("weld", "clean", "orient", "split", "triangulate", "compact", "verify")
    assert mm.Plan("weld", "compact").passes == ("weld", "compact")
    assert mm.Plan(clean=False).passes == mm.Plan(clean="off").passes
    assert mm.Plan(fill="edges:3", fill_rims=True) != mm.Plan(fill="edges:3", fill_rims=False) == mm.Plan(fill="edges:3")
    assert mm.Plan(weld=0.5) == mm.Plan(weld="0.5") and mm.Plan(weld=False).passes == mm.Plan(weld="none").passes


def test_a_plan_and_keywords_go_together(tmp_path, book):
    file = tmp_path / "print.toml"
    file.write_text(mm.Plan(split="cut").to_toml())
    by_file, by_plan = mm.repair(book, plan=file), mm.repair(book, plan=mm.Plan(split="cut"))
    assert by_file.to_json() == by_plan.to_json() == mm.repair(book, split="cut").to_json()
    assert mm.repair(book, plan=file, split="off").to_json() == mm.repair(book, split="off").to_json()
    with pytest.raises(FileNotFoundError):
        mm.repair(book, plan=tmp_path / "none.toml")


def test_a_preset_is_a_plan(book):
    assert mm.Plan.preset("print", "[weld]\ndistance = 'exact'") != mm.Plan.preset("print") != mm.Plan()
    with pytest.raises(ValueError, match="preset can't be `prints`; it can be asset, print"):
        mm.Plan.preset("prints")
    with pytest.raises(ValueError, match="a whole plan leaves nothing of a preset"):
        mm.repair(book, plan=mm.Plan(), preset="print")


def test_a_bad_line_of_a_plan_is_named():
    with pytest.raises(mm.PlanError, match="distnace") as caught:
        mm.Plan.from_toml("[weld]\ndistnace = 'exact'\n")
    assert caught.value.line == 2 and isinstance(caught.value, ValueError)
    with pytest.raises(mm.PlanError, match="`heal` needs `orient`"):
        mm.Plan("weld", "heal")
    with pytest.raises(ValueError, match="a pass can't be `mend`; it can be weld"):
        mm.Plan("mend")


@pytest.mark.parametrize("words, error, match", [
    ({"spilt": "cut"}, TypeError, "unexpected keyword argument 'spilt'; did you mean `split`"),
    ({"non-finite": "drop"}, TypeError, "unexpected keyword argument 'non-finite'; did you mean `non_finite`"),
    ({"split": "cuts"}, ValueError, "it can be|expected sheets, cut, pinch-only, off"),
    ({"split": True}, ValueError, "split can't be True; it can be sheets, cut, pinch-only, off"),
    ({"split": 3}, TypeError, "split is a int: it is a word"),
    ({"weld": [1]}, TypeError, "weld is a list: it is a word or a number"),
    ({"weld": -1}, ValueError, "weld can't be `-1.0`"),
    ({"weld": float("nan")}, ValueError, "weld can't be `nan`"),
    ({"clean": False, "non_finite": "fail"}, ValueError, "non-finite has no meaning when clean is off"),
    ({"kernel": "quad"}, ValueError, "the kernel of a repair can't be `quad`; it can be edge-use"),
    ({"geometry": "colour"}, ValueError, "geometry can't be `colour`"),
    ({"heal": "exact", "orient": "off"}, mm.PlanError, "`heal` needs `orient`"),
    ({"by": "colour"}, ValueError, "are about a file"),
    ({"threads": 0}, ValueError, "between 1 and 1024"),
])
def test_words_that_mean_nothing_are_refused(book, words, error, match):
    with pytest.raises(error, match=match):
        mm.repair(book, **words)


def test_what_a_policy_refuses_has_the_defects():
    vertices = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [np.nan, 0, 0]]
    with pytest.raises(mm.RefusedError) as caught:
        mm.repair((vertices, [[0, 1, 2], [0, 1, 3]]), non_finite="fail")
    assert caught.value.defects["non-finite-face"].faces.tolist() == [1] and caught.value.kernel is None
    with pytest.raises(mm.RefusedError) as caught:
        mm.repair(EXAMPLES / "moebius.off", non_orientable="fail")
    assert "moebius.off" in str(caught.value) and "non-orientable-patch" in caught.value.defects
    with pytest.raises(mm.RefusedError, match="would remove"):
        mm.repair((vertices, [[0, 0, 0]]))
    assert len(mm.repair((vertices, [[0, 0, 0]]), allow_empty=True).mesh) == 0


def test_a_strict_kernel_refuses_what_it_can_not_hold(book):
    with pytest.raises(mm.RefusedError, match="half-edge") as caught:
        mm.repair(book, kernel="half-edge", split="off")
    assert caught.value.kernel == "half-edge" and len(caught.value.defects["non-manifold-edge"]) == 1
    again = pickle.loads(pickle.dumps(caught.value))
    assert str(again) == str(caught.value) and again.kernel == "half-edge"
    assert again.defects["non-manifold-edge"].vertices.tolist() == [[0, 1]]
    assert list(again.defects["non-manifold-edge"]) == list(caught.value.defects["non-manifold-edge"])


def test_every_option_of_the_command_is_a_keyword(command):
    known = {name.replace("-", "_") for name in _native.registries()["options"]}
    others = {"plan", "preset", "allow_empty", "kernel", "geometry", "near", "pair_budget", "by", "fail_on", "strict", "output"}
    shown = command("repair", "--help").stdout.decode()
    told = {word.replace("-", "_") for word in re.findall(r"--([a-z][a-z-]*[a-z])", shown)}
    # What is about files and reports is an argument of `read`, `write` and `to_json`.
    files = {"dry_run", "report", "json", "sarif", "quiet", "no_report", "format", "max_bytes", "max_vertices", "max_faces",
             "part", "from", "to", "encoding", "seams", "manifold_extension", "keep_double", "companions", "report_maps", "maps", "limit",
             "help", "threads", "color", "progress", "no_progress", "version", "verbose"}
    policies = told - files - others
    assert known <= told, known - told
    assert policies <= known, policies - known


def test_a_repair_is_written_where_it_came_from(tmp_path):
    out = tmp_path / "out.glb"
    source = EXAMPLES / "box.glb"
    mended = mm.repair(source)
    mended.write(out)
    assert len(mm.read_document(out).parts) == len(mm.read_document(source).parts)


def test_a_file_without_meshes_is_written_as_it_is(tmp_path):
    file = tmp_path / "none.gltf"
    file.write_text('{"asset": {"version": "2.0"}}')
    mm.repair(file).write(tmp_path / "out.gltf")
    assert len(mm.read_document(tmp_path / "out.gltf").parts) == 0


def _parts(tmp_path):
    file = tmp_path / "two.obj"
    file.write_text("o good\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\no bad\nv 0 0 1\nv 1 0 1\nv 0 1 1\nf 4 5 6\nf 4 5 6\n")
    return file


def test_parts_are_repaired_each_by_itself(tmp_path):
    mended = mm.repair(_parts(tmp_path), by="object")
    assert [part.split()[0] for part in mended.parts] == ["good", "bad"]
    good, bad = mended.parts.values()
    assert (good.changed, bad.changed, mended.changed) == (False, True, True)
    assert bad.removed_faces.faces.tolist() == [1] and bad.to_dict()["removed_faces"]["count"] == 1
    assert [part["changed"] for part in mended.to_dict()["parts"]] == [False, True]
    with pytest.raises(ValueError, match="ask one of `parts`"):
        mended.mesh  # noqa: B018
    mended.write(tmp_path / "out.obj")
    assert len(mm.read(tmp_path / "out.obj")) == 2
    one = mm.read_document(_parts(tmp_path)).repair(by="object", parts=["bad"])
    assert len(one.parts) == 1 and len(one.mesh) == 1
    with pytest.raises(ValueError, match="there is no part `worse`"):
        mm.repair(_parts(tmp_path), by="object", parts=["worse"])


def test_a_report_can_be_left_out(book):
    mended = mm.repair(book, report=False)
    assert mended.before is None and mended.after is None and mended.changed
    assert mended.to_dict()["after"] is None and len(mended.mesh.vertices) == 7


def test_a_gate_tells_what_is_left_and_strictly_raises(command, book):
    path = EXAMPLES / "moebius.off"
    words = ["non-orientable-patch", "changed", "removed", "left"]
    mended = mm.repair(path, fail_on=words)
    ran = command("repair", "--json", "--dry-run", "--fail-on", ",".join(words), path)
    assert ran.returncode == 1 and mended.to_json().encode() + b"\n" == ran.stdout
    assert mended.failing["non-orientable-patch"] == 1 and "removed" not in mended.failing
    assert mm.repair(book, fail_on=["changed", "non-manifold-edge"], report=False).failing == {"changed": 1}
    assert mm.repair(book, fail_on=["changed"]).to_dict()["failing"]
    with pytest.raises(mm.DefectError, match="the repair has changed: 1") as caught:
        mm.repair(book, fail_on=["changed"], strict=True)
    assert caught.value.check.manifold
    assert mm.repair(book, fail_on=["non-manifold-edge"], strict=True).failing == {}
    with pytest.raises(ValueError, match="`write` tells what is lost"):
        mm.repair(book, fail_on=["loss"])
    with pytest.raises(ValueError, match="colour"):
        mm.repair(book, fail_on=["colour"])


def test_what_is_raised_stops_a_repair(grid):
    class Enough(Exception):
        pass

    def stop(step, done, total):
        raise Enough(step)

    with pytest.raises(Enough):
        mm.repair(grid(200), progress=stop)
    told = []
    mm.repair(grid(200), progress=lambda *step: told.append(step[0]))
    assert "weld" in told, told


@st.composite
def soups(draw):
    count = draw(st.integers(3, 12))
    coordinate = st.sampled_from([0.0, 0.25, 0.5, 1.0, -1.0, 1e-3])
    vertices = draw(st.lists(st.tuples(coordinate, coordinate, coordinate), min_size=count, max_size=count))
    corner = st.integers(0, count - 1)
    faces = draw(st.lists(st.tuples(corner, corner, corner), min_size=1, max_size=16))
    return np.array(vertices), np.array(faces)


# What the referee calls clean, but for sides: those of a one-sided surface clash, and a report says where.
_PROMISED = ("finite", "indices_in_range", "face_degree", "no_repeated_vertices", "no_repeated_faces", "no_unreferenced",
             "edge_manifold", "vertex_manifold")


def _referee():
    """The checks that know nothing of this package."""
    tools = SHARED / "tools"
    if not (tools / "check_repaired.py").is_file():
        pytest.skip("there is no ../shared/tools/check_repaired.py here")
    if str(tools) not in sys.path:
        sys.path.insert(0, str(tools))
    import check_repaired

    return check_repaired


@settings(
    max_examples=int(os.environ.get("MESHMEND_EXAMPLES", "60")),
    deadline=None,
    # The same in each run, but where more are asked for.
    derandomize="MESHMEND_EXAMPLES" not in os.environ,
)
@given(soups())
def test_mended_arrays_are_what_they_are_to_be(soup):
    vertices, faces = soup
    try:
        mended = mm.repair(soup)
    except mm.RefusedError as refused:
        assert "would remove" in str(refused)
        return
    points, table = mm.mend(vertices, faces)
    assert (points == mended.mesh.vertices).all() and (table == mended.mesh.faces).all()
    found = _referee().check(points, np.arange(0, table.size + 1, 3), table.ravel())
    _, holds, examples = found
    wrong = [name for name in _PROMISED if not holds[name]]
    assert not wrong and (holds["oriented"] or not holds["orientable"]), (wrong, examples)
    assert not mm.repair((points, table)).changed
    pairs = mended.vertices.pairs
    assert (vertices[pairs[:, 0]] == points[pairs[:, 1]]).all()
    removed = set(mended.removed_faces.faces.tolist())
    assert removed == set(mended.faces.removed.tolist())
    assert set(range(len(faces))) - removed == set(mended.faces.old_of_new[mended.faces.old_of_new >= 0].tolist())
