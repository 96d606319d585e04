"""A worker: files mended one after another in a kept child process, and a row of each whatever it does to the child."""

from __future__ import annotations

import os
import sys
import threading
import time
from collections.abc import Sequence
from typing import Any

from ._child import Answer, Child, Row
from ._plan import Plan, text_of

COMMAND = (sys.executable, "-m", "meshmend._command")  # As `meshmend-worker`, and `meshmend worker`.
RETRIED = frozenset({"timeout", "memory", "crashed"})
SECONDS_TO_START, STARTS = 60.0, 10


class WorkerError(RuntimeError):
    """A worker does not start, and what it said of it."""


class Worker:
    """A child process that mends files one after another, for a map of one's own: Ray, Dask, Spark, threads.

    Whatever a file does, there is a row of it: a child that takes longer than `timeout` seconds is killed, it has no more memory
    than `memory` (such as "4GiB"), and what ends it is told. Such a file is tried once more, alone in a fresh child. A worker
    can be pickled; each process starts a child of its own. Threads are served one after another.
    """

    def __init__(
        self, *, plan: Any = None, options: Sequence[str] = (), timeout: float | None = None, memory: str | int | None = None,
        reports: bool = False, command: Sequence[str] | None = None,
    ) -> None:
        self._child: Child | None = None
        self._plan = plan.to_toml() if isinstance(plan, Plan) else None if plan is None else text_of(plan)
        self._timeout = timeout
        self._words = [*(command or COMMAND), *(["--memory", str(memory)] if memory else []), *(["--reports"] if reports else []), *options]
        self.__setstate__({})

    def mend(self, path: str, output: str | None = None, *, name: str | None = None, format: str | None = None) -> Row:
        """The row of a file that is mended into another one, or only judged without `output`."""
        return self.run(os.fspath(path), output and os.fspath(output), name=name, format=format)[0]

    def run(self, source: str | bytes, output: str | bool | None = None, *, name: str | None = None, format: str | None = None) -> Answer:
        """The row of a file, by path or as bytes; and the bytes of the result, if `output` is True and there is one."""
        data = source if isinstance(source, bytes) else b""
        told, called = ({"path": source}, source) if isinstance(source, str) else ({"bytes": len(data)}, "bytes")
        job = _to({"id": 1, "name": name or called, "input": told}, output, format)
        with self._lock:
            answer = self._tried(job, data)
            if answer[0]["status"] in RETRIED:
                self.close()
                answer = self._tried(job, data)
                answer[0]["attempts"] = 2
                self.close()
        return answer

    def template(self, name: str, output: str | bool | None = None, format: str | None = None) -> Row:
        """The row of a file of this name on which nothing was done: it has the digest of the policy."""
        kind = (os.path.splitext(name)[1], os.path.splitext(output)[1] if isinstance(output, str) else output, format)
        job = _to({"id": 0, "name": name, "input": {"bytes": 0}}, output, format)
        for _ in range(STARTS):
            child = self._kept()
            if kind not in child.templates:  # No bytes are no file of any format: nothing is done.
                child.templates[kind] = child.ask(job, b"", SECONDS_TO_START)
            row = (child.templates[kind] or (child.ended(),))[0]
            if row.get("plan_digest"):
                return {**row, "path": name, "size": None, "input_sha256": None, "line": None, "byte": None}
            self.close()
            if not row["signal"]:
                break
        raise WorkerError(row["message"])

    def close(self) -> None:
        """Ends the child; the next file starts another one."""
        child, self._child = self._child, None
        if child and child.owner == os.getpid():
            child.close()

    def _tried(self, job: Row, data: bytes) -> Answer:
        row = self.template(job["name"], next(iter(job.get("output", {"": None}).values())), job.get("format"))
        child, begin = self._kept(), time.monotonic()
        answer = child.ask(job, data, self._timeout)
        if answer is None:
            row |= {**child.ended(), "size": len(data) or None, "seconds": time.monotonic() - begin, "cpu_seconds": None, "peak_bytes": None}
            if child.is_late:
                row |= {"status": "timeout", "signal": None, "message": f"it took longer than {self._timeout:g} s"}
        if answer is None or child.is_late or child.is_worn():
            self.close()
        return answer or (row, None)

    def _kept(self) -> Child:
        if not self._child or self._child.owner != os.getpid():  # After a fork, the child is the parent's.
            self._child = Child(self._words, self._plan)
        return self._child

    def __getstate__(self) -> Row:
        return {name: self.__dict__[name] for name in ("_plan", "_timeout", "_words")}

    def __setstate__(self, state: Row) -> None:
        self.__dict__.update(state, _child=None, _lock=threading.Lock())

    def __enter__(self) -> Worker:
        return self

    def __exit__(self, *_: object) -> None:
        self.close()

    __del__ = close


def _to(job: Row, output: str | bool | None, format: str | None) -> Row:
    asked = {"output": {"bytes": True} if output is True else {"path": output}} if output else {}
    return {**job, **asked, **({"format": format} if format else {})}
