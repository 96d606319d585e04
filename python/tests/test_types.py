"""What the types say is what there is: words and options of the registries, and the snippets under a strict type checker."""

import ast
import re
import subprocess
import sys
from pathlib import Path

import meshmend as mm
import pytest
from meshmend import _native

STUB = Path(mm.__file__).with_name("__init__.pyi")
TESTS = Path(__file__).parent
SOURCE = TESTS.parent / "python" / "meshmend" / "__init__.pyi"
REGISTRIES = _native.registries()


def classes():
    tree = ast.parse(STUB.read_text())
    return {node.name: node for node in tree.body if isinstance(node, ast.ClassDef)}


def words_of(alias):
    """The words of a list of literals."""
    for node in ast.parse(STUB.read_text()).body:
        if isinstance(node, ast.AnnAssign) and node.target.id == alias:
            return [word.value for word in ast.walk(node.value) if isinstance(word, ast.Constant)]
    raise AssertionError(f"there is no {alias}")


@pytest.mark.parametrize("alias, registry", [
    ("_Kind", "kinds"), ("_PassName", "passes"), ("_Kernel", "kernels"), ("_RepairKernel", "repair_kernels"),
    ("_Question", "questions"), ("_Witness", "witnesses"), ("_Variant", "variants"), ("_Format", "formats"), ("_Shape", "shapes"),
    ("_Preset", "presets"),
])
def test_each_list_of_words_is_that_of_its_registry(alias, registry):
    assert words_of(alias) == REGISTRIES[registry]


def test_each_option_of_a_pass_has_its_words():
    options = {node.target.id: node.annotation for node in classes()["_Policies"].body}
    assert list(options) == [name.replace("-", "_") for name in REGISTRIES["options"]]
    for name, (takes, words, _) in REGISTRIES["options"].items():
        constants = [node.value for node in ast.walk(options[name.replace("-", "_")]) if isinstance(node, ast.Constant)]
        texts = [word for word in constants if isinstance(word, str)]
        if takes == "words":
            assert texts == words, name
        assert (False in [word for word in constants if isinstance(word, bool)]) == ("off" in words), name


def test_each_option_is_there_in_each_call_that_takes_it():
    tree = {node.name: node for node in ast.parse(STUB.read_text()).body if isinstance(node, ast.FunctionDef)}
    for function, options in (("check", "_CheckOptions"), ("write", "_WriteOptions"), ("read_document", "_ReadOptions")):
        keywords = [keyword.arg for keyword in tree[function].args.kwonlyargs]
        own = [node.target.id for node in classes()[options].body] + ["threads", "progress"]
        assert keywords == own, function
    keywords = [keyword.arg for keyword in tree["repair"].args.kwonlyargs]
    assert keywords == [node.target.id for node in classes()["_RepairOptions"].body] + ["threads", "progress"]


def run(*words):
    return subprocess.run([sys.executable, "-m", *words], capture_output=True, text=True, cwd=TESTS.parent)


def test_the_snippets_have_the_types_that_they_use():
    pytest.importorskip("mypy", reason="mypy is not installed")
    ran = run("mypy", "--strict", "--no-error-summary", str(SOURCE), str(TESTS / "snippets.py"))
    assert ran.returncode == 0, ran.stdout + ran.stderr


def test_words_that_do_not_exist_are_type_errors(tmp_path):
    pytest.importorskip("mypy", reason="mypy is not installed")
    wrong = tmp_path / "wrong.py"
    wrong.write_text(
        "import meshmend as mm\n"
        'mm.repair("a.obj", split="cuts")\n'
        'mm.repair("a.obj", spilt="cut")\n'
        'mm.check("a.obj").require("boundary-edges")\n'
        'mm.Plan("mend")\n'
        'mm.repair("a.obj", split="cut", weld=0.1, clean=False, fill="all", fill_rims=True)\n'
    )
    ran = run("mypy", "--strict", "--no-error-summary", str(wrong))
    assert sorted({int(line) for line in re.findall(r"wrong\.py:(\d+): error", ran.stdout)}) == [2, 3, 4, 5], ran.stdout + ran.stderr


def test_the_stub_is_the_module():
    pytest.importorskip("mypy", reason="mypy is not installed")
    ran = run("mypy.stubtest", "meshmend", "--mypy-config-file", "mypy.ini", "--allowlist", "stubtest.allow")
    assert ran.returncode == 0, ran.stdout + ran.stderr
