"""What the tests of many files share: meshes by the dozen, rows to compare, and processes."""

import os
import random
import time
from pathlib import Path

EXAMPLES = Path(__file__).resolve().parents[3] / "examples"
# The worker of the package, or that of a program: MESHMEND_WORKER=target/release/meshmend.
COMMAND = [os.environ["MESHMEND_WORKER"], "worker"] if "MESHMEND_WORKER" in os.environ else None
RUN_COLUMNS = {"attempts", "seconds", "cpu_seconds", "peak_bytes", "host"}


def write_meshes(folder, count):
    """Meshes with faces the wrong way round and one twice, in three formats; each tenth breaks off."""
    draw = random.Random(count)
    for number in range(count):
        place = Path(folder) / str(number % 7)
        place.mkdir(parents=True, exist_ok=True)
        side = draw.randint(3, 12)
        vertices = [(x, y, draw.random()) for x in range(side + 1) for y in range(side + 1)]
        corners = [x * (side + 1) + y for x in range(side) for y in range(side)]
        faces = [face for a in corners for face in ((a, a + side + 1, a + 1), (a + 1, a + side + 1, a + side + 2))]
        flipped = draw.randrange(len(faces))
        faces[flipped] = faces[flipped][::-1]
        faces.append(faces[0])
        points = "".join(f"{x} {y} {z}\n" for x, y, z in vertices)
        listed = "".join("3 {} {} {}\n".format(*face) for face in faces)
        ending, text = [
            ("off", f"OFF\n{len(vertices)} {len(faces)} 0\n{points}{listed}"),
            ("ply", "ply\nformat ascii 1.0\n" + f"element vertex {len(vertices)}\n"
             + "".join(f"property double {axis}\n" for axis in "xyz")
             + f"element face {len(faces)}\nproperty list uchar int vertex_indices\nend_header\n{points}{listed}"),
            ("obj", "".join(f"v {x} {y} {z}\n" for x, y, z in vertices)
             + "".join("f {} {} {}\n".format(*(corner + 1 for corner in face)) for face in faces)),
        ][number % 3]
        (place / f"{number}.{ending}").write_text(text[: len(text) // 2] if number % 10 == 9 else text)
    return str(folder)


def contents(folder):
    """The bytes of all files below a folder."""
    files = (path for path in Path(folder).rglob("*") if path.is_file())
    return {str(path.relative_to(folder)): path.read_bytes() for path in files}


def settled(table):
    """The rows by path, without the columns that may differ from run to run."""
    kept = [name for name in table.column_names if name not in RUN_COLUMNS]
    rows = table.select(kept)
    rows = rows.set_column(kept.index("mtime"), "mtime", rows["mtime"].cast("int64"))
    return {row["path"]: row for row in rows.to_pylist()}


def descendants(pid):
    """The processes that a process has started, and those that they have, by /proc."""
    parents = {}
    for entry in Path("/proc").iterdir():
        if entry.name.isdigit():
            try:
                fields = (entry / "stat").read_text().rpartition(")")[2].split()
            except OSError:
                continue
            if fields[0] != "Z":
                parents.setdefault(int(fields[1]), []).append(int(entry.name))
    found, left = set(), [pid]
    while left:
        children = parents.get(left.pop(), [])
        found.update(children)
        left += children
    return found


def workers_of(pid):
    """Those of its processes that are workers."""
    def is_worker(pid):
        try:
            words = Path(f"/proc/{pid}/cmdline").read_bytes().split(b"\0")
        except OSError:
            return False
        return b"meshmend._command" in words or b"worker" in words[1:2]

    return {child for child in descendants(pid) if is_worker(child)}


def is_gone(pid):
    """Whether a process has ended."""
    try:
        return Path(f"/proc/{pid}/stat").read_text().rpartition(")")[2].split()[0] == "Z"
    except OSError:
        return True


def eventually(holds, seconds=30):
    """Waits until something holds."""
    end = time.monotonic() + seconds
    while not holds():
        assert time.monotonic() < end, "it does not come to hold"
        time.sleep(0.02)


def strike(pid, *signals):
    """Sends signals to a process that may have ended."""
    for one in signals:
        try:
            os.kill(pid, one)
        except ProcessLookupError:
            pass
