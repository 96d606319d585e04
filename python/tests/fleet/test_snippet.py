"""The fragment of use on many files in a store, whose address and keys Daft was told."""

import sys
from pathlib import Path

import pytest

from .lake import EXAMPLES

daft = pytest.importorskip("daft", reason="daft is not here")


def test_15_a_lake_of_files(store, monkeypatch, request, tmp_path):
    from meshmend import fleet

    client, io_config = store
    monkeypatch.syspath_prepend(str(Path(__file__).resolve().parents[1]))
    sys.modules.pop("snippets", None)
    import snippets

    before = daft.context.get_context().daft_planning_config.default_io_config
    daft.set_planning_config(default_io_config=io_config)
    request.addfinalizer(lambda: daft.set_planning_config(default_io_config=before))
    client.create_bucket(Bucket="lake")
    broken = (EXAMPLES / "broken.obj").read_bytes()
    for name in ("a/one.obj", "b/two.obj"):
        client.put_object(Bucket="lake", Key=f"raw/{name}", Body=broken)
    plan = tmp_path / "asset.toml"
    plan.write_text("[orient]\nside = 'outward'\n")
    assert snippets.a_lake_of_files(plan) == {"mended": 2}
    mended = [client.get_object(Bucket="lake", Key=f"mended/{name}")["Body"].read() for name in ("a/one.obj", "b/two.obj")]
    assert mended[0] == mended[1] != broken
    assert snippets.a_lake_of_files(plan) == {"mended": 2}, "a second run finds nothing to do"
    assert fleet.read_table("s3://lake/rows/", io_config).num_rows == 2
