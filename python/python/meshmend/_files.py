"""Reading and writing: files, bytes, and binary file-like objects."""

from __future__ import annotations

import os
import sys
import warnings
from collections.abc import Callable
from typing import Any

from . import _native
from ._document import Document
from ._errors import LossWarning
from ._mesh import Mesh
from ._notes import Loss, losses_of
from ._progress import watched

# A source of unknown size may be endless; as on the command line.
_MOST_OF_A_STREAM = 1 << 30


def read_document(
    source: Any,
    *,
    format: str | None = None,
    name: str | None = None,
    max_bytes: int | None = None,
    max_vertices: int | None = None,
    max_faces: int | None = None,
    threads: int | None = None,
    progress: Any = None,
) -> Document:
    """A file with all its parts, from a path, bytes, or a binary file-like object."""
    path, content = _content(source, name, max_bytes)
    words = {"format": format, "max_bytes": max_bytes, "max_vertices": max_vertices, "max_faces": max_faces}
    with watched(threads, progress) as how:
        return Document._of(_native.read(path, content, words, how))


def read(source: Any, **options: Any) -> Mesh:
    """A mesh from a path, bytes, or a binary file-like object; opens nothing that the file names, but material libraries."""
    return read_document(source, **options)._only("meshmend.read_document gives all")


def write(
    mesh: object,
    target: Any,
    *,
    format: str | None = None,
    encoding: str | None = None,
    strict: bool = False,
    seams: str = "split",
    manifold_extension: bool = False,
    keep_double: bool = False,
    companions: str = "copy",
    threads: int | None = None,
    progress: Any = None,
) -> list[Loss]:
    """Whole or not at all. Losses are returned and warned of; with `strict` they raise and nothing is written."""
    words = write_words(
        format=format,
        encoding=encoding,
        strict=strict,
        seams=seams,
        manifold_extension=manifold_extension,
        keep_double=keep_double,
        companions=companions,
    )
    what = _handle(mesh)
    if not hasattr(target, "write"):
        path = os.fspath(target)
        with watched(threads, progress) as how:
            _, told = _native.write(what, path, words, how)
        return warned(path, losses_of(told))
    called = getattr(target, "name", None)
    words["format"] = format or _suffix(called)
    with watched(threads, progress) as how:
        content, told = _native.write(what, None, words, how)
    taken = target.write(content)
    if taken is not None and taken != len(content):
        raise OSError(f"{called or 'the target'} took {taken} bytes of {len(content)}")
    return warned(str(called or "output"), losses_of(told))


def encode(mesh: object, format: str, **options: Any) -> bytes:
    """The bytes of a file. Losses are warned of; with `strict` they raise."""
    words = write_words(format=format)
    unknown = options.keys() - words.keys()
    if unknown:
        raise TypeError(f"encode() got an unexpected keyword argument '{min(unknown)}'")
    with watched() as how:
        content, told = _native.write(_handle(mesh), None, words | options, how)
    warned(f"output.{format}", losses_of(told))
    return bytes(content)


def write_words(**given: Any) -> dict[str, Any]:
    """How to write, for `_native`."""
    usual = {"seams": "split", "manifold_extension": False, "keep_double": False, "companions": "copy"}
    return {"format": None, "encoding": None, "strict": False, **usual, **given}


def loaded(thing: object, called: Callable[..., Any]) -> Mesh:
    """The mesh of whatever a function takes: a mesh, a path, or what `Mesh.of` takes."""
    if isinstance(thing, Mesh):
        return thing
    if is_file(thing):
        return read_document(thing)._only(f"meshmend.read_document(...).{called.__name__}() takes all")
    return Mesh.of(thing)


def is_file(thing: object) -> bool:
    """Whether it is a path, the bytes of a file, or a file-like object."""
    return isinstance(thing, (str, os.PathLike, bytes, bytearray, memoryview)) or hasattr(thing, "read")


def warned(name: str, losses: list[Loss]) -> list[Loss]:
    """Some losses, of which is warned once, at the line that called meshmend."""
    if losses:
        what = "; ".join(loss.message for loss in losses)
        warnings.warn(LossWarning(f"{name}: {what}", losses), stacklevel=outside())
    return losses


def outside() -> int:
    """How far up the caller is that is not meshmend."""
    frame, level = sys._getframe(1), 1
    while frame.f_back is not None and frame.f_globals.get("__name__", "").partition(".")[0] == "meshmend":
        frame, level = frame.f_back, level + 1
    return level


def _handle(mesh: object) -> Any:
    if isinstance(mesh, Document):
        return mesh._handle
    return loaded(mesh, write)._handle


def _content(source: Any, name: str | None, max_bytes: int | None) -> tuple[str, bytes | None]:
    """A path, or the name and the bytes of a file."""
    if isinstance(source, (bytes, bytearray, memoryview)):
        return name or "bytes", bytes(source)
    if not hasattr(source, "read"):
        path = os.fspath(source)
        return (path if isinstance(path, str) else os.fsdecode(path)), None
    called = getattr(source, "name", None)
    return name or (called if isinstance(called, str) else "stream"), _all_of(source, max_bytes)


def _all_of(source: Any, max_bytes: int | None) -> bytes:
    """The bytes of a stream to its end, or one more than allowed: the reader then says so."""
    room = (_MOST_OF_A_STREAM if max_bytes is None else max_bytes) + 1
    pieces: list[bytes] = []
    while room > 0:
        piece = source.read(min(room, 1 << 20))
        if isinstance(piece, str):
            raise TypeError("the file-like object gives text: open it as a binary file")
        if not piece:
            break
        pieces.append(bytes(piece))
        room -= len(piece)
    return b"".join(pieces)


def _suffix(name: object) -> str | None:
    """The format that the name of a file-like object tells."""
    return (os.path.splitext(name)[1][1:].lower() or None) if isinstance(name, str) else None
