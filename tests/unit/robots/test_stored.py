"""Robots that come as NIROX files: they are what the tool makes of the facts, and right files."""

import os
import re
import subprocess
import sys
from pathlib import Path

import pytest
from tools import robot_library, robot_page

from ropsim import robots
from ropsim.core import SourceText
from ropsim.nirox import read_nirox, read_valid_nirox
from ropsim.robots.library import stored_names


def text(name: str) -> SourceText:
    return SourceText(f"{name}.stp", (robot_library.TARGET / f"{name}.stp").read_text("ascii"))


def test_the_files_are_what_the_tool_writes() -> None:
    assert robot_library.main(["--check"]) == 0


def test_the_files_are_the_same_on_every_processor() -> None:
    """With the matrix products of an old one, whose sums differ in their last digits."""
    command = [sys.executable, "-m", "tools.robot_library", "--check"]
    old = {**os.environ, "OPENBLAS_CORETYPE": "Prescott"}
    done = subprocess.run(command, check=False, env=old, capture_output=True, text=True)
    assert (done.returncode, done.stdout) == (0, "")


def test_the_page_of_the_robots_and_its_pictures_are_of_these_models() -> None:
    assert robot_page.main(["--check"]) == 0


def test_a_stale_file_is_told(monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]) -> None:
    written = dict.fromkeys(f"{name}.stp" for name in stored_names())
    changed = {name: text(name.removesuffix(".stp")).text for name in written}
    changed["gp7.stp"] += "\n"
    changed[robots.INDEX] = robot_library.TARGET.joinpath(robots.INDEX).read_text("utf-8")
    monkeypatch.setattr(robot_library, "texts", lambda: changed)
    assert robot_library.main(["--check"]) == 1
    assert capsys.readouterr().out == "stale: gp7.stp; run python -m tools.robot_library\n"


@pytest.mark.parametrize("name", ["irb120", "ur5e"])
def test_a_file_is_valid_and_read_with_trust_the_same(name: str) -> None:
    read = read_nirox(text(name))
    assert read.robot == robots.load(name)
    assert read.findings == ()


def test_a_file_that_says_something_impossible_is_not_trusted() -> None:
    limits = re.compile(r"(REVOLUTE_PAIR_WITH_RANGE.*),([-.\d]+),([-.\d]+)\);")
    turned = limits.sub(r"\1,\3,\2);", text("gp7").text)
    with pytest.raises(ValueError, match=r"a\.stp has no robot"):
        read_valid_nirox(SourceText("a.stp", turned))


def test_together_they_are_small() -> None:
    assert sum(path.stat().st_size for path in robot_library.TARGET.iterdir()) < 1_500_000


def test_the_catalogue_has_each_robot_in_a_line() -> None:
    entries = robots.catalogue()
    assert tuple(one.name for one in entries) == robots.names()
    for one in entries:
        robot = robots.load(one.name)
        assert (one.title, one.axes, one.rated_payload) == (robot.title, robot.n, robot.rated_payload)


def test_the_catalogue_says_how_far_an_arm_reaches() -> None:
    # From the shoulder 34 in, from axis 1 with the offset of the shoulder: published lengths of the PUMA 560.
    reaches = {one.name: one.reach for one in robots.catalogue()}
    assert reaches["puma560"] == pytest.approx(0.877009, abs=5e-4)
    assert reaches["scara"] == pytest.approx(0.325 + 0.275, abs=5e-4)
    for name, designation in (
        ("irb2400_16", 1.55),
        ("irb6640_180_255", 2.55),
        ("iiwa14", 0.82),
        ("irb140", 0.81),
    ):
        assert reaches[name] == pytest.approx(designation, abs=2e-3)


def test_listing_the_robots_reads_none() -> None:
    code = "import sys, ropsim.robots; ropsim.robots.catalogue(); sys.exit('ropsim.nirox' in sys.modules)"
    assert subprocess.run([sys.executable, "-c", code], check=False, cwd=Path.cwd()).returncode == 0


def test_facts_without_a_look_are_told_by_their_names(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    looks = tmp_path / "library_looks.toml"
    looks.write_text("")
    monkeypatch.setattr(robot_library, "LOOKS", looks)
    assert robot_library.main(["--check"]) == 1
    told = "cobra600.toml: no table [cobra600] in library_looks.toml says what it looks like\n"
    assert capsys.readouterr().out == told
