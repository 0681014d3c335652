"""Every example, and every new project, runs without a collision, and all that is drawn of it is checked."""

import json
from pathlib import Path

import pytest

from ropsim.cli.testing import main
from ropsim.userfiles import example_names

EXAMPLES = Path(__file__).parents[2] / "examples"
SHIPPED = sorted(one.name for one in EXAMPLES.iterdir() if (one / "cell.toml").is_file())


@pytest.mark.parametrize("name", SHIPPED)
def test_an_example_runs_without_a_collision_and_leaves_none_unchecked(
    name: str, capsys: pytest.CaptureFixture[str]
) -> None:
    assert main(["run", str(EXAMPLES / name), "--kinematic", "--json"]) == 0
    document = json.loads(capsys.readouterr().out)
    assert (document["result"]["errors"], document["result"]["warnings"]) == (0, 0)
    assert "collisions" not in document["result"]["unchecked"]
    ways = document["summary"]["facts"]["ways"]
    assert (ways["contacts"], ways["unseen"], ways["met"]) == ([], [], [])
    assert ways["clearance"]["distance"] >= 0.0


@pytest.mark.parametrize("arguments", [[], ["--robot", "irb120"], ["--robot", "puma560"]], ids=str)
def test_a_new_project_runs_without_a_collision(
    arguments: list[str], tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert main(["new", str(tmp_path / "made"), *arguments]) == 0
    capsys.readouterr()
    assert main(["run", str(tmp_path / "made"), "--kinematic", "--json"]) == 0
    document = json.loads(capsys.readouterr().out)
    assert document["summary"]["error_count"] == 0
    assert "collisions" not in document["result"]["unchecked"]


def test_the_examples_of_this_folder_are_those_of_the_command() -> None:
    assert [*sorted(example_names())] == SHIPPED
