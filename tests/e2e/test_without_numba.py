"""An installation without numba and llvmlite: all commands work, and a simulation says that it is slow.

Each process imports a module that lets both be absent, as on a system for which there are no wheels of them.
"""

import json
import os
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

from ropsim.lsp.testing import FrameReader, framed
from ropsim.workbench import new_project
from support.patience import PATIENCE
from support.studio_client import command, page_of
from support.studio_process import Studio

pytestmark = pytest.mark.slow

ABSENT = """
import sys
for name in ("numba", "llvmlite"):
    sys.modules[name] = None
"""
NOTE = "numba is not installed or is switched off: plain Python simulates, many times slower"
TWO_ENGINES = 1e-9  # elementary functions of two libraries, in the duration of a program [s]
EXAMPLES = Path(__file__).parents[2] / "examples"


@pytest.fixture(autouse=True)
def no_numba(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Let all processes that are started be without numba."""
    (tmp_path / "absent").mkdir()
    (tmp_path / "absent" / "sitecustomize.py").write_text(ABSENT, "utf-8")
    before = os.environ.get("PYTHONPATH")
    monkeypatch.setenv("PYTHONPATH", os.pathsep.join([str(tmp_path / "absent"), *filter(None, [before])]))


@pytest.fixture
def cell(tmp_path: Path) -> Path:
    return new_project(tmp_path / "cell", "first_cell")


def ropsim(*arguments: object, sent: bytes = b"") -> tuple[str, str]:
    """Return what a command that succeeds prints to standard output and standard error."""
    done = subprocess.run(
        [sys.executable, "-m", "ropsim", *map(str, arguments)],
        input=sent,
        capture_output=True,
        timeout=PATIENCE,
        check=False,
    )
    assert done.returncode == 0, done.stderr.decode()
    return done.stdout.decode(), done.stderr.decode()


def test_numba_is_absent_in_these_processes() -> None:
    program = "from importlib.util import find_spec; print(find_spec('numba'), find_spec('llvmlite'))"
    done = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True, check=True)
    assert done.stdout == "None None\n"


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        (("check", EXAMPLES / "palletizing"), "no errors"),
        (("fmt", "--check", EXAMPLES / "palletizing"), "form"),
        (("icr", "compile", EXAMPLES / "fig5" / "programs" / "main.task"), "END"),
        (("robot", "ik", "puma560", 540, -55, 955, 170, 10, -170), "right-up-flip"),
        (("task", "check", EXAMPLES / "palletizing", "grip infeed"), "accepted"),
        (("explain", "M502"), "joint-out-of-range"),
    ],
    ids=lambda one: "-".join(map(str, one[:2])) if isinstance(one, tuple) else "",
)
def test_commands_that_simulate_nothing_work_as_ever(arguments: tuple[object, ...], said: str) -> None:
    out, errors = ropsim(*arguments)
    assert said in out
    assert NOTE not in errors


@pytest.mark.parametrize("ending", [".urdf", ".xml", ".toml"])
def test_a_robot_is_exported(tmp_path: Path, ending: str) -> None:
    place = tmp_path / f"puma{ending}"
    ropsim("robot", "export", "puma560", place)
    assert place.stat().st_size > 1000


def test_the_language_server_answers() -> None:
    messages: list[dict[str, object]] = [
        {"id": 1, "method": "initialize", "params": {"capabilities": {}}},
        {"method": "initialized", "params": {}},
        {"id": 9, "method": "shutdown"},
        {"method": "exit"},
    ]
    sent = b"".join(framed(json.dumps({"jsonrpc": "2.0", **one}).encode()) for one in messages)
    out, errors = ropsim("lsp", sent=sent)
    answers = [json.loads(one) for one in FrameReader().feed(out.encode()) if isinstance(one, bytes)]
    assert [one["id"] for one in answers if "id" in one] == [1, 9]
    assert errors == ""


def test_a_run_says_that_it_is_slow_beside_its_document_and_has_the_same_recording(
    cell: Path, tmp_path: Path
) -> None:
    recordings = tmp_path / "slow.npz", tmp_path / "fast.npz"
    out, errors = ropsim("run", cell, "--kinematic", "--json", "--record", recordings[0])
    assert errors.count(NOTE) == 1
    assert NOTE not in out
    os.environ.pop("PYTHONPATH")  # until the fixture puts it back
    compiled, said = ropsim("run", cell, "--kinematic", "--json", "--record", recordings[1])
    assert NOTE not in said
    slow, fast = (json.loads(one)["result"] for one in (out, compiled))
    assert slow["cycle_time"] == pytest.approx(fast["cycle_time"], abs=TWO_ENGINES)
    one, other = map(np.load, recordings)
    assert one.files == other.files
    for name in one.files:
        if name.endswith("orientation"):  # a quaternion and its negative are the same
            np.testing.assert_allclose(abs((one[name] * other[name]).sum(axis=1)), 1.0, atol=TWO_ENGINES)
        elif one[name].dtype.kind == "f":
            np.testing.assert_allclose(one[name], other[name], rtol=TWO_ENGINES, atol=TWO_ENGINES)


def test_the_studio_shows_a_project_and_simulates_it(cell: Path, tmp_path: Path) -> None:
    with Studio(cell, tmp_path, command=command(tmp_path)) as studio, page_of(studio) as page:
        page.hear("welcome")
        assert page.hear("scene")["scene"]["stations"][0]["robot"] == "puma560"
        page.hear("run", state="running", message=NOTE)
        assert not [one for one in page.hear("run", state="done")["findings"] if one["severity"] == "error"]
