"""Collisions of the finished run: checked once, part of it from then on, given up for what is newer."""

import json
from collections.abc import Sequence
from pathlib import Path

import pytest

from ropsim.studio.testing import (
    Cancelled,
    Desk,
    Failed,
    LookAtWays,
    Order,
    Report,
    RunReply,
    RunWays,
    SavedRun,
    SaveRun,
    Simulate,
    WaysReply,
    wire,
)

CELL = """\
[cell]
name = "c"
[robot]
model = "puma560"
[[objects]]
name = "post"
position = [500, 0, 120]
shapes = [{ box = [40, 40, 400] }]
"""
PROGRAM = """\
program c
units mm, deg, s
mov (500, -200, 300)
lin (500, 200, 300) speed 200 mm/s
"""


class Quiet:
    """A line on which nobody says anything."""

    number = 1

    def report(self, content: Report) -> None:
        """Hear it."""

    def orders(self, seconds: float) -> Sequence[Order]:
        """Order nothing."""
        del seconds
        return ()


class Impatient(Quiet):
    """A line on which the job is given up at once."""

    def orders(self, seconds: float) -> Sequence[Order]:
        """Give up."""
        del seconds
        raise Cancelled


@pytest.fixture
def asked(tmp_path: Path) -> Simulate:
    (tmp_path / "programs").mkdir()
    (tmp_path / "cell.toml").write_text(CELL)
    (tmp_path / "programs" / "main.task").write_text(PROGRAM)
    return Simulate(str(tmp_path), {}, "main", "kinematic")


def test_what_met_is_told_with_the_run_from_then_on(asked: Simulate) -> None:
    desk, line = Desk(), Quiet()
    first = desk.do(asked, line)
    assert isinstance(first, RunReply)
    assert not first.ways
    with pytest.raises(Cancelled):
        desk.do(LookAtWays(1), Impatient())
    seen = desk.do(LookAtWays(1), line)
    assert isinstance(seen, WaysReply)
    met = [one for one in seen.findings if one["code"] == "S751"]
    assert {one["span"]["line"] for one in met} == {4}  # type: ignore[index]
    assert all(isinstance(one["time"], float) for one in met)
    assert "collisions" not in str(seen.result["unchecked"]).partition(" · ")[0].removeprefix("not checked: ")
    told = json.loads(wire(RunWays(1, seen.findings, seen.result, seen.ways)))
    assert told["result"]["verdict"]["kind"] == "failed"
    assert {one["severity"] for one in met} == {"error"}
    contacts = told["ways"]["contacts"]
    assert {one["other"] for one in contacts} == {"post"}
    assert all(one["begin"] <= one["time"] <= one["end"] for one in contacts)
    assert [list(one["place"]) for one in met] == [  # type: ignore[call-overload]
        min((c for c in contacts if c["bodies"] in str(one["message"])), key=lambda c: c["distance"])["place"]
        for one in met
    ]
    report = desk.do(SaveRun(1, "report"), line)
    assert isinstance(report, SavedRun)
    assert b"<h2>Collisions and clearance</h2>" in report.content
    again = desk.do(asked, line)
    assert isinstance(again, RunReply)
    assert (again.made, again.ways) == ("kept", True)


def test_ways_of_a_run_that_is_kept_no_more_are_not_looked_at(asked: Simulate) -> None:
    desk, line = Desk(), Quiet()
    assert isinstance(desk.do(LookAtWays(1), line), Failed)
    desk.do(asked, line)
    assert isinstance(desk.do(LookAtWays(2), line), Failed)
