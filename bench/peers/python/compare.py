"""Measures meshmend and its peers, one after another, and writes the table and the picture. `../run` calls it."""

import argparse
import datetime
import importlib
import json
import os
import pathlib
import platform
import subprocess
import sys

HERE = pathlib.Path(__file__).parent
BENCH = HERE.parent.parent
# A process may take this long beside the two minutes that an operation may take.
PATIENCE = 600
# In the order of how often they are the best.
MODULES = ["vtk", "libigl", "meshlib", "meshlab", "miniply", "open3d", "trimesh", "pygel", "meshfix", "admesh"]


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--program", required=True)
    parser.add_argument("--work", type=pathlib.Path, required=True)
    parser.add_argument("--faces", type=int, required=True)
    parser.add_argument("--order", required=True)
    parser.add_argument("--runs", required=True)
    parser.add_argument("--programs", nargs="+", default=[*MODULES, "crates", "cgal"])
    parser.add_argument("--operations", nargs="*")
    options = parser.parse_args()
    known = json.loads((options.work / "inputs" / f"known-{options.order}-{options.faces}.json").read_text())
    missing = (options.work / "missing").read_text().splitlines()
    peers, absent = programs(options.work, options.programs)
    targets = json.loads((BENCH / "targets.json").read_text())
    rows = []
    for operation in options.operations or [*targets, *sorted(known.keys() - targets)]:
        facts = known[operation]
        rows.append(ours(operation, facts, options))
        print(line(rows[-1]), file=sys.stderr)
        for command in peers.get(operation, []):
            rows.append(theirs(operation, facts, command, options))
            print(line(rows[-1]), file=sys.stderr)
    write(rows, targets, missing + absent, options)


def programs(work, wanted):
    """For each operation the commands that do it, the operation and its arguments to follow; and who is missing."""
    peers, absent = {}, []

    def add(command, operation):
        peers.setdefault(operation, []).append(command)

    crates, cgal = work / "crates" / "release" / "peer-crates", work / "cgal"
    if crates.exists() and "crates" in wanted:
        for pair in subprocess.run([crates], capture_output=True, text=True, check=True).stdout.splitlines():
            name, operation = pair.split()
            add([crates, name], operation)
    for name in filter(wanted.__contains__, MODULES):
        try:
            operations = importlib.import_module(f"peer_{name}").OPERATIONS
        except ImportError as error:
            absent.append(f"{name}: {error}")
            continue
        for operation in operations:
            add([sys.executable, HERE / "measure.py", f"peer_{name}"], operation)
    if cgal.exists() and "cgal" in wanted:
        for operation in subprocess.run([cgal], capture_output=True, text=True, check=True).stdout.split():
            add([cgal], operation)
    return peers, absent


def ours(operation, facts, options):
    command = [options.program, "run", operation, "--json", "--runs", options.runs]
    command += ["--faces", str(options.faces), "--order", options.order, "--inputs", options.work / "inputs"]
    said = subprocess.run(command, capture_output=True, text=True)
    row = {"operation": operation, "who": "meshmend", "ours": True}
    if said.returncode:
        return row | {"word": "failed: " + last_line(said.stderr)}
    (found,) = json.loads(said.stdout)
    times = [found["cpu"]["best"], found["wall"]["best"]]
    return row | judged(found["figures"], facts, times, found["bytes_a_face"] * facts["faces"])


def theirs(operation, facts, command, options):
    scratch = options.work / "scratch"
    scratch.mkdir(exist_ok=True)
    row = {"operation": operation, "who": name(command), "ours": False}
    arguments = [operation, facts["file"], scratch, options.runs]
    try:
        said = subprocess.run(command + arguments, capture_output=True, text=True, timeout=PATIENCE)
    except subprocess.TimeoutExpired:
        return row | {"word": "> 120 s"}
    finally:
        for file in scratch.iterdir():
            file.unlink()
    # What measures is stopped by the alarm that it set.
    if said.returncode == -14:
        return row | {"word": "> 120 s"}
    if said.returncode:
        return row | {"word": "failed: " + last_line(said.stderr)}
    found = json.loads(said.stdout.splitlines()[-1])
    row["who"] = found["version"]
    return row | judged(found["figures"], facts, found["cpu"] + found["wall"], found["growth"])


def name(command):
    return str(command[-1]).rsplit("/", 1)[-1].removeprefix("peer_")


def judged(figures, facts, times, growth):
    if figures != facts["expected"]:
        wrong = {key: value for key, value in figures.items() if facts["expected"].get(key) != value}
        right = {key: facts["expected"].get(key) for key in wrong}
        return {"word": f"wrong: {short(wrong)}, not {short(right)}"}
    return {"speed": facts["faces"] / 1e6 / min(times), "bytes": growth / facts["faces"]}


def short(figures):
    return ", ".join(f"{key.replace('_', ' ')} {value}" for key, value in figures.items())


def last_line(text):
    lines = [line.strip() for line in text.splitlines() if line.strip()]
    return lines[-1][:120].replace("|", "/") if lines else "without a word"


def line(row):
    """A row in short, to show that there is progress."""
    return f"{row['operation']}: {row['who']} {row.get('word') or format(row['speed'], '.2f')}"


def write(rows, targets, missing, options):
    day = datetime.date.today().isoformat()
    is_usual = (options.faces, options.order) == (1_000_000, "mesh")
    stem = day if is_usual else f"{day}-{options.order}-{options.faces}"
    (BENCH / "results").mkdir(exist_ok=True)
    page = [
        f"# {day}: {options.faces} faces, {options.order} order",
        "",
        f"{machine()}. Million input faces per second of min(processor time, time by the clock), the best of "
        f"{options.runs};",
        "B/f is the most memory that was taken beyond the input, in bytes for each input face. How it is measured and "
        "what is fair is said in [bench/README.md](../README.md).",
        "",
        f"![bars]({stem}.svg)",
        "",
        *summary(rows, targets, options),
        "",
        "## All",
        "",
        "| operation | program | Mf/s | B/f |",
        "|---|---|--:|--:|",
    ]
    for row in rows:
        cells = (row["word"], "") if "word" in row else (f"{row['speed']:.2f}", f"{row['bytes']:.0f}")
        page.append(f"| {row['operation']} | {row['who']} | {cells[0]} | {cells[1]} |")
    if missing:
        page += ["", "Not measured, because it could not be had:", "", *[f"* {what}" for what in missing]]
    (BENCH / "results" / f"{stem}.md").write_text("\n".join(page) + "\n")
    description = options.work / "chart.json"
    description.write_text(json.dumps(chart(rows, day, options)))
    subprocess.run([options.program, "chart", description, BENCH / "results" / f"{stem}.svg"], check=True)
    print(BENCH / "results" / f"{stem}.md")


def summary(rows, targets, options):
    """Ours beside the best peer and the figures to reach, which are for a million and for ten million faces."""
    size = 1 if options.faces >= 5_000_000 else 0
    yield "| operation | ours | to reach | best peer | Mf/s | its figure before | ours B/f | at most |"
    yield "|---|--:|--:|---|--:|--:|--:|--:|"
    for row in filter(lambda row: row["ours"], rows):
        operation = row["operation"]
        target = targets.get(operation, {})
        goal = target.get(f"ours_{options.order}", target.get("ours" if options.order == "mesh" else "", []))
        peers = [peer for peer in rows if peer["operation"] == operation and not peer["ours"] and "speed" in peer]
        best = max(peers, key=lambda peer: peer["speed"], default=None)
        before = [target.get("best"), number(target["peer"][size])] if target else []
        yield "| " + " | ".join(
            [
                target.get("title", operation),
                row["word"] if "word" in row else f"{row['speed']:.2f}",
                number(goal[size] if goal else None),
                best["who"] if best else "–",
                f"{best['speed']:.2f}" if best else "–",
                " ".join(before) if before else "–",
                "" if "word" in row else f"{row['bytes']:.0f}",
                number(target.get("bytes")),
            ]
        ) + " |"


def number(value):
    return "–" if value is None else f"{value:g}"


def chart(rows, day, options):
    groups = {}
    for row in rows:
        word = row.get("word", "").split(":")[0]
        bar = {
            "label": row["who"].split(" (")[0],
            "value": row.get("speed"),
            "text": word or f"{row['speed']:.2f}",
            "is_dark": row["ours"],
        }
        groups.setdefault(row["operation"], []).append(bar)
    title = f"Million faces a second: {options.faces} faces, {options.order} order, {day}"
    return {"title": title, "groups": [{"title": name, "bars": bars} for name, bars in groups.items()]}


def machine():
    with open("/proc/cpuinfo") as cpu:
        model = next((line.split(":")[1].strip() for line in cpu if line.startswith("model name")), platform.machine())
    load = os.getloadavg()[0]
    return f"{os.cpu_count()} cores, {model}, load {load:.1f} in the end"


if __name__ == "__main__":
    main()
