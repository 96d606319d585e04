"""Many files with Daft on this machine: folders, a store, and a driver that is killed."""

import os
import random
import signal
import subprocess
import sys
import time
from pathlib import Path

import pytest

daft = pytest.importorskip("daft", reason="daft is not here")
pa = pytest.importorskip("pyarrow", reason="pyarrow is not here")

from meshmend import fleet  # noqa: E402
from meshmend.fleet import _jobs, _table  # noqa: E402

from .lake import COMMAND, contents, descendants, eventually, is_gone, settled, strike, workers_of  # noqa: E402

# Starts a mend as a process of its own: its source, the folders of results and of rows.
DRIVER = f"""
import sys
from meshmend import fleet
fleet.mend(sys.argv[1], to=sys.argv[2], table=sys.argv[3], timeout=60, concurrency=2, command={COMMAND!r})
"""


def mend(source, folder, **how):
    to, table = f"{folder}/out", f"{folder}/rows"
    return fleet.mend(source, to=to, table=table, **{"command": COMMAND, "concurrency": 2, **how}), fleet.read_table(table)


def test_a_folder_has_a_row_and_a_result_for_each_file(meshes, tmp_path, worker):
    source = meshes(60)
    Path(source, "notes.txt").write_text("no mesh")
    ended, table = mend(source, tmp_path)
    assert table.schema == fleet.SCHEMA and sum(ended.values()) == table.num_rows == 60
    rows, results = settled(table), contents(tmp_path / "out")
    names = {str(path) for path in Path(source).rglob("*.*") if path.suffix != ".txt"}
    assert set(rows) == names and ended["mended"] == 54
    alone = worker()
    for path, row in rows.items():
        below = os.path.relpath(path, source)
        assert (row["size"], row["mtime"]) == (os.stat(path).st_size, os.stat(path).st_mtime_ns)
        if row["status"] != "unreadable":
            assert row["output"] == f"{tmp_path}/out/{below}"
            assert alone.run(Path(path).read_bytes(), True, name=path)[1] == results.pop(below)
        else:
            assert row["output"] is None and row["message"]
    assert not results and not any(Path(tmp_path, "rows").glob(".*"))
    shown = fleet.summary(str(tmp_path / "rows"))
    assert shown["status"] == ended and shown["defects"]["duplicate-face"] == 54
    alone.close()
    eventually(lambda: not workers_of(os.getpid()))


def test_what_is_done_is_not_done_again(meshes, tmp_path):
    source = meshes(20)
    ended, first = mend(source, tmp_path)
    parts = contents(tmp_path / "rows")
    assert mend(source, tmp_path)[0] == ended and contents(tmp_path / "rows") == parts
    (tmp_path / "out" / "0" / "0.off").unlink()  # A result that is gone,
    Path(source, "1", "1.ply").write_text("ply\n")  # a file that is another one,
    Path(source, "8.obj").write_text("v 0 0 0\n")  # and a new one.
    _, then = mend(source, tmp_path)
    assert (tmp_path / "out" / "0" / "0.off").is_file()
    before, after = settled(first), settled(then)
    changed = {os.path.relpath(path, source) for path in after if after[path] != before.get(path)}
    assert changed == {"1/1.ply", "8.obj"}
    new = contents(tmp_path / "rows").keys() - parts.keys()
    assert sum(fleet.read_table(f"{tmp_path}/rows/{part}").num_rows for part in new) == 3
    # Another policy is another result, and a status may be asked for.
    _, other = mend(source, tmp_path, options=["--orient", "outward"])
    assert {row["plan_digest"] for row in settled(other).values()}.isdisjoint(row["plan_digest"] for row in after.values())
    parts = contents(tmp_path / "rows").keys()
    mend(source, tmp_path, options=["--orient", "outward"], retry={"unreadable"})
    new = contents(tmp_path / "rows").keys() - parts
    again = [row for part in new for row in settled(fleet.read_table(f"{tmp_path}/rows/{part}")).values()]
    assert len(again) == 3 and {row["status"] for row in again} == {"unreadable"}
    whole = settled(fleet.read_table(f"{tmp_path}/rows"))
    assert settled(fleet.compact(f"{tmp_path}/rows")) == whole == settled(fleet.read_table(f"{tmp_path}/rows"))
    assert len(contents(tmp_path / "rows")) == 1
    mend(source, tmp_path, resume=False)
    assert len(contents(tmp_path / "rows")) > 1


def test_globs_formats_and_names_with_odd_letters(meshes, tmp_path):
    source = meshes(21)
    odd = Path(source, "a [x] %20 ü")
    odd.mkdir()
    Path(source, "0", "0.off").rename(odd / "{0}.off")
    ended, table = mend([f"{source}/**/*.off", f"{source}/1/*.obj", str(odd)], tmp_path, format="ply")
    outputs = {row["output"] for row in settled(table).values() if row["output"]}
    assert outputs == {str(path) for path in (tmp_path / "out").rglob("*") if path.is_file()}
    assert {os.path.splitext(output)[1] for output in outputs} == {".ply"} and sum(ended.values()) == table.num_rows
    assert fleet.check(f"{source}/1/", table=f"{tmp_path}/checked", command=COMMAND)
    assert {row["output"] for row in settled(fleet.read_table(f"{tmp_path}/checked")).values()} == {None}


def test_what_can_not_be_asked_for_is_said_before_any_work(meshes, tmp_path):
    source = meshes(3)
    with pytest.raises(ValueError, match="is an input"):
        fleet.mend(source, to=source, table=f"{tmp_path}/rows", command=COMMAND)
    Path(source, "0", "0.obj").write_text("v 0 0 0\n")
    with pytest.raises(ValueError, match="that of another file"):
        mend(source, tmp_path, format="stl")
    with pytest.raises(FileNotFoundError):
        mend(f"{tmp_path}/none/*.obj", tmp_path)
    with pytest.raises(fleet.WorkerError, match="--nonsense"):
        mend(source, tmp_path, options=["--nonsense"])
    assert not (tmp_path / "out").exists() and not (tmp_path / "rows").exists()
    # Results below the source are none of its files.
    first = fleet.mend(source, to=f"{source}/mended", table=f"{tmp_path}/rows", command=COMMAND)
    assert fleet.mend(source, to=f"{source}/mended", table=f"{tmp_path}/rows", command=COMMAND) == first


def test_parts_are_no_longer_than_they_may_be(tmp_path, monkeypatch, worker):
    monkeypatch.setattr(_table, "ROWS_OF_A_PART", 10)
    row = worker().template("a.obj")
    rows = [{**row, "path": f"{number}.obj"} for number in range(25)]
    assert [one for batch in _table.kept(([one] for one in rows), f"{tmp_path}/rows", None) for one in batch] == rows
    table = fleet.read_table(f"{tmp_path}/rows")
    assert table["path"].to_pylist() == [f"{number}.obj" for number in range(25)]
    assert len(contents(tmp_path / "rows")) == 3
    assert table.schema == fleet.SCHEMA


def test_a_ledger_of_lines_is_read_as_parts_are(tmp_path, worker):
    import json

    row = {**worker().template("a.obj"), "mtime": "2026-01-02T03:04:05.000000006Z", "defects": {"pinched-vertex": 2}}
    lines = [{**row, "status": "crashed"}, {**row, "path": "b.obj"}, row]
    torn = json.dumps({**row, "path": "c.obj"})[:-5]
    (tmp_path / "ledger.jsonl").write_text("".join(json.dumps(line) + "\n" for line in lines) + torn)
    table = fleet.read_table(str(tmp_path / "ledger.jsonl"))
    rows = settled(table)
    assert table.schema == fleet.SCHEMA and set(rows) == {"a.obj", "b.obj"}
    assert rows["a.obj"]["status"] == row["status"] and rows["a.obj"]["mtime"] % 10**9 == 6
    _table.put_parts(f"{tmp_path}/rows", table, None)
    assert settled(fleet.read_table(f"{tmp_path}/rows")) == rows


def test_the_columns_are_those_of_the_schema_of_rows():
    import json

    path = Path(__file__).resolve().parents[3] / "schemas" / "row.json"
    if not path.is_file():
        pytest.skip("schemas/row.json is not here")
    schema = json.loads(path.read_text())
    assert set(fleet.SCHEMA.names) == set(schema["properties"])
    figures = {fleet.SCHEMA.field("before").type.field(at).name for at in range(fleet.SCHEMA.field("before").type.num_fields)}
    assert figures == set(schema["$defs"]["RowFigures"]["properties"])


def test_a_driver_that_is_killed_at_any_moment_is_made_up_for(meshes, tmp_path, driver):
    source = meshes(300)
    ended, whole = mend(source, tmp_path / "undisturbed")
    draw = random.Random(7)
    to, table = tmp_path / "out", tmp_path / "rows"
    for _ in range(3):
        process = driver(DRIVER, source, to, table)
        eventually(lambda: contents(to) if to.exists() else process.poll() is not None)
        time.sleep(draw.random())
        left = descendants(process.pid)
        process.kill()
        eventually(lambda: all(map(is_gone, left)))
    assert mend(source, tmp_path)[0] == ended
    assert settled_below(fleet.read_table(str(table)), to) == settled_below(whole, tmp_path / "undisturbed" / "out")
    assert contents(to) == contents(tmp_path / "undisturbed" / "out")


def settled_below(table, folder):
    """Rows whose outputs are named below their folder."""
    rows = settled(table)
    for row in rows.values():
        row["output"] = row["output"] and os.path.relpath(row["output"], folder)
    return rows


def test_a_store_is_mended_as_a_folder_is(meshes, tmp_path, store, monkeypatch):
    client, io_config = store
    source, bucket = meshes(40), f"lake{os.getpid()}"
    client.create_bucket(Bucket=bucket)
    for below, data in contents(source).items():
        client.put_object(Bucket=bucket, Key=f"raw/{below}", Body=data)
    where = {"to": f"s3://{bucket}/mended/", "table": f"s3://{bucket}/rows/", "io_config": io_config, "command": COMMAND}
    ended, (_, local) = fleet.mend(f"s3://{bucket}/raw/**/*.*", **where), mend(source, tmp_path)
    table = fleet.read_table(where["table"], io_config)
    rows = {path.removeprefix(f"s3://{bucket}/raw/"): row for path, row in settled(table).items()}
    assert rows.keys() == contents(source).keys() and sum(ended.values()) == 40
    for path, other in settled(local).items():
        row = rows[os.path.relpath(path, source)]
        for name in ("status", "size", "input_sha256", "output_sha256", "plan_digest", "before", "after", "defects", "format_out"):
            assert row[name] == other[name], (path, name)
        assert (row["output"] is None) == (other["output"] is None) and row["mtime"]
    def objects(prefix):
        listed = client.list_objects_v2(Bucket=bucket, Prefix=prefix).get("Contents", [])
        return {one["Key"].removeprefix(prefix): client.get_object(Bucket=bucket, Key=one["Key"])["Body"].read() for one in listed}

    assert objects("mended/") == contents(tmp_path / "out")
    parts = objects("rows/")
    assert fleet.mend(f"s3://{bucket}/raw/", **where) == ended and objects("rows/") == parts
    fleet.compact(where["table"], io_config)
    assert sum(map(bool, objects("rows/").values())) == 1  # And what stands for the folder.
    assert settled(fleet.read_table(where["table"], io_config)) == settled(table)
    # A store that refuses, and files that go through a folder, since they are too large for pipes.
    refused = fleet.mend(f"s3://{bucket}/raw/0/", **{**where, "to": "s3://nowhere/", "table": f"{tmp_path}/refused"})
    assert refused == {"unwritable": 6}
    mender = _jobs._Mender(fleet.Worker(command=COMMAND), None, None, io_config)
    monkeypatch.setattr(_jobs, "BYTES_THROUGH_PIPES", 10)
    import json

    row = json.loads(mender.mended(f"s3://{bucket}/raw/0/0.off", 100, None, f"s3://{bucket}/large/0.off"))
    assert row["output"] == f"s3://{bucket}/large/0.off" and objects("large/")["0.off"] == objects("mended/0/")["0.off"]
    assert row["output_sha256"] == rows["0/0.off"]["output_sha256"].hex()
    assert json.loads(mender.mended(f"s3://{bucket}/none.off", 100, None, None))["status"] == "missing"
    mender.worker.close()


def test_two_thousand_files_come_through_whatever_is_killed(meshes, tmp_path, driver):
    source = meshes(2000)
    ended, whole = mend(source, tmp_path / "undisturbed")
    draw, struck = random.Random(11), 0
    to, table = tmp_path / "out", tmp_path / "rows"
    process = driver(DRIVER, source, to, table)
    while process.poll() is None:
        time.sleep(draw.random() * 0.4)
        workers = sorted(workers_of(process.pid))
        if workers:
            strike(draw.choice(workers), signal.SIGKILL)
            struck += 1
            if struck == 4:
                process.kill()
                process = driver(DRIVER, source, to, table)
    assert process.returncode == 0 and struck >= 8
    # One that was struck twice at the same file.
    assert mend(source, tmp_path, retry={"crashed"})[0] == ended
    assert settled_below(fleet.read_table(str(table)), to) == settled_below(whole, tmp_path / "undisturbed" / "out")
    assert contents(to) == contents(tmp_path / "undisturbed" / "out")
    assert sum(ended.values()) == 2000


def test_the_command_line(meshes, tmp_path):
    source = meshes(9)
    if COMMAND:
        pytest.skip("the command line starts the worker of the package")

    def run(*words):
        ran = subprocess.run([sys.executable, "-m", "meshmend.fleet", *words], capture_output=True, text=True)
        return ran.returncode, ran.stdout, ran.stderr

    status, shown, _ = run("mend", source, "--to", f"{tmp_path}/out", "--table", f"{tmp_path}/rows", "--timeout", "60")
    assert (status, shown) == (0, '{"files": 9, "status": {"mended": 9}}\n')
    Path(source, "torn.off").write_text("OFF\n3 ")
    assert run("check", source, "--table", f"{tmp_path}/checked")[0] == 1
    assert '"files": 9' in run("compact", f"{tmp_path}/rows")[1]
    assert run("mend", source)[0] == 2
