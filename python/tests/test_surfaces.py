"""Closed paths, cuts and shapes."""

import json

import meshmend as mm
import numpy as np
import pytest
from conftest import EXAMPLES
from meshmend import _native


def test_paths_generate_a_surface():
    torus = mm.make("torus", resolution=6)
    found = mm.loops(torus)
    assert [loop.kind for loop in found] == ["handle", "handle"] and len(found.components) == 1
    assert found.components[0].name == "torus" and found.components[0].obstacle is None
    edges = {tuple(sorted(edge)) for edge in torus.edges.tolist()}
    for loop in found:
        path = loop.vertices.tolist()
        assert all(tuple(sorted(pair)) in edges for pair in zip(path, path[1:] + path[:1]))
        length = np.linalg.norm(torus.vertices[path] - torus.vertices[path[1:] + path[:1]], axis=1).sum()
        assert loop.two_sided and loop.length == pytest.approx(length)
    assert mm.loops(torus, hops=True)[0].length == len(mm.loops(torus, hops=True)[0].vertices)
    assert mm.loops(torus, greedy=True).components[0].system_length <= found.components[0].system_length
    assert mm.loops(torus, root=5).components[0].root == 5
    with pytest.raises(ValueError, match="exclude each other"):
        mm.loops(torus, root=1, roots=2)


def test_what_is_no_surface_has_no_paths(book):
    found = mm.loops(book)
    assert len(found) == 0 and "3 sides" in found.components[0].obstacle


@pytest.mark.parametrize("name", ["broken.obj", "moebius.off", "soup.stl"])
def test_the_documents_are_those_of_the_command(command, tmp_path, name):
    path = EXAMPLES / name
    assert mm.loops(path).to_json().encode() + b"\n" == command("loops", "--json", path).stdout
    assert str(mm.loops(path)) + "\n" == command("loops", path).stdout.decode()
    ran = command("cut", "--json", path, "--output", tmp_path / "out.obj")
    if ran.returncode:
        with pytest.raises(mm.RefusedError):
            mm.cut(path)
        return
    printed = json.loads(ran.stdout)
    assert mm.cut(path).to_dict() == {**printed, "output": None, "losses": []}


def test_a_cut_opens_a_surface_into_a_disc():
    torus = mm.make("torus", resolution=6)
    opened = mm.cut(torus)
    check = opened.mesh.check()
    assert check.euler_characteristic == 1 and check.boundary_loops == 1 and len(opened.mesh) == len(torus)
    assert (torus.vertices[opened.vertices.old_of_new] == opened.mesh.vertices).all()
    ends = np.sort(opened.vertices.old_of_new[opened.seams[:, 1]], axis=1)
    assert (ends == np.sort(opened.seams[:, 0], axis=1)).all() and len(opened.seams) > 0
    assert mm.cut(torus, along="generators").mesh.check().euler_characteristic == 1
    with pytest.raises(ValueError, match="along can't be `seam`; it can be cut-graph, generators"):
        mm.cut(torus, along="seam")
    with pytest.raises(mm.RefusedError):
        mm.cut(EXAMPLES / "pinched.ply")


def test_each_shape_is_made():
    for shape in _native.registries()["shapes"]:
        assert len(mm.make(shape)) > 0, shape
    surface = mm.make("surface", genus=2, holes=3, triangles=True).check()
    assert (surface.genus, surface.boundary_loops) == (2, 3)
    assert len(mm.make("cube", refine=1)) == 24
    with pytest.raises(ValueError, match="the shape can't be `cub`; it can be tetrahedron"):
        mm.make("cub")
    with pytest.raises(ValueError, match="genus"):
        mm.make("cube", genus=1)
