"""A worker, by itself: whatever happens to its child, there is a row of the file, and no child is left."""

import json
import os
import pickle
import signal
import threading
from pathlib import Path

import pytest
from meshmend import _child
from meshmend.fleet import Worker, WorkerError

from .lake import COMMAND, EXAMPLES, RUN_COLUMNS, descendants, eventually, is_gone, strike, workers_of

BROKEN = str(EXAMPLES / "broken.obj")


def settled(row):
    return {name: value for name, value in row.items() if name not in RUN_COLUMNS}


def catches(pid, one):
    """Whether a process has a handler for a signal."""
    caught = next(line for line in Path(f"/proc/{pid}/status").read_text().splitlines() if line.startswith("SigCgt:"))
    return int(caught.split()[1], 16) >> (one - 1) & 1


class Struck(Worker):
    """One whose child gets signals as soon as it has a job, in the first tries."""

    signals, tries = (), 2

    def _tried(self, job, data):
        self.template(job["name"], next(iter(job.get("output", {"": None}).values())), job.get("format"))
        if self.tries:
            self.tries -= 1
            pid = self._child.process.pid
            if signal.SIGSEGV in self.signals:
                # The first only takes away the handler by which Rust tells of a full stack.
                strike(pid, signal.SIGSEGV)
                eventually(lambda: not catches(pid, signal.SIGSEGV))
            strike(pid, signal.SIGSTOP)
            threading.Timer(0.05, strike, (pid, *self.signals)).start()
        return super()._tried(job, data)


def test_a_file_by_path_and_as_bytes_comes_to_the_same(worker, tmp_path):
    mended, data = worker(), (EXAMPLES / "broken.obj").read_bytes()
    row = mended.mend(BROKEN, str(tmp_path / "out" / "broken.obj"))
    other, result = mended.run(data, True, name=BROKEN)
    assert (row["status"], row["changed"], row["size"], row["attempts"]) == ("mended", True, len(data), 1)
    assert result == (tmp_path / "out" / "broken.obj").read_bytes()
    assert settled({**row, "output": None}) == settled(other)
    judged, nothing = mended.run(data, name=BROKEN)
    assert nothing is None and judged["before"] == row["before"] and judged["output_sha256"] is None
    assert mended.mend(BROKEN, str(tmp_path / "broken.ply"), format="ply")["format_out"].startswith("ply")


def test_what_is_wrong_with_a_file_is_in_its_row(worker, tmp_path):
    (tmp_path / "torn.off").write_text("OFF\n3 1 0\n0 0 0\n")
    mended = worker()
    assert mended.mend(str(tmp_path / "torn.off"))["status"] == "unreadable"
    assert mended.mend(str(tmp_path / "none.obj"))["status"] == "missing"
    assert mended.mend(BROKEN, "/proc/none/out.obj")["status"] == "unwritable"
    assert mended.run(b"", True, name="nothing.obj")[0]["status"] == "unreadable"


def test_a_child_that_dies_is_a_row_after_a_second_one_has_died_too(worker):
    struck = worker(Struck)
    struck.signals = (signal.SIGSEGV, signal.SIGCONT)
    row = struck.mend(BROKEN)
    assert (row["status"], row["signal"], row["attempts"], row["path"]) == ("crashed", signal.SIGSEGV, 2, BROKEN)
    assert str(int(signal.SIGSEGV)) in row["message"]
    healthy = struck.mend(BROKEN)
    assert healthy["status"] == "mended" and healthy["plan_digest"] == row["plan_digest"] and set(healthy) == set(row)


def test_a_child_that_dies_once_is_made_up_for(worker):
    struck = worker(Struck)
    struck.signals, struck.tries = (signal.SIGKILL,), 1
    row = struck.mend(BROKEN)
    assert (row["status"], row["attempts"], row["signal"]) == ("mended", 2, None)


def test_a_child_that_hangs_is_killed(worker):
    struck = worker(Struck, timeout=0.3)
    row = struck.mend(BROKEN)
    assert (row["status"], row["signal"], row["attempts"]) == ("timeout", None, 2)
    assert not workers_of(os.getpid())
    assert struck.mend(BROKEN)["status"] == "mended"


def test_a_child_that_does_not_read_its_job_is_killed_too(worker):
    struck = worker(Struck, timeout=0.3)
    assert struck.run(b"#" * (1 << 22), name="long.obj")[0]["status"] == "timeout"  # Far more than a pipe holds.
    struck.signals, struck.tries = (signal.SIGKILL,), 1
    row, _ = struck.run(b"#" * (1 << 22), name="long.obj")
    assert (row["status"], row["attempts"], row["size"]) == ("clean", 2, 1 << 22)


def test_a_file_that_does_not_fit_into_memory_is_a_row(worker, tmp_path):
    count = 6_000_000  # The worker itself reserves more than a gigabyte, and uses little of it.
    with (tmp_path / "large.stl").open("wb") as file:
        file.write(bytes(80) + count.to_bytes(4, "little"))
        file.truncate(84 + 50 * count)
    row = worker(memory="1400MiB").mend(str(tmp_path / "large.stl"))
    assert (row["status"], row["attempts"]) == ("memory", 2), row["message"]


def test_many_files_are_for_one_child(worker):
    mended, data = worker(), b"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nf 2 3 1\n"
    mended.run(data, True, name="a.obj")
    child = mended._child.process.pid
    rows = [mended.run(data, True, name=f"{number}.obj") for number in range(5000)]
    assert {row["path"] for row, _ in rows} == {f"{number}.obj" for number in range(5000)}
    assert len({result for _, result in rows}) == 1 and {row["attempts"] for row, _ in rows} == {1}
    assert mended._child.process.pid == child and workers_of(os.getpid()) == {child}


@pytest.mark.parametrize("limit", ["FILES_OF_A_CHILD", "plateau"])
def test_a_child_is_replaced_after_many_files_and_when_it_has_grown(worker, monkeypatch, limit):
    monkeypatch.setattr(_child, "FILES_BETWEEN_LOOKS", 1)
    mended = worker()
    mended.mend(BROKEN)
    first = mended._child.process.pid
    if limit == "plateau":
        mended._child.plateau = 1
    else:
        monkeypatch.setattr(_child, limit, 3)
    assert [mended.mend(BROKEN)["status"] for _ in range(4)] == ["mended"] * 4
    assert is_gone(first)


def test_a_policy_is_that_of_its_words_and_of_a_plan(worker, tmp_path):
    plan = tmp_path / "plan.toml"
    plan.write_text('passes = ["weld", "orient"]\n')
    digests = {name: worker(**how).mend(BROKEN)["plan_digest"] for name, how in {
        "none": {}, "plan": {"plan": str(plan)}, "again": {"plan": plan}, "word": {"options": ["--orient", "outward"]},
    }.items()}
    assert digests["plan"] == digests["again"] and len(set(digests.values())) == 3
    assert json.loads(worker(reports=True).mend(BROKEN)["report"])["removed_faces"]["count"] == 1


def test_a_worker_that_does_not_start_says_why(worker):
    with pytest.raises(WorkerError, match="--nonsense"):
        worker(options=["--nonsense"]).mend(BROKEN)
    with pytest.raises(WorkerError, match="formats are"):
        worker().run(b"", True, name="a.obj", format="nonsense")
    with pytest.raises(FileNotFoundError):
        worker(plan="/none/plan.toml")


def test_a_worker_goes_to_other_processes(worker):
    mended = worker(options=["--orient", "majority"])
    row = mended.mend(BROKEN)
    child = mended._child.process.pid
    again = pickle.loads(pickle.dumps(mended))
    assert settled(again.mend(BROKEN)) == settled(row) and again._child.process.pid != child
    again.close()
    forked = os.fork()
    if not forked:
        ended = mended.mend(BROKEN)
        mended.close()
        os._exit(0 if settled(ended) == settled(row) else 1)
    assert os.waitstatus_to_exitcode(os.waitpid(forked, 0)[1]) == 0
    assert settled(mended.mend(BROKEN)) == settled(row) and mended._child.process.pid == child


def test_threads_are_served_one_after_another(worker):
    mended, rows = worker(), {}

    def work(name):
        rows[name] = [mended.run(b"v 0 0 0\n", name=f"{name}-{number}.obj")[0]["path"] for number in range(50)]

    threads = [threading.Thread(target=work, args=(name,)) for name in "abc"]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert rows == {name: [f"{name}-{number}.obj" for number in range(50)] for name in "abc"}


def test_no_child_is_left(driver):
    one = Worker(command=COMMAND)
    one.mend(BROKEN)
    child = one._child.process.pid
    del one
    assert is_gone(child)
    process = driver(
        "import sys, time\nfrom meshmend.fleet import Worker\n"
        f"worker = Worker(command={COMMAND!r})\nworker.mend({BROKEN!r})\nprint('ready', flush=True)\ntime.sleep(60)\n"
    )
    assert process.stdout.readline() == "ready\n"
    left = descendants(process.pid)
    assert len(left) == 1
    process.kill()
    eventually(lambda: all(map(is_gone, left)))


def test_a_child_that_dies_while_it_waits_is_replaced(worker):
    mended = worker()
    row = mended.mend(BROKEN)
    strike(mended._child.process.pid, signal.SIGKILL)
    assert settled(mended.mend(BROKEN)) == settled(row)
    mended.mend(BROKEN)
    strike(mended._child.process.pid, signal.SIGKILL)
    mended._child.process.wait()  # Somebody has asked after it.
    assert settled(mended.mend(BROKEN)) == settled(row)
    mended.mend(BROKEN)
    strike(mended._child.process.pid, signal.SIGKILL)
    mended._child.process.stdin.write(b"x")
    mended.close()
