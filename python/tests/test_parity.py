"""The reports of the package are those of the command, to the byte."""

import json
import warnings

import meshmend as mm
import pytest
from conftest import EXAMPLES, corpus
from meshmend import _native

FILES = sorted(path for path in EXAMPLES.iterdir() if path.suffix in {".obj", ".off", ".ply", ".stl", ".glb"})

# Each policy, and those that meet, as the command's own tests combine them.
POLICIES = [
    {},
    {"weld": "none"},
    {"weld": "0.001%"},
    {"weld": "single", "split": "cut"},
    {"clean": False},
    {"non_finite": "keep", "repeated": "drop"},
    {"orient": "outward", "split": "pinch-only"},
    {"orient": "outward-nested", "duplicates": "remove-pair"},
    {"orient": "off", "split": "off"},
    {"non_orientable": "cut", "duplicates": "keep-first"},
    {"triangulate": "all", "compact": "keep-loose"},
    {"triangulate": "off", "compact": "off"},
    {"fill": "all", "fill_rims": True, "fill_by": "fan"},
    {"fill": "edges:12,length:50%"},
    {"heal": "exact", "slivers": 1000, "max_move": "0.1%"},
    {"drop_components": "faces:2", "internal": "remove-faces"},
    {"outward": "nested", "flipped_normals": "keep"},
]


def words_of(policies):
    """Keywords as a command line has them."""
    for name, value in policies.items():
        option = "--" + name.replace("_", "-")
        if value is not True:
            yield from (option, "off" if value is False else str(value))
        else:
            yield option


def assert_same_repair(command, path, policies, maps=False, limit=10):
    words = [*words_of(policies), "--limit", str(limit), *(["--report-maps"] if maps else [])]
    ran = command("repair", "--json", "--dry-run", "--allow-empty", *words, path)
    document = None
    try:
        document = mm.repair(path, allow_empty=True, **policies).to_json(limit, maps)
    except (mm.MeshmendError, ValueError) as error:
        assert ran.returncode != 0, (error, ran.stdout)
        assert mentions(ran.stderr.decode(), str(error)), (ran.stderr.decode(), str(error))
        return
    assert ran.returncode == 0, ran.stderr.decode()
    assert document.encode() + b"\n" == ran.stdout, first_difference(document, ran.stdout)


def mentions(said, message):
    """Whether the command gives the same reason: places and options are spelled in other ways."""
    return message.rsplit(": ", 1)[-1].replace("-", "") in said.replace("-", "")


def first_difference(document, printed):
    one, other = json.loads(document), json.loads(printed)
    return {key: (one.get(key), other.get(key)) for key in one.keys() | other.keys() if one.get(key) != other.get(key)}


@pytest.mark.parametrize("policies", POLICIES, ids=lambda policies: " ".join(words_of(policies)) or "default")
@pytest.mark.parametrize("path", FILES, ids=lambda path: path.name)
def test_the_report_of_a_repair_is_that_of_the_command(command, path, policies):
    assert_same_repair(command, path, policies)


@pytest.mark.parametrize("path", FILES, ids=lambda path: path.name)
def test_with_maps_and_questions_and_longer_lists_too(command, path):
    assert_same_repair(command, path, {}, maps=True, limit=1000)
    assert_same_repair(command, path, {}, limit=0)
    ran = command("repair", "--json", "--dry-run", "--geometry", "--", path)
    assert mm.repair(path, geometry=True).to_json().encode() + b"\n" == ran.stdout
    plan = EXAMPLES / "plan.toml"
    ran = command("repair", "--json", "--dry-run", "--plan", plan, "--weld", "exact", path)
    assert mm.repair(path, plan=plan, weld="exact").to_json().encode() + b"\n" == ran.stdout


@pytest.mark.parametrize("preset", _native.registries()["presets"])
@pytest.mark.parametrize("path", FILES, ids=lambda path: path.name)
def test_a_preset_is_that_of_the_command(command, path, preset, tmp_path):
    ran = command("repair", "--json", "--dry-run", "--allow-empty", "--limit", "10", "--preset", preset, path)
    try:
        document = mm.repair(path, preset=preset, allow_empty=True).to_json()
    except (mm.MeshmendError, ValueError) as error:
        assert mentions(ran.stderr.decode(), str(error))
        return
    assert document.encode() + b"\n" == ran.stdout, first_difference(document, ran.stdout)
    plan = tmp_path / "over.toml"
    plan.write_text("[weld]\ndistance = 'exact'\n")
    ran = command("repair", "--json", "--dry-run", "--allow-empty", "--limit", "10", "--preset", preset, "--plan", plan, path)
    assert mm.repair(path, preset=preset, plan=plan, allow_empty=True).to_json().encode() + b"\n" == ran.stdout


def assert_same_output(command, path, folder, suffix):
    here, there = folder / "here", folder / "there"
    here.mkdir()
    there.mkdir()
    here, there = here / f"out{suffix}", there / f"out{suffix}"
    ran = command("repair", path, "--output", there)
    if ran.returncode:
        with pytest.raises((mm.MeshmendError, ValueError)):
            mm.repair(path, output=here).write(here)
        assert not here.exists()
        return
    mended = mm.repair(path, output=there)
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", mm.LossWarning)
        mended.write(here)
    assert here.read_bytes() == there.read_bytes()
    told = command("repair", "--json", "--dry-run", path, "--output", there)
    assert mended.to_json().encode() + b"\n" == told.stdout


@pytest.mark.parametrize("suffix", [".obj", ".ply", ".stl", ".glb"])
@pytest.mark.parametrize("path", FILES, ids=lambda path: path.name)
def test_the_output_is_that_of_the_command(command, path, tmp_path, suffix):
    assert_same_output(command, path, tmp_path, suffix)


@pytest.mark.skipif(not corpus(), reason="there is no ../shared/corpus here")
@pytest.mark.parametrize("path", corpus(), ids=lambda path: "/".join(path.parts[-2:]))
def test_the_output_for_a_corpus_file_is_that_of_the_command(command, path, tmp_path):
    assert_same_output(command, path, tmp_path, path.suffix.lower())


@pytest.mark.skipif(not corpus(), reason="there is no ../shared/corpus here")
@pytest.mark.parametrize("path", corpus(), ids=lambda path: "/".join(path.parts[-2:]))
def test_the_report_of_a_corpus_file_is_that_of_the_command(command, path):
    number = sum(path.name.encode())
    assert_same_repair(command, path, {})
    assert_same_repair(command, path, POLICIES[1 + number % (len(POLICIES) - 1)], maps=number % 2 == 0)
