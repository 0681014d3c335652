"""Kept plans: after an edit only stretches are planned that changed or begin elsewhere, to the same run."""

from pathlib import Path
from random import Random

import pytest

from ropsim.flow import Recording
from ropsim.simulation import Fidelity, KeptPlans, RunOptions
from ropsim.workbench import Project, Workspace, open_overlaid, open_project

EXAMPLES = Path(__file__).parents[4] / "examples"
KINEMATIC = RunOptions(fidelity=Fidelity.KINEMATIC)
HEAD = "program p\nunits mm, deg, s\nmov pick_up above 60\n"
#: The programs of the tests are shorter; of an example the beginning is enough [s].
LONGEST = 8.0
#: Each line is a stretch of its own, but for the two that are flown through.
LINES = (
    "mov (500, 0, 600; rpy 180 0 0)",
    "lin (500, 100, 600; rpy 180 0 0)",
    "lin (550, 100, 650; rpy 180 0 0) blend 20",
    "lin (550, 200, 650; rpy 180 0 0)",
    "mov (500, 200, 600; rpy 180 0 0)",
    "mov home",
)
FIRST = 4
"""Line of the program on which the first of them stands."""


@pytest.fixture(scope="module")
def workspace() -> Workspace:
    return Workspace()


@pytest.fixture
def plans(workspace: Workspace) -> KeptPlans:
    project = opened(LINES, workspace)
    assert project.cell is not None
    return KeptPlans(project.cell)


def opened(lines: tuple[str, ...], workspace: Workspace) -> Project:
    text = HEAD + "\n".join(lines) + "\n"
    return open_overlaid(EXAMPLES / "first_cell", {"programs/main.task": text}, workspace)


def run(project: Project, plans: KeptPlans, fidelity: Fidelity = Fidelity.KINEMATIC) -> Recording:
    plans.begin()
    return project.simulate(options=RunOptions(fidelity=fidelity, longest=LONGEST, plan=plans.plan))


def planned(plans: KeptPlans) -> list[list[int]]:
    """Return the lines of the stretches that were planned, from 0 for the first of the lines."""
    return [
        [one.origin.span.line - FIRST for one in moves if one.origin.span is not None] for moves in plans.anew
    ]


def changed(lines: tuple[str, ...], number: int, line: str) -> tuple[str, ...]:
    return (*lines[:number], line, *lines[number + 1 :])


def test_a_program_that_says_the_same_is_not_planned_again(workspace: Workspace, plans: KeptPlans) -> None:
    first = run(opened(LINES, workspace), plans)
    assert planned(plans) == [[-1], [0], [1], [2, 3], [4], [5]]
    again = run(opened(LINES, workspace), plans)
    assert (planned(plans), again) == ([], first)


@pytest.mark.parametrize(
    ("number", "line", "expected"),
    [
        # the next one begins elsewhere, and ends where it ended; the posture of 0 serves the lines behind it
        (0, "mov (500, 0, 610; rpy 180 0 0)", [[0], [1]]),
        (1, "lin (500, 110, 600; rpy 180 0 0)", [[0], [1], [2, 3]]),
        (2, "lin (550, 110, 650; rpy 180 0 0) blend 20", [[0], [2, 3]]),
        (3, "lin (550, 210, 650; rpy 180 0 0)", [[0], [2, 3], [4]]),
        (5, "mov home speed 50 %", [[5]]),
    ],
)
def test_an_edit_plans_what_changed_and_what_begins_elsewhere(
    workspace: Workspace, plans: KeptPlans, number: int, line: str, expected: list[list[int]]
) -> None:
    run(opened(LINES, workspace), plans)
    after = opened(changed(LINES, number, line), workspace)
    assert run(after, plans) == after.simulate(options=KINEMATIC)
    assert planned(plans) == expected


def test_plans_of_the_ideal_arm_are_those_of_the_driven_one(workspace: Workspace, plans: KeptPlans) -> None:
    project = opened(LINES[:2], workspace)
    run(project, plans)
    driven = run(project, plans, Fidelity.DYNAMIC)
    assert (planned(plans), driven) == ([], project.simulate())


def test_random_edits_make_the_run_that_a_clean_one_makes(workspace: Workspace, plans: KeptPlans) -> None:
    """Targets out of reach, zones and speeds among them: what cannot be planned is kept, too."""
    random = Random(7)
    lines: tuple[str, ...] = LINES
    for _ in range(8):
        x, y, z = random.choice([450, 500, 2000]), random.choice([0, 100]), random.choice([600, 650])
        tail = random.choice(["", " blend 15", " speed 20 %"])
        verb = random.choice(["mov", "lin"])
        edit = f"{verb} ({x}, {y}, {z}; rpy 180 0 0){tail}"
        lines = changed(lines, random.randrange(len(lines)), edit)
        project = opened(lines, workspace)
        assert run(project, plans) == project.simulate(options=KINEMATIC)


@pytest.mark.parametrize("name", ["two_arms"])
def test_an_example_is_planned_once(name: str) -> None:
    project = open_project(EXAMPLES / name)
    assert project.cell is not None
    plans = KeptPlans(project.cell)
    first = run(project, plans)
    assert plans.anew
    assert (run(project, plans), plans.anew) == (first, [])


def test_without_room_nothing_is_kept_and_all_is_as_ever(workspace: Workspace) -> None:
    project = opened(LINES, workspace)
    assert project.cell is not None
    plans = KeptPlans(project.cell, most=0)
    assert run(project, plans) == run(project, plans)
    assert len(plans.anew) == 6


def test_room_is_made_by_what_two_runs_have_not_asked_for(workspace: Workspace) -> None:
    project, other = opened(LINES[:1], workspace), opened(("mov (450, 0, 650; rpy 180 0 0)",), workspace)
    assert project.cell is not None
    needed = []
    for one in (project, other):
        roomy = KeptPlans(project.cell)
        run(one, roomy)
        needed.append(roomy.used)
    plans = KeptPlans(project.cell, most=max(needed))
    for _ in range(2):
        run(project, plans)
    for _ in range(3):
        run(other, plans)
    assert planned(plans) == []


def test_lines_that_move_are_not_planned_again_and_their_findings_move_with_them(
    workspace: Workspace, plans: KeptPlans
) -> None:
    lines = (
        LINES[0],
        "lin (2000, 0, 600; rpy 180 0 0)",
        "lin (500, 150, 600; rpy 180 0 0) speed 5 m/s",
        *LINES[2:],
    )
    run(opened(lines, workspace), plans)
    moved = opened(("# what comes next", "", *lines), workspace)
    found = run(moved, plans)
    assert planned(plans) == []
    clean = moved.simulate(options=KINEMATIC)
    assert found == clean
    assert {one.span.line for one in found.findings if one.span} >= {FIRST + 3}


def test_a_move_on_the_line_of_another_one_is_told_there(workspace: Workspace, plans: KeptPlans) -> None:
    """Two lines that change places have the moves of each other, each with its own finding."""
    far, near = "mov (2000, 0, 600; rpy 180 0 0)", "mov (500, 0, 600; rpy 180 0 0)"
    run(opened((near, far, near, far), workspace), plans)
    swapped = opened((far, near, far, near), workspace)
    assert run(swapped, plans) == swapped.simulate(options=KINEMATIC)
