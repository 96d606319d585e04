"""Rows as tables: their columns, parts of at most ten thousand, and what is read back."""

from __future__ import annotations

import io
import json
import os
import time
from collections import Counter
from typing import Any

import pyarrow as pa
import pyarrow.parquet as pq

from ._store import files_below, is_local, plain, put, within

Row = dict[str, Any]
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


class Parts:
    """Rows on their way into a folder. Those that wait are lost if the process is killed, and are done again."""

    def __init__(self, table: str, io_config: Any) -> None:
        self.table, self.io_config, self.rows = table, io_config, []
        self.begin = self.last = time.monotonic()

    def add(self, rows: list[Row]) -> None:
        self.rows += rows
        now = time.monotonic()
        # A kill costs a second and a twentieth of the time so far, and yet there are few parts, however long it takes.
        if len(self.rows) >= ROWS_OF_A_PART or now - self.last > 1 + (now - self.begin) / 20:
            self.flush()

    def flush(self) -> None:
        put_parts(self.table, arrow(self.rows), self.io_config)
        self.rows, self.last = [], time.monotonic()


def arrow(rows: list[Row]) -> pa.Table:
    """Rows of workers, or of a ledger, as a table."""
    def column(field: pa.Field) -> pa.Array:
        values = [row.get(field.name) for row in rows]
        if field.type == _TIME:
            return pa.array(values, _TEXT).cast(_TIME)
        of = bytes.fromhex if field.type == _HASH else lambda value: [*value.items()] if field.name == "defects" else value
        return pa.array([None if value is None else of(value) for value in values], field.type)

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
    if is_local(plain(table)) and os.path.isfile(plain(table)) and not plain(table).endswith(".parquet"):
        with open(plain(table), "rb") as file:  # Whose last line is torn, if its writer was killed.
            rows = arrow([json.loads(line) for line in file if line.endswith(b"\n")])
    else:
        parts = [plain(table)] if plain(table).endswith(".parquet") else _parts(table, io_config)
        places = [within(part, io_config) for part in parts]
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
    for found in rows["defects"].to_pylist():
        defects.update(dict(found or ()))
    seconds = sum(seconds or 0 for seconds in rows["cpu_seconds"].to_pylist())
    return {"files": rows.num_rows, "status": dict(ends), "defects": dict(sorted(defects.items())), "cpu_seconds": seconds}
