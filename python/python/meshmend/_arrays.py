"""Arrays that come in, each looked at, and copied by the core: what is wrong is named by row and column."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from itertools import chain
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

# A mesh holds fewer elements of each kind than this.
MOST = 2**31

# The types of numbers in which a layer keeps its values.
_STORED = {np.dtype(name) for name in ("i1", "u1", "i2", "u2", "i4", "u4", "f4", "f8")}


def points(values: ArrayLike) -> NDArray[np.float64]:
    """Positions as rows of three numbers."""
    given = _numbers("vertices", values)
    if given.size == 0 and given.ndim == 1:
        return np.zeros((0, 3))
    if given.ndim != 2 or given.shape[1] != 3:
        raise ValueError(f"vertices has the shape {given.shape}: it has a row of three numbers for each vertex, (n, 3)")
    if len(given) >= MOST:
        raise ValueError(f"vertices has {len(given)} rows: a mesh holds fewer than {MOST}")
    if given.dtype.kind in "iu" and given.size and max(int(given.max()), -int(given.min())) > 2**53:
        raise ValueError("vertices has whole numbers beyond 2**53, which a double can't hold exactly")
    return np.require(given, np.float64, "CA")


def faces(values: Any, vertices: int, pad: int | None) -> tuple[NDArray[Any], NDArray[np.uint32] | None]:
    """Faces as the vertices of all corners, and where each face begins; None for rows of three.

    In rows of one size they are looked at by the core alone, as it copies them.
    """
    if isinstance(values, tuple) and len(values) == 2 and pad is None:
        return _flat(values, vertices)
    if not isinstance(values, np.ndarray) and _is_ragged(values):
        return _lists(values, vertices)
    given = _whole("faces", values)
    if given.size == 0 and given.ndim == 1:
        given = given.reshape(0, 3)
    if given.ndim != 2:
        raise ValueError(f"faces has the shape {given.shape}: it has a row of vertices for each face, (m, k)")
    if pad is not None:
        return _padded(np.array(given), vertices, pad)
    starts = None if given.shape[1] == 3 else np.arange(len(given) + 1, dtype=np.uint32) * np.uint32(given.shape[1])
    held = given.dtype.newbyteorder("=") if given.dtype.itemsize >= 4 else np.dtype(np.int32)
    return np.require(given, held, "CA"), starts


def pairs(name: str, values: ArrayLike | None, vertices: int) -> NDArray[np.uint32]:
    """Edges as rows of two vertices."""
    given = _indices(name, [] if values is None else values)
    if given.size == 0:
        return np.zeros((0, 2), dtype=np.uint32)
    if given.ndim != 2 or given.shape[1] != 2:
        raise ValueError(f"{name} has the shape {given.shape}: it has a row of two vertices for each edge, (e, 2)")
    checked(given, vertices, name)
    return np.ascontiguousarray(given, dtype=np.uint32)


def singles(name: str, values: ArrayLike | None, vertices: int) -> NDArray[np.uint32]:
    """A vertex each."""
    given = _indices(name, [] if values is None else values)
    if given.ndim != 1:
        raise ValueError(f"{name} has the shape {given.shape}: it has one vertex each, (p,)")
    checked(given, vertices, name)
    return np.ascontiguousarray(given, dtype=np.uint32)


def checked(given: NDArray[Any], count: int, name: str) -> None:
    """IndexError where a number is that of no vertex."""
    if given.size == 0 or (given.min() >= 0 and given.max() < count):
        return
    outside = np.argwhere((given < 0) | (given >= count))[0]
    place = ", ".join(str(number) for number in outside)
    raise IndexError(f"{name}[{place}] = {given[tuple(outside)]} is no vertex: there are {count}")


def layers(domain: str, attributes: Mapping[str, ArrayLike] | None, count: int) -> list[dict[str, Any]]:
    """Layers of values, one for each element of a domain."""
    what = f"{domain}_attributes"
    return [_layer(f"{what}[{name!r}]", str(name), domain, values, count) for name, values in (attributes or {}).items()]


def _layer(what: str, name: str, domain: str, values: ArrayLike, count: int) -> dict[str, Any]:
    given = np.asarray(values)
    elements = {"vertex": "vertices", "face": "faces", "corner": "corners"}[domain]
    if given.ndim == 0 or len(given) != count:
        have = "one value" if given.ndim == 0 else f"{len(given)} values"
        raise ValueError(f"{what} has {have}: there are {count} {elements}")
    if given.ndim > 2:
        raise ValueError(f"{what} has the shape {given.shape}: it has a value or a row of values for each element")
    width = given.shape[1] if given.ndim == 2 else 1
    if width == 0:
        raise ValueError(f"{what} has rows without a value")
    pool = _pool(what, given.reshape(-1))
    is_fraction = isinstance(pool, np.ndarray) and pool.dtype.kind == "f"
    return {
        "name": name,
        "domain": domain,
        "home": domain,
        "width": width,
        "carry": "interpolate" if is_fraction else "copy",
        "role": name if name in ("normal", "tangent", "texcoord", "color") else "plain",
        "is_normalized": False,
        "stored_vertices": count if domain == "vertex" else 0,
        "values": pool,
        "uses": None,
        "vertex_uses": None,
    }


def _pool(what: str, given: NDArray[Any]) -> NDArray[Any] | list[bytes]:
    """Values in a type that a layer has, each unchanged."""
    if given.dtype.kind in "OUS":
        texts = given.tolist()
        if not all(isinstance(text, (str, bytes)) for text in texts):
            raise TypeError(f"{what} has objects: a layer has numbers or texts")
        return [text if isinstance(text, bytes) else text.encode("utf-8", "surrogateescape") for text in texts]
    if given.dtype.kind == "b":
        return np.array(given, dtype=np.uint8)
    native = given.astype(given.dtype.newbyteorder("="))
    if native.dtype in _STORED:
        return np.array(native)
    if native.dtype == np.float16:
        return native.astype(np.float32)
    for smaller in (np.int32, np.uint32):
        if native.dtype.kind in "iu" and _fits(native, np.iinfo(smaller)):
            return native.astype(smaller)
    if native.dtype.kind in "iu":
        raise ValueError(f"{what} has whole numbers beyond 32 bits, which a layer does not keep")
    raise TypeError(f"{what} has the type {given.dtype}: a layer has whole numbers, fractions of up to 64 bits, or texts")


def _fits(given: NDArray[Any], info: np.iinfo[Any]) -> bool:
    return given.size == 0 or bool(given.min() >= info.min and given.max() <= info.max)


def _numbers(name: str, values: ArrayLike) -> NDArray[Any]:
    try:
        given = np.asarray(values)
    except ValueError as error:
        raise ValueError(f"{name} has rows of different length") from error
    is_number = given.dtype.kind in "iu" or (given.dtype.kind == "f" and given.dtype.itemsize <= 8)
    if not is_number:
        raise TypeError(f"{name} has the type {given.dtype}: it has numbers of up to 64 bits")
    return given


def _indices(name: str, values: ArrayLike) -> NDArray[Any]:
    """A copy of whole numbers: another thread can't change it any more."""
    return np.array(_whole(name, values), order="C", copy=True)


def _whole(name: str, values: ArrayLike) -> NDArray[Any]:
    given = np.asarray(values)
    if given.size >= MOST:
        raise ValueError(f"{name} has {given.size} corners: a mesh holds fewer than {MOST}")
    if given.size == 0 and given.dtype == np.float64 and not isinstance(values, np.ndarray):
        return np.zeros(given.shape, dtype=np.int64)
    if given.dtype.kind not in "iu":
        raise TypeError(f"{name} has the type {given.dtype}: it has whole numbers, each that of a vertex")
    return given


def _is_ragged(values: Any) -> bool:
    if not isinstance(values, Sequence):
        return False
    rows = list(values)
    if not rows or not all(isinstance(row, (Sequence, np.ndarray)) for row in rows):
        return False
    return len({len(row) for row in rows}) > 1


def _lists(values: Sequence[Sequence[int]], vertices: int) -> tuple[NDArray[np.uint32], NDArray[np.uint32]]:
    """Faces of different size, a list each."""
    lengths = np.fromiter((len(row) for row in values), dtype=np.int64, count=len(values))
    starts = np.concatenate([[0], np.cumsum(lengths)])
    if starts[-1] >= MOST:
        raise ValueError(f"faces has {starts[-1]} corners: a mesh holds fewer than {MOST}")
    given = _indices("faces", list(chain.from_iterable(values)))
    if given.ndim != 1:
        raise ValueError("faces has rows within rows: it has a list of vertices for each face")
    _checked_in_rows(given, starts, vertices)
    return given.astype(np.uint32), starts.astype(np.uint32)


def _flat(values: tuple[Any, Any], vertices: int) -> tuple[NDArray[np.uint32], NDArray[np.uint32]]:
    """The corners of all faces, and where each face begins."""
    _refuse_two_faces(values)
    corners, starts = _indices("corners", values[0]), _indices("offsets", values[1])
    for name, given in (("corners", corners), ("offsets", starts)):
        if given.ndim != 1:
            raise ValueError(f"{name} has the shape {given.shape}: a pair (corners, offsets) has two rows of numbers")
    if len(starts) == 0 or starts[0] != 0:
        raise ValueError("offsets begins with 0: where the first face begins; its last number is that of all corners")
    falls = np.flatnonzero(starts[1:] < starts[:-1])
    if len(falls):
        at = int(falls[0])
        raise ValueError(f"offsets[{at + 1}] = {starts[at + 1]} is less than {starts[at]} before it")
    if int(starts[-1]) != len(corners):
        raise ValueError(f"offsets ends with {starts[-1]}: there are {len(corners)} corners")
    checked(corners, vertices, "corners")
    return corners.astype(np.uint32), starts.astype(np.uint32)


def _refuse_two_faces(values: tuple[Any, Any]) -> None:
    """A tuple of two tuples may be meant as two faces."""
    one, other = values
    if isinstance(one, np.ndarray) or isinstance(other, np.ndarray):
        return
    if isinstance(one, Sequence) and isinstance(other, Sequence) and len(one) == len(other):
        raise ValueError("faces is a tuple of two: give two faces as a list, or (corners, offsets) as arrays")


def _padded(given: NDArray[Any], vertices: int, pad: int) -> tuple[NDArray[np.uint32], NDArray[np.uint32]]:
    """Faces in rows that end where the first `pad` stands."""
    is_corner = given != pad
    late = np.argwhere(is_corner[:, 1:] & ~is_corner[:, :-1])
    if len(late):
        row, column = (int(number) for number in late[0])
        raise ValueError(f"faces[{row}, {column}] = {pad} ends the row, and faces[{row}, {column + 1}] = {given[row, column + 1]}")
    outside = is_corner & ((given < 0) | (given >= vertices))
    if outside.any():
        row, column = (int(number) for number in np.argwhere(outside)[0])
        raise IndexError(f"faces[{row}, {column}] = {given[row, column]} is no vertex: there are {vertices}")
    starts = np.concatenate([[0], np.cumsum(is_corner.sum(axis=1))])
    return given[is_corner].astype(np.uint32), starts.astype(np.uint32)


def _checked_in_rows(given: NDArray[Any], starts: NDArray[Any], vertices: int) -> None:
    outside = np.flatnonzero((given < 0) | (given >= vertices))
    if len(outside):
        at = int(outside[0])
        row = int(np.searchsorted(starts, at, side="right")) - 1
        raise IndexError(f"faces[{row}, {at - int(starts[row])}] = {given[at]} is no vertex: there are {vertices}")
