"""Meshes, workers, drivers and a store, which are gone at the end."""

import signal
import socket
import subprocess
import sys

import pytest

from .lake import COMMAND, descendants, eventually, strike, write_meshes


@pytest.fixture
def meshes(tmp_path):
    """Makes a folder of so many meshes."""
    return lambda count: write_meshes(tmp_path / "in", count)


@pytest.fixture
def worker():
    """Makes workers, which are closed at the end."""
    from meshmend.fleet import Worker

    made = []

    def make(kind=Worker, **how):
        made.append(kind(**{"command": COMMAND, **how}))
        return made[-1]

    yield make
    for one in made:
        one.close()


@pytest.fixture
def driver(tmp_path):
    """Starts this Python with a program of its own; it and what it has started are killed at the end."""
    started = []

    def start(text, *words):
        script = tmp_path / f"driver{len(started)}.py"
        script.write_text(text)
        started.append(subprocess.Popen([sys.executable, str(script), *map(str, words)], stdout=subprocess.PIPE, text=True))
        return started[-1]

    yield start
    for process in started:
        for pid in [*descendants(process.pid), process.pid]:
            strike(pid, signal.SIGKILL)
        process.wait()
        process.stdout.close()


@pytest.fixture(scope="session")
def store():
    """A store that speaks S3 on this machine: its client for tests, and how Daft comes to it."""
    boto3 = pytest.importorskip("boto3", reason="boto3 is not here")
    pytest.importorskip("moto.server", reason="moto[server] is not here")
    daft = pytest.importorskip("daft", reason="daft is not here")
    with socket.socket() as free:
        free.bind(("127.0.0.1", 0))
        port = free.getsockname()[1]
    words = [sys.executable, "-m", "moto.server", "-H", "127.0.0.1", "-p", str(port)]
    process = subprocess.Popen(words, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    try:
        def answers():
            with socket.socket() as asked:
                return asked.connect_ex(("127.0.0.1", port)) == 0

        eventually(answers)
        address = f"http://127.0.0.1:{port}"
        client = boto3.client("s3", endpoint_url=address, aws_access_key_id="a", aws_secret_access_key="b", region_name="us-east-1")
        s3 = daft.io.S3Config(endpoint_url=address, key_id="a", access_key="b", region_name="us-east-1")
        yield client, daft.io.IOConfig(s3=s3)
    finally:
        process.kill()
        process.wait()
