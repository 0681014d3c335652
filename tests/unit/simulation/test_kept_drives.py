"""Kept slices: behind an edit the arm forgets, and what is known from there on is not simulated again."""

from pathlib import Path
from random import Random

import numpy as np
import pytest

import ropsim
from ropsim.dynamics import structure_of
from ropsim.flow import Recording
from ropsim.model import Payload
from ropsim.simulation import KeptRuns, Recorder, RunOptions, Servo
from ropsim.simulation.testing import KeptDrives, LogLayout, constant, driven_anew
from ropsim.workbench import Project, Workspace, open_overlaid, open_project

EXAMPLES = Path(__file__).parents[3] / "examples"
HEAD = "program p\nunits mm, deg, s\nmov pick_up above 60\n"
LINES = tuple(
    f"lin ({500 + (k * 7) % 30}, {(k * 37) % 200}, {600 + (k * 13) % 50}; rpy 180 0 {k % 5})"
    for k in range(40)
)
EDITED = 3
FORGOTTEN = 8.0
"""So long behind an edit an arm is where it was before, to the bit [s]."""


@pytest.fixture(scope="module")
def workspace() -> Workspace:
    return Workspace()


@pytest.fixture
def known(workspace: Workspace) -> KeptRuns:
    cell = opened(LINES, workspace).cell
    assert cell is not None
    return KeptRuns(cell)


def opened(lines: tuple[str, ...], workspace: Workspace) -> Project:
    text = HEAD + "\n".join(lines) + "\n"
    return open_overlaid(EXAMPLES / "first_cell", {"programs/main.task": text}, workspace)


def run(project: Project, known: KeptRuns, longest: float = 3600.0) -> Recording:
    known.begin()
    return project.simulate(options=known.used_in(RunOptions(longest=longest)))


def changed(lines: tuple[str, ...], number: int, line: str) -> tuple[str, ...]:
    return (*lines[:number], line, *lines[number + 1 :])


def test_a_run_of_what_is_known_simulates_nothing(workspace: Workspace, known: KeptRuns) -> None:
    first = run(opened(LINES, workspace), known)
    assert known.drives.anew > 0
    again = run(opened(LINES, workspace), known)
    assert (known.drives.anew, known.plans.anew, again) == (0, [], first)


def test_rows_of_plans_are_not_kept_a_second_time(workspace: Workspace, known: KeptRuns) -> None:
    run(opened(LINES, workspace), known)
    robot = known.cell.first.robot
    assert known.drives.used == known.drives.anew * 8 * LogLayout.of(structure_of(robot).drives).width


@pytest.mark.parametrize("shift", [3, 7, 11, 13])
def test_an_edit_is_simulated_until_the_arm_has_forgotten_it(
    workspace: Workspace, known: KeptRuns, shift: int
) -> None:
    """Whatever the edit does to the time of all behind it, in ticks of which not each has a row."""
    run(opened(LINES, workspace), known)
    edited = opened(changed(LINES, EDITED, f"lin ({500 + shift}, 100, 620; rpy 180 0 0)"), workspace)
    recording = run(edited, known)
    assert len(known.plans.anew) == 3  # what begins elsewhere, and the `mov` whose posture they keep, too
    assert 0 < known.drives.anew < FORGOTTEN * 1000 < 0.5 * recording.duration * 1000
    assert recording == edited.simulate()


def test_a_line_more_above_is_simulated_alone(workspace: Workspace, known: KeptRuns) -> None:
    """The state of the arm behind a wait is another one, until the arm has forgotten it."""
    run(opened(LINES, workspace), known)
    more = opened(("wait 0.123 s", *LINES), workspace)
    recording = run(more, known)
    assert len(known.plans.anew) == 1  # the `mov` above, whose posture is no more chosen for lines behind it
    assert known.drives.anew < FORGOTTEN * 1000
    assert recording == more.simulate()


def test_random_edits_make_the_run_that_a_clean_one_makes(workspace: Workspace, known: KeptRuns) -> None:
    random = Random(11)
    lines = LINES[:12]
    for _ in range(6):
        place = f"({random.choice([450, 500, 2000])}, {random.choice([0, 100])}, {random.choice([600, 650])}"
        tail = random.choice(["", " blend 15", " speed 20 %"])
        edit = random.choice(["mov ", "lin "]) + f"{place}; rpy 180 0 0){tail}"
        lines = changed(lines, random.randrange(len(lines)), edit)
        project = opened(lines, workspace)
        assert run(project, known) == project.simulate()


@pytest.mark.parametrize("name", ["two_arms", "palletizing"])
def test_parts_grippers_and_other_arms_are_as_ever(name: str) -> None:
    project = open_project(EXAMPLES / name)
    assert project.cell is not None
    known = KeptRuns(project.cell)
    clean = project.simulate(options=RunOptions(longest=8.0))
    assert run(project, known, 8.0) == clean
    assert run(project, known, 8.0) == clean
    assert known.drives.anew == 0


def test_an_edit_before_a_grip_plans_nothing_behind_it(workspace: Workspace) -> None:
    """The part lies in the gripper as it did but for the last digits of the pose that the arm attained."""
    text = (EXAMPLES / "palletizing" / "programs" / "main.task").read_text("utf-8")
    first, edited = (
        text.replace("for each", f"mov (500, 0, {z}; roll 0, pitch 90, yaw 0)\nfor each", 1)
        for z in (700, 710)
    )
    before, after = (
        open_overlaid(EXAMPLES / "palletizing", {"programs/main.task": one}, workspace)
        for one in (first, edited)
    )
    assert before.cell is not None
    known = KeptRuns(before.cell)
    run(before, known, 15.0)
    recording = run(after, known, 15.0)
    assert len(known.plans.anew) == 2  # the edited move, and the first one that begins elsewhere
    assert recording == after.simulate(options=RunOptions(longest=15.0))


def test_a_slice_is_another_one_with_another_payload_reference_or_state() -> None:
    robot, controller = ropsim.robots.load("puma560"), ropsim.robots.default_controller("puma560")
    servo, drives = Servo.build(robot, controller), KeptDrives()
    start = servo.initial_state(robot.home)
    held, elsewhere = constant(robot.home, 8), constant(robot.home + 0.01, 8)
    plain, loaded = Payload(), Payload(2.0)
    asked = (
        (held, plain, 8),
        (held, plain, 0),
        (held, loaded, 8),
        (held, plain, 0),
        (elsewhere, plain, 8),
        (held, plain, 8),  # of each length the newest is known
        (constant(robot.home, 9), plain, 9),
    )
    for reference, payload, expected in asked:
        recorder, other = (Recorder(robot, start, 4) for _ in range(2))
        arguments = "robot", servo, start, reference, payload
        signals = np.empty((reference.ticks, 0))
        drives.begin()
        found = drives.drive(*arguments, recorder, signals)
        clean = driven_anew(*arguments, other, signals)
        assert found == clean
        assert recorder.channels()["tau"].tobytes() == other.channels()["tau"].tobytes()
        assert recorder.tally.table.tobytes() == other.tally.table.tobytes()
        assert drives.anew == expected
