"""The README's two commands are what runs on every system, by hand and in the workflow."""

import re
import subprocess
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]


def text(name: str) -> str:
    return (ROOT / name).read_text("utf-8")


def test_the_workflow_runs_the_two_commands_of_the_readme() -> None:
    two = re.findall(r"^    make (\w+) ", text("README.md"), re.MULTILINE)
    run = re.findall(r"^      - run: make .* (\w+)$", text(".github/workflows/systems.yml"), re.MULTILINE)
    assert run == two == ["demo", "test"]


@pytest.mark.parametrize("system", ["ubuntu", "macos", "windows"])
def test_the_workflow_has_each_system(system: str) -> None:
    assert re.search(rf"system: \[.*\b{system}-latest\b.*\]", text(".github/workflows/systems.yml"))


@pytest.mark.parametrize("folder", [".venv/bin", ".venv/Scripts"])
@pytest.mark.parametrize(
    "target", ["demo", "test", "test-rest", "test-all", "check", "bench", "docs", "pictures"]
)
def test_every_command_of_make_comes_from_the_folder_of_the_system(target: str, folder: str) -> None:
    done = subprocess.run(
        ["make", "--dry-run", f"BIN={folder}", target], cwd=ROOT, capture_output=True, text=True, check=True
    )
    folders = set(re.findall(r"\.venv/\w+", done.stdout))
    assert folders == {folder}
    assert f"VENV_BIN='{folder}' sh tools/venv.sh" in done.stdout


def test_text_files_have_the_same_line_ends_everywhere() -> None:
    """A shell script with the line ends of Windows does not run, and digests of sources would differ."""
    asked = ["tools/venv.sh", "examples/first_cell/programs/main.task", "docs/images/palletizing.svg"]
    done = subprocess.run(
        ["git", "check-attr", "eol", *asked], cwd=ROOT, capture_output=True, text=True, check=False
    )
    if done.returncode:
        pytest.skip("no git, or no clone of it")
    assert done.stdout.splitlines() == [f"{name}: eol: lf" for name in asked]
