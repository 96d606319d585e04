"""The code of docs/fleet.md for a map of one's own."""

import re
import shutil
from pathlib import Path

import pytest

from .lake import COMMAND, EXAMPLES

TEXT = (EXAMPLES.parent / "docs" / "fleet.md").read_text()


def block(word):
    """The piece of code that has a word."""
    return next(code for code in re.findall(r"```python\n(.*?)```", TEXT, re.DOTALL) if word in code)


@pytest.fixture
def paths(tmp_path, monkeypatch):
    """Files of this folder, mended by the worker of the package."""
    if COMMAND:
        pytest.skip("the code starts the worker of the package")
    monkeypatch.chdir(tmp_path)
    names = ["broken.obj", "pinched.ply", "scan.ply", "moebius.off"]
    for name in names:
        shutil.copy(EXAMPLES / name, name)
    return names


def test_threads(paths):
    names = {"paths": paths}
    exec(block("ThreadPoolExecutor"), names)
    assert [row["path"] for row in names["rows"]] == paths and all(Path("mended", path).is_file() for path in paths)


@pytest.mark.slow
def test_ray(paths, tmp_path):
    ray = pytest.importorskip("ray", reason="ray is not here")
    code = block("ActorPool").replace("/shared/", f"{tmp_path}/").replace("range(16)", "range(2)")
    names = {"paths": [str(tmp_path / path) for path in paths]}
    code = code.replace(' + path)', ' + path.rsplit("/", 1)[1])')
    ray.init(num_cpus=2, include_dashboard=False, object_store_memory=100 << 20, log_to_driver=False)
    try:
        exec(code, names)
    finally:
        ray.shutdown()
    assert {row["path"] for row in names["rows"]} == set(names["paths"])
    assert all((tmp_path / "mended" / path).is_file() for path in paths)
