"""Attribute layers: pools of values, spread over the elements that use them."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

import numpy as np
from numpy.typing import NDArray

# Stands for no value.
_NONE = np.uint32(0xFFFFFFFF)


def by_name(layers: Iterable[dict[str, Any]]) -> dict[str, NDArray[Any]]:
    """An array for each layer. Of several of one name the later ones are called `name#2` and so on."""
    found: dict[str, NDArray[Any]] = {}
    for layer in layers:
        name, number = layer["name"], 1
        while name in found:
            number += 1
            name = f"{layer['name']}#{number}"
        found[name] = spread(layer)
    return found


def spread(layer: dict[str, Any]) -> NDArray[Any]:
    """The value of each element. What has none is NaN, None, or masked in types that have neither."""
    pool, width, uses = _rows(layer["values"]), layer["width"], layer["uses"]
    if width > 1:
        pool = pool.reshape(-1, width)
    if uses is None:
        return _fixed(np.array(pool))
    absent = uses == _NONE
    if not absent.any():
        return _fixed(pool[uses])
    # Any value stands where there is none, and is covered.
    values = pool[np.where(absent, 0, uses)] if len(pool) else np.zeros((len(uses), *pool.shape[1:]), pool.dtype)
    if values.dtype.kind == "f":
        values[absent] = np.nan
    elif values.dtype.kind == "O":
        values[absent] = None
    else:
        mask = np.broadcast_to(absent.reshape(-1, *[1] * (values.ndim - 1)), values.shape)
        values = np.ma.MaskedArray(values, mask=mask)
    return _fixed(values)


def are_same(one: list[dict[str, Any]], other: list[dict[str, Any]]) -> bool:
    """Whether two meshes have the same layers, bit by bit, however they are pooled."""
    from ._mesh import same_bits

    def told(layer: dict[str, Any]) -> tuple[Any, ...]:
        return layer["name"], layer["domain"], layer["width"], layer["role"]

    if [told(layer) for layer in one] != [told(layer) for layer in other]:
        return False
    for layer, its_like in zip(one, other):
        mine, its = spread(layer), spread(its_like)
        if mine.dtype.kind == "O" or its.dtype.kind == "O":
            if mine.shape != its.shape or not all(_is_same(a, b) for a, b in zip(mine.flat, its.flat)):
                return False
        elif not same_bits(np.ma.getdata(mine), np.ma.getdata(its)):
            return False
        elif not np.array_equal(np.ma.getmaskarray(mine), np.ma.getmaskarray(its)):
            return False
    return True


def _is_same(one: Any, other: Any) -> bool:
    if isinstance(one, np.ndarray) and isinstance(other, np.ndarray):
        return one.dtype == other.dtype and one.tobytes() == other.tobytes()
    return bool(one == other)


def _rows(pool: Any) -> NDArray[Any]:
    """A pool as an array: texts and lists as objects."""
    if isinstance(pool, np.ndarray):
        return pool
    if isinstance(pool, tuple):
        starts, items = pool
        lists = [items[begin:end] for begin, end in zip(starts[:-1], starts[1:])]
    else:
        lists = [text.decode("utf-8", "surrogateescape") for text in pool]
    rows = np.empty(len(lists), dtype=object)
    for at, row in enumerate(lists):
        rows[at] = row
    return rows


def _fixed(values: NDArray[Any]) -> NDArray[Any]:
    values.flags.writeable = False
    return values
