"""Many files on a cluster of two nodes on this machine, of which one is killed: `pytest -m slow`, about 15 s of a processor."""

import pytest

from .lake import COMMAND, contents, settled

pytestmark = pytest.mark.slow

DRIVER = """
import sys
import ray
from ray.cluster_utils import Cluster

source, to, table, command = sys.argv[1], sys.argv[2], sys.argv[3], sys.argv[4:] or None
small = {"num_cpus": 1, "object_store_memory": 100 << 20}
cluster = Cluster(initialize_head=True, head_node_args={**small, "include_dashboard": False})
node = cluster.add_node(**small)
ray.init(address=cluster.address, log_to_driver=False)
import daft

daft.set_runner_ray(address=cluster.address)
from meshmend import fleet

nodes = []


def progress(step, done, total):
    if done > total / 3 and not nodes:
        nodes.append(done)
        cluster.remove_node(node, allow_graceful=False)


ended = fleet.mend(source, to=to, table=table, timeout=60, command=command, progress=progress)
assert nodes, "no node was killed"
print(ended, ray.cluster_resources()["CPU"])
ray.shutdown()
cluster.shutdown()
"""


def test_a_node_that_is_killed_is_made_up_for(meshes, tmp_path, driver):
    pytest.importorskip("ray", reason="ray is not here")
    pytest.importorskip("daft", reason="daft is not here")
    from meshmend import fleet

    source = meshes(300)
    ended = fleet.mend(source, to=f"{tmp_path}/undisturbed", table=f"{tmp_path}/rows", command=COMMAND)
    process = driver(DRIVER, source, tmp_path / "out", tmp_path / "found", *(COMMAND or ()))
    assert process.wait(240) == 0
    found = settled(fleet.read_table(f"{tmp_path}/found"))
    rows = settled(fleet.read_table(f"{tmp_path}/rows"))
    assert sum(ended.values()) == len(found) == 300
    for path, row in rows.items():
        other = found[path]
        outputs = [one.pop("output") for one in (row, other)]
        assert row == other and (outputs[0] is None) == (outputs[1] is None)
    # None is missing, none half written, none left beside.
    assert contents(tmp_path / "out") == contents(tmp_path / "undisturbed")
