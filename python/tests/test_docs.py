"""The code in the documents runs, statement by statement, on inputs of the names that it uses."""

import ast
import re
import shutil
import warnings

import meshmend as mm
import numpy as np
import pytest
from conftest import EXAMPLES, ROOT

DOCUMENTS = [ROOT / "python" / "README.md", ROOT / "README.md"]


@pytest.mark.parametrize("document", DOCUMENTS, ids=lambda path: str(path.relative_to(ROOT)))
def test_the_code_of_a_document_runs(document, tmp_path, monkeypatch):
    trimesh = pytest.importorskip("trimesh", reason="trimesh is not installed")
    pytest.importorskip("pyvista", reason="PyVista is not installed")
    monkeypatch.chdir(tmp_path)
    shutil.copytree(EXAMPLES, tmp_path / "examples", ignore=shutil.ignore_patterns("target", "python"))
    scan = mm.make("surface", genus=1, holes=1, triangles=True)
    scan.write("scan.ply")
    shutil.copy(EXAMPLES / "box.glb", "car.glb")
    vertices, faces = np.array(scan.vertices), np.array(scan.faces)
    names = {"vertices": vertices, "faces": faces, "labels": np.arange(len(faces)), "a_trimesh": trimesh.Trimesh(vertices, faces)}
    blocks = re.findall(r"```python\n(.*?)```", document.read_text(), re.DOTALL)
    assert blocks
    for block in blocks:
        for statement in ast.parse(block).body:
            code = ast.unparse(statement)
            if "labels" in code:
                names["labels"] = np.arange(len(names["mended"].faces.new_of_old))
            with warnings.catch_warnings():
                warnings.simplefilter("ignore", mm.LossWarning)
                try:
                    exec(compile(code, str(document), "exec"), names)
                except mm.DefectError:
                    assert ".require(" in code, code
