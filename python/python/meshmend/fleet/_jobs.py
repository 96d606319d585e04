"""Many files over Daft: listed, those that are done left out, mended in kept workers, their rows written in parts."""

from __future__ import annotations

import io
import json
import os
import shutil
import tempfile
from collections import Counter
from collections.abc import Callable, Collection, Iterator, Sequence
from contextlib import nullcontext
from datetime import datetime, timezone
from typing import Any

import daft

from .._progress import watched
from ._store import File, files_below, is_local, listing, plain, put
from ._table import Parts, read_table
from ._worker import Row, Worker

BYTES_THROUGH_PIPES = 64 << 20
FILES_OF_A_BATCH = 16
_KEY = ("size", "mtime", "plan_digest", "version")


def mend(
    source: str | Sequence[str], *, to: str | None, table: str, plan: Any = None, timeout: float | None = None,
    memory: str | int | None = None, concurrency: int | None = None, resume: bool = True, retry: Collection[str] = (),
    io_config: Any = None, progress: Callable[[str, int, int], object] | bool | None = None, format: str | None = None,
    options: Sequence[str] = (), reports: bool = False, scratch: str | None = None, command: Sequence[str] | None = None,
) -> dict[str, int]:
    """Mends all files of folders and globs, and says how many ended how; `table` has a row for each.

    A file with a row is not done again if it, the policy and meshmend are the same and its output is there, unless its status is
    one of `retry`. `timeout` and `memory` are those of a file; `concurrency` is how many workers there are, by default one a
    processor. Where Daft runs on Ray, they are on its nodes.
    """
    worker = Worker(plan=plan, options=options, timeout=timeout, memory=memory, reports=reports, command=command)
    # That of this process, where it has one; those on other nodes have none.
    io_config = io_config or daft.context.get_context().daft_planning_config.default_io_config
    sources, to = [source] if isinstance(source, str) else source, to and plain(to).rstrip("/") + "/"
    listed = {file.path: file for one in sources for file in listing(one, io_config)}
    is_apart = to and to not in {file.base for file in listed.values()}
    # Results of before that lie below the source are none of its files.
    files = [file for file in listed.values() if not (is_apart and file.path.startswith(to))]
    outputs = {file.path: to and _output(to + file.path[len(file.base) :], format) for file in files}
    taken = Counter(outputs.values())
    for path, output in outputs.items():
        if output and (output in outputs or taken[output] > 1):
            raise ValueError(f"{path}: its output {output} is an input, or that of another file")
    there = {None} | ({file.path for file in files_below(to, io_config)} if to else set())
    seen = _rows(table, io_config) if resume else {}
    ended: Counter[str] = Counter()
    with worker:  # It says at once what is wrong with the policy.
        def is_done(file: File) -> bool:
            now, row = worker.template(file.path, outputs[file.path], format), seen.get(file.path)
            key = (file.size, file.mtime, now["plan_digest"], now["version"])
            done = row is not None and row["status"] not in retry and row["output"] in there and key == tuple(row[name] for name in _KEY)
            ended.update([row["status"]] if done else [])
            return done

        left = sorted((file for file in files if not is_done(file)), key=lambda file: -file.size)
    parts = Parts(table, io_config)
    with watched(progress=progress) as (_, step):
        try:
            for rows in _worked(left, outputs, concurrency or _processors(), (worker, format, scratch, io_config)):
                parts.add(rows)
                ended.update(row["status"] for row in rows)
                if step:
                    step("mend", sum(ended.values()), len(files))
        finally:
            parts.flush()
    return dict(ended)


def check(source: str | Sequence[str], *, table: str, **how: Any) -> dict[str, int]:
    """As `mend`, and nothing is written but the rows."""
    return mend(source, to=None, table=table, **how)


def _worked(files: list[File], outputs: dict[str, str | None], workers: int, how: tuple[Any, ...]) -> Iterator[list[Row]]:
    size = max(1, min(FILES_OF_A_BATCH, len(files) // (4 * workers)))
    batches = -(-len(files) // size)
    # Dealt like cards: each batch begins with a large file, and the largest come first.
    files = [file for begin in range(batches) for file in files[begin::batches]]
    columns = {name: [getattr(file, name) for file in files] for name in ("path", "size", "mtime")}
    frame = daft.from_pydict({**columns, "output": [outputs[file.path] for file in files]})
    mender = daft.cls(_Mender, max_concurrency=workers)(*how)
    frame = frame.into_batches(size).select(mender.mended(*(daft.col(name) for name in frame.column_names)).alias("row"))
    for batch in frame.to_arrow_iter() if files else ():
        yield [json.loads(row) for row in batch.column("row").to_pylist()]


class _Mender:
    """What Daft has on each node: a worker, and what takes files to it and results from it."""

    def __init__(self, worker: Worker, format: str | None, scratch: str | None, io_config: Any) -> None:
        self.worker, self.format, self.scratch, self.io_config = worker, format, scratch, io_config

    @daft.method(return_dtype=daft.DataType.string())
    def mended(self, path: str, size: int, mtime: int | None, output: str | None) -> str:
        """The row of a file, as JSON."""
        with tempfile.TemporaryDirectory(dir=self.scratch) if size > BYTES_THROUGH_PIPES else nullcontext("") as folder:
            row = self._mended(path, size, output, folder)
        begin = mtime and datetime.fromtimestamp(mtime // 10**9, timezone.utc)
        return json.dumps({**row, "size": size, "mtime": begin and f"{begin:%Y-%m-%dT%H:%M:%S}.{mtime % 10**9:09}Z"})

    def _mended(self, path: str, size: int, output: str | None, folder: str) -> Row:
        goal = output and (output if is_local(output) else size <= BYTES_THROUGH_PIPES or f"{folder}/{os.path.basename(output)}")
        try:
            source = path if is_local(path) else self._fetched(path, folder)
        except Exception as error:
            status = "missing" if isinstance(error, FileNotFoundError) else "unreadable"
            return {**self.worker.template(path, goal, self.format), **_failed(status, error)}
        row, data = self.worker.run(source, goal, name=path, format=self.format)
        if output and row["output_sha256"] and not is_local(output):
            try:
                with open(goal, "rb") if data is None else io.BytesIO(data) as file:
                    put(output, file, self.io_config)
            except Exception as error:
                return {**row, "output_sha256": None, "format_out": None, **_failed("unwritable", error)}
            row["output"] = output
        return row

    def _fetched(self, path: str, folder: str) -> str | bytes:
        with daft.open_file(path, "rb", io_config=self.io_config) as file:
            if not folder:
                return bytes(file.read())
            with open(f"{folder}/in-{os.path.basename(path)}", "wb") as whole:
                shutil.copyfileobj(file, whole, 8 << 20)
                return whole.name


def _failed(status: str, error: Exception) -> Row:
    return {"status": status, "output": None, "message": str(error).encode()[:500].decode(errors="ignore")}


def _output(path: str, format: str | None) -> str:
    return f"{os.path.splitext(path)[0]}.{format}" if format else path


def _rows(table: str, io_config: Any) -> dict[str, Row]:
    rows = read_table(table, io_config).select(["path", "status", "output", *_KEY])
    # As a number: a date of Python has no nanoseconds.
    rows = rows.set_column(rows.column_names.index("mtime"), "mtime", rows["mtime"].cast("int64"))
    return {row["path"]: row for row in rows.to_pylist()}


def _processors() -> int:
    if daft.get_or_infer_runner_type() != "ray":
        return len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1
    import ray

    daft.get_or_create_runner()
    return int(ray.cluster_resources().get("CPU", 1))
