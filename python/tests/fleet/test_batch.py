"""`meshmend batch` and the fleet have the same table of one folder, and the same results."""

import os
import subprocess
from pathlib import Path

import pytest

from .lake import COMMAND, EXAMPLES, contents, settled

ROOT = EXAMPLES.parent


def test_the_tables_of_batch_and_of_the_fleet_are_the_same(meshes, tmp_path):
    pytest.importorskip("daft", reason="daft is not here")
    from meshmend import fleet

    built = Path(os.environ.get("CARGO_TARGET_DIR", ROOT / "target"), "debug", "meshmend")
    program = COMMAND[0] if COMMAND else os.environ.get("MESHMEND") or str(built)
    if not Path(program).is_file():
        pytest.skip("the command is not built: cargo build --package meshmend-cli")
    source, ledger = meshes(60), f"{tmp_path}/ledger.jsonl"
    words = [program, "batch", source, "-o", f"{tmp_path}/batch", "--ledger", ledger, "--jobs", "2"]
    ran = subprocess.run(words, capture_output=True, text=True)
    assert ran.returncode == 1, ran.stderr  # Some files break off.
    fleet.mend(source, to=f"{tmp_path}/fleet", table=f"{tmp_path}/rows", command=COMMAND)
    by_batch, by_fleet = settled(fleet.read_table(ledger)), settled(fleet.read_table(f"{tmp_path}/rows"))
    for rows, folder in ((by_batch, "batch"), (by_fleet, "fleet")):
        for row in rows.values():
            row["output"] = row["output"] and os.path.relpath(row["output"], tmp_path / folder)
    assert by_batch == by_fleet
    assert contents(tmp_path / "batch") == contents(tmp_path / "fleet")
