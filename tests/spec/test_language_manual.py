"""The manual of the task language: every example compiles, runs and does what its comments say."""

import math
import re
from collections.abc import Mapping
from dataclasses import replace

import pytest

from ropsim import icr, robots
from ropsim.flow import MessageInstruction, MoveInstruction
from ropsim.language import Compiled, Environment, PointTable, compile
from ropsim.program import SignalUse, ValueType
from ropsim.spatial import Pose
from ropsim.workbench.testing import dry_arm
from support.cells import one_station
from support.manual import DOCS, Block, blocks
from support.tasks import CELL

SEAM = PointTable(
    tuple(
        (x, y, 0.1, 0.0, 1.0, 0.0, 0.0) for x, y in ((0.3, 0.0), (0.32, 0.005), (0.34, 0.005), (0.36, 0.0))
    ),
    {"entry": 1, "exit": 4},
)
"""The list `points/seam.csv` of the manual."""

MANUAL_CELL = replace(
    CELL,
    external=("length", "angle"),
    lists={"seam": SEAM},
    signals={**CELL.signals, "glue": SignalUse("glue", is_input=False, type=ValueType.BOOL)},
)
"""The small cell of the tests, with an output and a list, and a robot with a track and a positioner."""

ROBOT = one_station("manual", robots.load("puma560"), robots.default_controller("puma560"))
"""The arm that `here` and `store` need."""

DOWN = (0.0, 1.0, 0.0, 0.0)
BLOCKS = blocks(DOCS / "reference" / "language.md", "task")
FINDING = re.compile(r"# (error|warning|hint): ([A-Z]\d{3})$")
CHECK = re.compile(r"# (at|says|trap:) (.+)$")
TOLERANCE = 1e-6
"""Of positions in mm: what rounding of a few poses leaves, far below any digit that the manual shows."""


def said(block: Block, kind: str) -> Mapping[int, str]:
    """Return what the comments of one kind say, by line of the block."""
    matches = {number: CHECK.search(line) for number, line in enumerate(block.lines, 1)}
    return {number: match[2] for number, match in matches.items() if match and match[1] == kind}


def right_lines(block: Block) -> str:
    """Return the block without its wrong lines."""
    wrong = re.compile(r"# error: ")
    return "\n".join("" if wrong.search(line) else line for line in block.lines)


def compiled(text: str, environment: Environment = MANUAL_CELL) -> Compiled:
    return compile(text, environment, "manual")


def position(move: MoveInstruction) -> tuple[float, ...]:
    """Return the target in the base frame [mm], then the values of the external axes [mm, deg]."""
    assert isinstance(move.target, Pose)
    place = tuple(1e3 * float(c) for c in (move.modal.X_BK @ move.target).position)
    scales = (1e3, math.degrees(1.0))[: len(move.external)]
    return place + tuple(scale * e for scale, e in zip(scales, move.external, strict=True))


def test_the_cell_is_the_one_that_the_manual_describes() -> None:
    assert MANUAL_CELL.locations == {"infeed": (0.4, 0.3, 0.1, *DOWN)}
    assert MANUAL_CELL.frames == {"pallet": (0.4, -0.3, 0.0, 1.0, 0.0, 0.0, 0.0)}
    assert (set(MANUAL_CELL.tools), set(MANUAL_CELL.signals)) == ({"jaws"}, {"part_ok", "glue"})
    assert MANUAL_CELL.external == ("length", "angle")


@pytest.mark.parametrize("block", BLOCKS, ids=str)
def test_an_example_has_the_findings_that_it_names_and_no_others(block: Block) -> None:
    expected = {
        (number, match[1], match[2])
        for number, line in enumerate(block.lines, 1)
        if (match := FINDING.search(line))
    }
    found = compiled(block.text).diagnostics
    assert [str(one) for one in found if one.span is None] == []
    assert sorted((one.span.line, one.severity.value, one.code) for one in found if one.span) == sorted(
        expected
    )


@pytest.mark.parametrize("block", BLOCKS, ids=str)
def test_an_example_without_its_wrong_lines_runs_as_it_says(block: Block) -> None:
    result = compiled(right_lines(block))
    assert result.icr is not None, [str(one) for one in result.diagnostics]
    assert icr.verify(result.icr) == ()
    trace = icr.run(result.icr, icr.StillWorld(arm=dry_arm(ROBOT, ROBOT.first)))
    at: dict[int, list[tuple[float, ...]]] = {}
    says: dict[int, list[str]] = {}
    for step in trace.instructions:
        line = step.origin.span.line if step.origin.span else 0
        if isinstance(step, MoveInstruction) and isinstance(step.target, Pose):
            at.setdefault(line, []).append(position(step))
        elif isinstance(step, MessageInstruction):
            says.setdefault(line, []).append(step.text)
    for line, text in said(block, "at").items():
        wanted = [tuple(map(float, point.replace("external", " ").split())) for point in text.split(";")]
        found_at = at.get(line, [])
        assert len(found_at) == len(wanted), f"line {line}"
        for one, point in zip(found_at, wanted, strict=True):
            assert one == pytest.approx(point, abs=TOLERANCE), f"line {line}"
    for line, text in said(block, "says").items():
        assert says.get(line) == text.split("; "), f"line {line}"
    trap = trace.trap
    found = {trap.span.line: trap.code} if trap is not None and trap.span is not None else {}
    assert found == said(block, "trap:")


def test_the_manual_names_every_part_that_is_refused_by_name() -> None:
    from ropsim.language.testing import NOT_YET, NOT_YET_MODIFIERS

    manual = (DOCS / "reference" / "language.md").read_text("utf-8")
    absent = set(re.findall(r"`([a-z]+)`", manual.split("## Not in this version")[1]))
    closers = {word for word in NOT_YET if word.startswith("end")}
    assert sorted((NOT_YET | NOT_YET_MODIFIERS) - closers - absent) == []


def test_the_limits_are_those_of_the_compiler() -> None:
    from ropsim.language import report
    from ropsim.language.testing import cursor, implicit, lexer, line, lines, text
    from ropsim.language.testing import matching as blocks_module

    table = (DOCS / "reference" / "language.md").read_text("utf-8").split("## Limits")[1].split("## Not")[0]
    rows = [row for row in table.splitlines() if row.startswith("|")][2:]
    assert [row.split("|")[2].strip() for row in rows] == [
        f"{text.MAX_LINES:,}".replace(",", " "),
        str(line.MAX_LENGTH),
        str(lines.MAX_JOINED),
        str(lexer.MOST_LETTERS),
        f"{blocks_module.MAX_DEPTH}; {cursor.MAX_NESTING}",
        str(cursor.MAX_OPERATORS),
        "1e12",
        str(implicit.MAX_REFERENCES),
        str(report.MAX_FINDINGS),
    ]
    assert lexer.LARGEST == 1e12
