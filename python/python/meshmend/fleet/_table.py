"""Rows as tables: their columns, parts of at most ten thousand, and what is read back."""

from __future__ import annotations

import io
import json
import os
import time
from collections import Counter
from collections.abc import Iterable, Iterator
from typing import Any

import pyarrow as pa
import pyarrow.compute as pc
import pyarrow.parquet as pq

from .._child import Row
from ._store import files_below, is_local, plain, put, within

ROWS_OF_A_PART = 10_000
_HASH, _TIME, _COUNT, _TEXT = pa.binary(32), pa.timestamp("ns", tz="UTC"), pa.int64(), pa.string()
_FIGURES = pa.struct(
    [(name, _COUNT) for name in (
        "vertices edges faces components boundary_edges non_manifold_edges pinched singular inconsistent_edges "
        "degenerate_faces euler boundary_loops genus cross_caps").split()]
    + [(name, pa.bool_()) for name in "manifold closed orientable consistently_oriented".split()]
)
SCHEMA = pa.schema({
    **dict.fromkeys(("path", "output"), _TEXT), "size": _COUNT, "etag": _TEXT, "mtime": _TIME,
    **dict.fromkeys(("input_sha256", "output_sha256"), _HASH), **dict.fromkeys(("plan_digest", "version"), _TEXT),
    "schema": pa.int32(), "status": _TEXT, "signal": pa.int32(), "message": _TEXT, "line": _COUNT, "byte": _COUNT,
    "attempts": pa.int32(), "seconds": pa.float64(), "cpu_seconds": pa.float64(), "peak_bytes": _COUNT,
    **dict.fromkeys(("host", "format_in", "format_out"), _TEXT), "before": _FIGURES, "after": _FIGURES,
    "defects": pa.map_(_TEXT, _COUNT), "changed": pa.bool_(),
    **dict.fromkeys(("removed_faces", "flipped_faces", "created_vertices", "welded_vertices"), _COUNT),
    "losses": pa.list_(pa.struct([("kind", _TEXT), ("count", _COUNT)])), "report": _TEXT,
})


def kept(batches: Iterable[list[Row]], table: str, io_config: Any) -> Iterator[list[Row]]:
    """Rows as they come, on their way into a folder. Those that wait are lost if the process is killed, and are done again."""
    waiting: list[Row] = []
    begin = last = time.monotonic()
    try:
        for rows in batches:
            waiting += rows
            now = time.monotonic()
            # A kill costs a second and a twentieth of the time so far, and yet there are few parts, however long it takes.
            if len(waiting) >= ROWS_OF_A_PART or now - last > 1 + (now - begin) / 20:
                put_parts(table, arrow(waiting), io_config)
                waiting, last = [], now
            yield rows
    finally:
        put_parts(table, arrow(waiting), io_config)


def arrow(rows: list[Row]) -> pa.Table:
    """Rows of workers, or of a ledger, as a table."""
    def column(field: pa.Field) -> pa.Array:
        values = [row.get(field.name) for row in rows]
        if field.type == _HASH:
            values = [value and bytes.fromhex(value) for value in values]
        # A time is a text in a ledger, and so many nanoseconds in a row of the fleet.
        return pa.array(values).cast(_TIME) if field.type == _TIME else pa.array(values, field.type)

    return pa.table([column(field) for field in SCHEMA], SCHEMA)


def put_parts(table: str, rows: pa.Table, io_config: Any) -> None:
    """More parts, whose names come after those of all before."""
    for begin in range(0, rows.num_rows, ROWS_OF_A_PART):
        pq.write_table(rows.slice(begin, ROWS_OF_A_PART), part := io.BytesIO(), compression="zstd")
        part.seek(0)
        put(f"{plain(table).rstrip('/')}/{time.time_ns():020}-{os.urandom(4).hex()}.parquet", part, io_config)


def _parts(table: str, io_config: Any) -> list[str]:
    return sorted(file.path for file in files_below(plain(table), io_config) if file.path.endswith(".parquet"))


def read_table(table: str, io_config: Any = None) -> pa.Table:
    """The rows of a folder of parts, of one, or of a ledger of `meshmend batch`: one a path, the last there is."""
    table = plain(table)
    if is_local(table) and os.path.isfile(table) and not table.endswith(".parquet"):
        with open(table, "rb") as file:  # Whose last line is torn, if its writer was killed.
            rows = arrow([json.loads(line) for line in file if line.endswith(b"\n")])
    else:
        places = [within(part, io_config) for part in ([table] if table.endswith(".parquet") else _parts(table, io_config))]
        rows = pa.concat_tables([SCHEMA.empty_table(), *(pq.read_table(path, filesystem=system, schema=SCHEMA) for system, path in places)])
    last = {path: at for at, path in enumerate(rows["path"].to_pylist())}
    return rows.take(pa.array(sorted(last.values()), pa.int64()))


def compact(table: str, io_config: Any = None) -> pa.Table:
    """Writes a folder of parts anew, without rows that others replace; gives the rows."""
    old, rows = _parts(table, io_config), read_table(table, io_config)
    put_parts(table, rows, io_config)
    for part in old:
        system, path = within(part, io_config)
        system.delete_file(path)
    return rows


def summary(table: str, io_config: Any = None) -> Row:
    """How many files there are, how they ended, what was wrong with them, and what it took."""
    rows = read_table(table, io_config)
    ends, defects = Counter(rows["status"].to_pylist()), Counter()
    for found in rows["defects"].drop_null().to_pylist():
        defects.update(dict(found))
    seconds = pc.sum(rows["cpu_seconds"], min_count=0).as_py()
    return {"files": rows.num_rows, "status": dict(ends), "defects": dict(sorted(defects.items())), "cpu_seconds": seconds}
