"""Measures one operation of one program in this process, and prints a line of JSON.

    measure.py PROGRAM OPERATION FILE SCRATCH RUNS

A program is a module beside this one. It has `version()` and OPERATIONS: by name a generator of (file, scratch) that
makes its input and yields, does the operation and yields, and returns the figures of what came out. What lies between
the two yields is measured: processor time of all threads and of child processes, time by the clock, and by how much
the memory that is resident grew at most.
"""

import importlib
import json
import resource
import signal
import sys
import time

LIMIT = 120


def main():
    program, operation, file, scratch, runs = sys.argv[1:]
    module = importlib.import_module(program)
    report = {"version": module.version(), "cpu": [], "wall": [], "growth": 0}
    for run in range(int(runs)):
        steps = module.OPERATIONS[operation](file, scratch)
        next(steps)
        before = resident()
        clear_peak()
        # Who takes longer is stopped, and the runner says so.
        signal.alarm(LIMIT)
        cpu, wall = processor_time(), time.perf_counter()
        next(steps)
        cpu, wall = processor_time() - cpu, time.perf_counter() - wall
        signal.alarm(0)
        report["cpu"].append(cpu)
        report["wall"].append(wall)
        if run == 0:
            children = resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss * 1024
            report["growth"] = max(resident("VmHWM") - before, children, 0)
        report["figures"] = rest(steps)
    print(json.dumps(report))


def rest(steps):
    try:
        next(steps)
    except StopIteration as end:
        return end.value
    raise RuntimeError("an operation yields twice")


def processor_time():
    who = [resource.getrusage(who) for who in (resource.RUSAGE_SELF, resource.RUSAGE_CHILDREN)]
    return sum(used.ru_utime + used.ru_stime for used in who)


def clear_peak():
    with open("/proc/self/clear_refs", "w") as clear:
        clear.write("5")


def resident(field="VmRSS"):
    with open("/proc/self/status") as status:
        return next(int(line.split()[1]) * 1024 for line in status if line.startswith(field))


if __name__ == "__main__":
    main()
