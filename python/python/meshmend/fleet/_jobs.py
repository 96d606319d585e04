"""Many files over Daft: listed, those that are done left out, mended in kept workers, their rows written in parts."""

from __future__ import annotations

import io
import json
import os
import shutil
import tempfile
from collections import Counter
from collections.abc import Collection, Iterator, Sequence
from contextlib import closing, nullcontext
from typing import Any

import daft

from .. import _native
from .._child import Row, short
from .._progress import Step, watched
from .._worker import Worker
from ._store import File, files_below, is_local, listing, plain, put
from ._table import kept, read_table

BYTES_THROUGH_PIPES = 64 << 20
FILES_OF_A_BATCH = 16
_KEY = ("size", "mtime", "plan_digest", "version")


def mend(
    source: str | Sequence[str], *, to: str | None, table: str, concurrency: int | None = None, resume: bool = True,
    retry: Collection[str] = (), io_config: Any = None, progress: Step | bool | None = None, format: str | None = None,
    scratch: str | None = None, **policy: Any,
) -> dict[str, int]:
    """Mends all files of folders and globs, and says how many ended how; `table` has a row for each.

    A file with a row is not done again if it, the policy and meshmend are the same and its output is there, unless its status is
    one of `retry`. `policy` is that of a `Worker`: `plan`, `timeout`, `memory`, ...; `concurrency` is how many workers there are,
    by default one a processor. Where Daft runs on Ray, they are on its nodes.
    """
    worker = Worker(**policy)
    # That of this process, where it has one; those on other nodes have none.
    io_config = io_config or daft.context.get_context().daft_planning_config.default_io_config
    sources, to = [source] if isinstance(source, str) else source, to and plain(to).rstrip("/") + "/"
    listed = {file.path: file for one in sources for file in listing(one, io_config)}
    # Results of before that lie below the source are none of its files.
    files = [file for file in listed.values() if not to or file.base == to or not file.path.startswith(to)]
    ending = (lambda path: f"{os.path.splitext(path)[0]}.{format}") if format else str
    outputs = {file.path: to and ending(to + file.path[len(file.base) :]) for file in files}
    taken = Counter(outputs.values())
    for path, output in outputs.items():
        if output and (output in outputs or taken[output] > 1):
            raise ValueError(f"{path}: its output {output} is an input, or that of another file")
    there = {None, *(file.path for file in (files_below(to, io_config) if to else ()))}
    rows = _rows(table, io_config) if resume else ()
    before = {row["path"]: row for row in rows if row["status"] not in retry and row["output"] in there}

    def is_done(file: File) -> bool:
        now = {**worker.template(file.path, outputs[file.path], format), **file._asdict()}
        return all(before[file.path][name] == now[name] for name in _KEY) if file.path in before else False

    with worker:  # It says at once what is wrong with the policy.
        left = [file for file in files if not is_done(file)]
    ended = Counter(before[path]["status"] for path in outputs.keys() - {file.path for file in left})
    worked = _worked(left, outputs, concurrency or _processors(), (worker, format, scratch, io_config)) if left else ()
    with watched(progress=progress) as (_, step), closing(kept(worked, table, io_config)) as batches:
        for rows in batches:
            ended.update(row["status"] for row in rows)
            if step:
                step("mend", sum(ended.values()), len(files))
    return dict(ended)


def check(source: str | Sequence[str], *, table: str, **how: Any) -> dict[str, int]:
    """As `mend`, and nothing is written but the rows."""
    return mend(source, to=None, table=table, **how)


def _worked(files: list[File], outputs: dict[str, str | None], workers: int, how: tuple[Any, ...]) -> Iterator[list[Row]]:
    size = max(1, min(FILES_OF_A_BATCH, len(files) // (4 * workers)))
    batches = -(-len(files) // size)
    # Dealt like cards: each batch begins with a large file, and the largest come first.
    files = sorted(files, key=lambda file: -file.size)
    frame = daft.from_pylist([{**file._asdict(), "output": outputs[file.path]} for begin in range(batches) for file in files[begin::batches]])
    mended = daft.cls(_Mender, max_concurrency=workers)(*how).mended
    frame = frame.into_batches(size).select(mended(*(daft.col(name) for name in ("path", "size", "mtime", "output"))).alias("row"))
    for batch in frame.to_arrow_iter():
        yield [json.loads(row) for row in batch.column("row").to_pylist()]


class _Mender:
    """What Daft has on each node: a worker, and what takes files to it and results from it."""

    def __init__(self, worker: Worker, format: str | None, scratch: str | None, io_config: Any) -> None:
        self.worker, self.format, self.scratch, self.io_config = worker, format, scratch, io_config

    @daft.method(return_dtype=daft.DataType.string())
    def mended(self, path: str, size: int, mtime: int | None, output: str | None) -> str:
        """The row of a file, as JSON."""
        with tempfile.TemporaryDirectory(dir=self.scratch) if size > BYTES_THROUGH_PIPES else nullcontext("") as folder:
            return json.dumps({**self._mended(path, size, output, folder), "size": size, "mtime": mtime})

    def _mended(self, path: str, size: int, output: str | None, folder: str) -> Row:
        goal = output and (output if is_local(output) else not folder or f"{folder}/{os.path.basename(output)}")
        try:
            source = path if is_local(path) else self._fetched(path, folder)
        except Exception as error:
            status = "missing" if isinstance(error, FileNotFoundError) else "unreadable"
            return _failed(self.worker.template(path, goal, self.format), status, error)
        row, data = self.worker.run(source, goal, name=path, format=self.format)
        if output and row["output_sha256"] and not is_local(output):
            try:
                with open(goal, "rb") if data is None else io.BytesIO(data) as file:
                    put(output, file, self.io_config)
            except Exception as error:
                return _failed(row, "unwritable", error)
            row["output"] = output
        return row

    def _fetched(self, path: str, folder: str) -> str | bytes:
        with daft.open_file(path, "rb", io_config=self.io_config) as file:
            if not folder:
                return bytes(file.read())
            with open(f"{folder}/in-{os.path.basename(path)}", "wb") as whole:
                shutil.copyfileobj(file, whole, 8 << 20)
                return whole.name


def _failed(row: Row, status: str, error: Exception) -> Row:
    return {**row, "status": status, "output": None, "output_sha256": None, "format_out": None, "message": short(error)}


def _rows(table: str, io_config: Any) -> list[Row]:
    rows = read_table(table, io_config).select(["path", "status", "output", *_KEY])
    # As a number: a date of Python has no nanoseconds.
    return rows.set_column(rows.column_names.index("mtime"), "mtime", rows["mtime"].cast("int64")).to_pylist()


def _processors() -> int:
    if daft.get_or_infer_runner_type() != "ray":
        return _native.threads()
    import ray

    daft.get_or_create_runner()
    return int(ray.cluster_resources().get("CPU", 1))
