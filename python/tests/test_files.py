"""Reading and writing: files, bytes, file-likes, losses, and what can go wrong with them."""

import errno
import io
import os
import pickle
import warnings

import meshmend as mm
import numpy as np
import pytest
from conftest import EXAMPLES

OBJ = b"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"


def test_a_mesh_is_read_from_a_path_bytes_and_a_file_like(tmp_path):
    path = tmp_path / "a.obj"
    path.write_bytes(OBJ)
    expected = mm.Mesh(np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0]]), [[0, 1, 2]])
    for source in (path, str(path), io.BytesIO(OBJ), OBJ, memoryview(OBJ), bytearray(OBJ)):
        mesh = mm.read(source, format="obj")
        assert mesh == expected and mesh.format == "obj"
    with path.open("rb") as file:
        assert mm.read(file) == expected
    assert mm.read(OBJ, name="upload.obj") == expected


def test_a_file_like_that_gives_text_or_little_at_a_time():
    class Slow(io.RawIOBase):
        def __init__(self):
            self.rest = OBJ

        def read(self, size=-1):
            piece, self.rest = self.rest[:3], self.rest[3:]
            return piece

    assert len(mm.read(Slow(), format="obj")) == 1
    with pytest.raises(TypeError, match="binary"):
        mm.read(io.StringIO(OBJ.decode()), format="obj")


def test_notes_are_what_the_reader_had_to_say():
    mesh = mm.read(EXAMPLES / "broken.obj")
    assert [note.kind for note in mesh.notes] == [note["kind"] for note in mesh.check().to_dict()["notes"]]
    assert mesh.notes[0].to_dict()["count"] == mesh.notes[0].count == 1


def test_what_the_system_refuses_is_an_os_error(tmp_path):
    missing = tmp_path / "missing.obj"
    with pytest.raises(FileNotFoundError) as caught:
        mm.read(missing)
    assert caught.value.errno == errno.ENOENT and caught.value.filename == str(missing)
    with pytest.raises(IsADirectoryError) as caught:
        mm.read(tmp_path)
    assert caught.value.filename == str(tmp_path)
    with pytest.raises(FileNotFoundError):
        mm.write(mm.read(OBJ, format="obj"), tmp_path / "no" / "such" / "folder.ply")


@pytest.mark.parametrize(
    ("content", "options", "kind", "line"),
    [
        (b"v 0 0 0\nv 1 0 0\nv 0 x 0\n", {"format": "obj"}, "malformed", 3),
        (b"OFF\n3 1 0\n0 0 0\n1 0 0\n", {"format": "off"}, "malformed", None),
        (b"hello, world", {"name": "hello.txt"}, "unknown-format", None),
        (OBJ, {"format": "obj", "max_faces": 0}, "limit", None),
        (OBJ, {"format": "obj", "max_vertices": 2}, "limit", None),
        (OBJ, {"format": "obj", "max_bytes": 10}, "limit", None),
    ],
)
def test_a_file_that_cannot_be_read_says_where_and_why(content, options, kind, line):
    with pytest.raises(mm.ReadError) as caught:
        mm.read(content, **options)
    error = caught.value
    assert error.kind == kind and error.path == options.get("name", "bytes")
    if line is not None:
        assert error.line == line and f"line {line}" in str(error)
    again = pickle.loads(pickle.dumps(error))
    assert (str(again), again.kind, again.line, again.path) == (str(error), error.kind, error.line, error.path)
    assert isinstance(error, ValueError) and isinstance(error, mm.MeshmendError)


def test_a_stream_is_limited_too():
    class Endless:
        name = "endless.obj"

        def read(self, size=-1):
            return b"v 0 0 0\n" * 1000

    with pytest.raises(mm.ReadError, match="limit of 100000") as caught:
        mm.read(Endless(), max_bytes=100_000)
    assert caught.value.kind == "limit"


def test_a_truncated_binary_file_names_the_byte(tetrahedron):
    content = mm.encode(mm.Mesh(*tetrahedron), "ply", encoding="binary")
    with pytest.raises(mm.ReadError) as caught:
        mm.read(content[:-5], name="cut.ply")
    assert caught.value.kind == "malformed" and caught.value.byte is not None


def test_unknown_words_are_told_with_those_that_are_known():
    with pytest.raises(ValueError, match="format can't be `blend`; it can be .*obj.*"):
        mm.read(OBJ, format="blend")
    with pytest.raises(ValueError, match="it can be little-endian, big-endian, ascii"):
        mm.encode(mm.read(OBJ, format="obj"), "ply", encoding="utf-8")
    with pytest.raises(ValueError, match="the name tells no format"):
        mm.write(mm.read(OBJ, format="obj"), "mesh")
    with pytest.raises(TypeError, match="fmt"):
        mm.encode(mm.read(OBJ, format="obj"), "ply", fmt="x")


@pytest.mark.parametrize("format", ["obj", "off", "ply", "stl", "glb"])
def test_what_is_written_is_read_again(tetrahedron, tmp_path, format):
    mesh = mm.Mesh(*tetrahedron)
    path = tmp_path / f"a.{format}"
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", mm.LossWarning)
        mm.write(mesh, path)
        assert path.read_bytes() == mm.encode(mesh, format)
    assert len(mm.read(path)) == 4
    buffer = io.BytesIO()
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", mm.LossWarning)
        mm.write(mesh, buffer, format=format)
    assert buffer.getvalue() == path.read_bytes()


def test_losses_are_returned_and_warned_of_once_at_the_caller(tetrahedron, tmp_path):
    mesh = mm.Mesh(*tetrahedron, vertex_attributes={"heat": np.arange(4.0)})
    with pytest.warns(mm.LossWarning) as caught:
        losses = mm.write(mesh, tmp_path / "a.off")
    assert len(caught) == 1 and caught[0].filename == __file__ and "heat" in str(caught[0].message)
    assert [loss.kind for loss in losses] == ["layer"] and losses[0].to_dict()["count"] == losses[0].count
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        assert mm.write(mesh, tmp_path / "a.ply") == []


def test_strict_writes_nothing_that_is_not_all(tetrahedron, tmp_path):
    mesh = mm.Mesh(*tetrahedron, vertex_attributes={"heat": np.arange(4.0)})
    path = tmp_path / "a.off"
    path.write_text("as before")
    with pytest.raises(mm.LossError) as caught:
        mm.write(mesh, path, strict=True)
    assert path.read_text() == "as before" and caught.value.losses[0].kind == "layer"
    buffer = io.BytesIO()
    with pytest.raises(mm.LossError):
        mm.write(mesh, buffer, format="off", strict=True)
    assert buffer.getvalue() == b""


def test_a_target_that_takes_less_than_all_is_an_error(tetrahedron):
    class Full:
        name = "full.ply"

        def write(self, content):
            return len(content) // 2

    with pytest.raises(OSError, match="full.ply took"):
        mm.write(mm.Mesh(*tetrahedron), Full())


@pytest.mark.skipif(not os.path.exists("/dev/full"), reason="there is no /dev/full here")
def test_a_full_disk_is_an_os_error(tetrahedron):
    with open("/dev/full", "wb", buffering=0) as full, pytest.raises(OSError) as caught:
        mm.write(mm.Mesh(*tetrahedron), full, format="ply")
    assert caught.value.errno == errno.ENOSPC


@pytest.mark.skipif(os.geteuid() == 0, reason="root may write everywhere")
def test_a_folder_that_cannot_be_written_to_is_a_permission_error(tetrahedron, tmp_path):
    tmp_path.chmod(0o500)
    with pytest.raises(PermissionError):
        mm.write(mm.Mesh(*tetrahedron), tmp_path / "a.ply")


def test_a_file_of_parts_goes_in_and_comes_out_whole(tmp_path):
    content = (EXAMPLES / "box.glb").read_bytes()
    document = mm.read_document(EXAMPLES / "box.glb")
    assert document.format == "glb" and [part.name for part in document.parts] == ["Body", "Lid"]
    assert mm.encode(document, "glb") == content
    # A part knows its file: what is written is all of it.
    assert mm.encode(document.parts[1].mesh, "glb") == content
    mm.write(document, tmp_path / "again.glb")
    assert (tmp_path / "again.glb").read_bytes() == content
    assert len(document.mesh("parts")) == sum(len(part.mesh) for part in document.parts)
    with pytest.raises(ValueError, match="place can't be `x`"):
        document.mesh("x")


def test_several_parts_are_no_single_mesh():
    message = r"has 2 parts \(0: Body \(mesh 0\), 1: Lid \(mesh 1\)\); meshmend.read_document gives all"
    with pytest.raises(ValueError, match=message):
        mm.read(EXAMPLES / "box.glb")
    with pytest.raises(ValueError, match=r"read_document\(...\).check\(\) takes all"):
        mm.check(EXAMPLES / "box.glb")
    with pytest.raises(ValueError, match="there is no part `x`; the parts are 0: Body"):
        mm.read_document(EXAMPLES / "box.glb").check(parts=["x"])


def test_what_a_file_holds_beside_the_mesh_is_not_pickled_and_told():
    mesh = mm.read_document(EXAMPLES / "box.glb").parts[0].mesh
    with pytest.warns(mm.LossWarning, match="not pickled"):
        content = pickle.dumps(mesh)
    assert pickle.loads(content) == mesh
