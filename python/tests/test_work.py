"""Work off the interpreter's lock: progress, signals, threads, forks, and mistakes of meshmend itself."""

import multiprocessing
import os
import pickle
import signal
import subprocess
import sys
import threading
import time
from concurrent.futures import ThreadPoolExecutor

import meshmend as mm
import pytest
from meshmend import _native


def test_steps_are_told_on_the_thread_that_calls(grid):
    told = []
    mm.check(grid(20), progress=lambda *step: told.append((threading.get_ident(), *step)))
    assert told and {thread for thread, *_ in told} == {threading.get_ident()}
    assert all(step and 0 <= done and (done <= total or total == 0) for _, step, done, total in told)


def test_what_a_callback_raises_is_raised(grid):
    class Enough(Exception):
        pass

    def stop(step, done, total):
        raise Enough(step)

    with pytest.raises(Enough):
        mm.check(grid(20), progress=stop)
    assert mm.check(grid(20)).manifold
    with pytest.raises(TypeError, match="progress"):
        mm.check(grid(2), progress=3)


@pytest.mark.parametrize("work", ["loops", "cut", "picture"])
def test_surfaces_and_pictures_are_stopped_too(grid, work):
    mesh = mm.Mesh(*grid(300))
    told = []

    def stop(step, done, total):
        told.append(step)
        if len(told) > 1 or work == "picture":
            raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        if work == "picture":
            _native.picture(mesh._handle, True, (480, 360), "png", (1, stop))
        else:
            # As many roots as would take seconds.
            getattr(mm, work)(mesh, roots=200, threads=1, progress=stop)
    assert told[0] == work or "loops" in told
    # Nothing is told any more.
    assert len(told) <= 2


def test_a_step_is_told_when_it_begins_and_not_too_often(grid):
    mesh = mm.Mesh(*grid(300))
    told = []
    began = time.monotonic()
    mm.check(mesh, geometry=True, progress=lambda step, done, total: told.append(step))
    pulses = (time.monotonic() - began) / 0.05
    changes = sum(one != other for one, other in zip(told, told[1:]))
    assert {"topology", "crossings"} <= set(told) or len(set(told)) > 3, set(told)
    assert len(told) <= pulses + changes + 2


def test_work_that_was_stopped_costs_no_more(grid):
    mesh = mm.Mesh(*grid(700))

    def whole():
        began = time.process_time()
        mm.check(mesh, geometry=True, threads=1)
        return time.process_time() - began

    def stopped():
        began = time.process_time()
        with pytest.raises(ZeroDivisionError):
            mm.check(mesh, geometry=True, threads=1, progress=lambda *_: 1 / 0)
        return time.process_time() - began

    assert stopped() < whole() / 3


def test_the_lock_is_free_while_work_is_done(grid):
    mesh = mm.Mesh(*grid(300))
    with ThreadPoolExecutor(4) as pool:
        checks = list(pool.map(lambda threads: mm.check(mesh, threads=threads).to_json(), [1, 2, 1, None]))
    assert len(set(checks)) == 1


def test_threads_do_not_change_what_is_found(grid):
    mesh = mm.Mesh(*grid(50))
    mm.set_threads(1)
    try:
        alone = mm.check(mesh).to_json()
    finally:
        mm.set_threads(None)
    assert alone == mm.check(mesh, threads=3).to_json() == mm.check(mesh).to_json()
    with pytest.raises(ValueError, match="between 1 and 1024"):
        mm.set_threads(0)


SLOW = """
import os, signal, threading
import numpy as np
import meshmend as mm
n = 1500
x, y = np.meshgrid(np.arange(n + 1.0), np.arange(n + 1.0), indexing="ij")
low = (np.arange(n)[:, None] * (n + 1) + np.arange(n)).ravel()
faces = np.concatenate([np.stack([low, low + n + 1, low + 1], axis=1), np.stack([low + 1, low + n + 1, low + n + 2], axis=1)])
mesh = mm.Mesh(np.stack([x.ravel(), y.ravel(), 0 * x.ravel()], axis=1), faces)
threading.Timer(0.2, lambda: os.kill(os.getpid(), signal.SIGINT)).start()
try:
    mm.check(mesh, geometry=True, threads=1)
except KeyboardInterrupt:
    print("interrupted")
else:
    print("done")
print(mm.check((mesh.vertices[:3], [[0, 1, 2]])).faces)
"""


def test_an_interrupt_stops_the_work():
    ran = subprocess.run([sys.executable, "-c", SLOW], capture_output=True, text=True, timeout=300)
    assert ran.stdout.split()[0] == "interrupted", ran
    assert ran.returncode == 0


def _counts(arrays):
    assert len(mm.repair(arrays, threads=2).mesh.vertices) == 7
    return mm.check(arrays).counts()


@pytest.mark.parametrize("method", ["fork", "spawn", "forkserver"])
@pytest.mark.filterwarnings("ignore::DeprecationWarning")
def test_children_work_after_their_parent_did(book, method):
    if method not in multiprocessing.get_all_start_methods():
        pytest.skip(f"there is no {method} here")
    assert len(mm.repair(book, threads=2).mesh.vertices) == 7
    expected = mm.check(book, threads=2).counts()
    context = multiprocessing.get_context(method)
    with context.Pool(2) as pool:
        found = pool.map_async(_counts, [book] * 4).get(timeout=120)
    assert found == [expected] * 4
    assert mm.check(book).counts() == expected


@pytest.mark.skipif(not hasattr(os, "fork"), reason="there is no fork here")
@pytest.mark.filterwarnings("ignore::DeprecationWarning")
def test_a_child_that_was_forked_while_others_work(grid):
    mesh = mm.Mesh(*grid(100))
    stop = threading.Event()

    def work():
        while not stop.is_set():
            mm.check(mesh, threads=2)

    busy = threading.Thread(target=work)
    busy.start()
    try:
        for _ in range(5):
            child = os.fork()
            if child == 0:
                signal.alarm(60)
                os._exit(0 if mm.check(mesh).manifold else 1)
            assert os.waitstatus_to_exitcode(os.waitpid(child, 0)[1]) == 0
    finally:
        stop.set()
        busy.join()


def test_a_mistake_of_meshmend_is_an_exception(capfd):
    with pytest.raises(mm.InternalError, match="as it was asked for.*Please report it") as caught:
        _native._panic((2, None))
    assert "registries.rs" in caught.value.place
    assert capfd.readouterr().err == ""
    again = pickle.loads(pickle.dumps(caught.value))
    assert str(again) == str(caught.value) and again.place == caught.value.place
    assert isinstance(caught.value, Exception)
    assert mm.explain("weld").startswith("weld")
