"""Built-in entities of the controller that a cell file names: each has its property in a run."""

from pathlib import Path

import numpy as np
import pytest

from ropsim.flow import MoveEvent, Recording
from ropsim.kinematics import forward, inverse_path
from ropsim.model import Entity
from ropsim.planning import BUILT_IN
from ropsim.robots import load
from ropsim.simulation import Fidelity, RunOptions
from ropsim.workbench import open_project

CELL = """\
[robot]
model = "puma560"

[controller]
path_acceleration = 2000
path_jerk = 20000

[controller.entities]
"""
SQUARE = """\
program p
units mm, deg, s
mov (500, -100, 400)
set speed 200 mm/s
lin (500, 100, 400) blend 20 mm
lin (600, 100, 400)
"""
PERIOD = 1e-3


def run(folder: Path, entities: str, program: str = SQUARE) -> Recording:
    folder.mkdir()
    (folder / "programs").mkdir()
    (folder / "cell.toml").write_text(CELL + entities, "utf-8")
    (folder / "programs" / "main.task").write_text(program, "utf-8")
    project = open_project(folder)
    assert [one for one in project.compile().diagnostics if one.is_error] == []
    return project.simulate(options=RunOptions(Fidelity.KINEMATIC))


def moves(recording: Recording) -> list[MoveEvent]:
    return [one for one in recording.events if isinstance(one, MoveEvent)]


def test_the_standard_ones_by_name_are_those_without_a_name(tmp_path: Path) -> None:
    names = "".join(f'{one.value} = "{next(iter(BUILT_IN[one]))}"\n' for one in Entity if BUILT_IN[one])
    named, usual = run(tmp_path / "named", names), run(tmp_path / "usual", "")
    for name, channel in usual.channels.items():
        np.testing.assert_array_equal(named.channels[name].values, channel.values)


def test_a_line_of_the_trapezoidal_interpolator_takes_way_over_speed_and_speed_over_acceleration(
    tmp_path: Path,
) -> None:
    stops = 'path_planner = "exact stops"\n'
    trapezoidal = moves(run(tmp_path / "a", stops + 'interpolator = "trapezoidal"\n'))
    usual = moves(run(tmp_path / "b", stops))
    whole = [0.2 / 0.2 + 0.2 / 2.0, 0.1 / 0.2 + 0.2 / 2.0]
    for found, limited, wanted in zip(trapezoidal[1:], usual[1:], whole, strict=True):
        assert 0.0 <= found.travel - wanted < 2.0 * PERIOD
        assert limited.travel > wanted + 0.05  # jerk: a/j = 0.1 s


def test_exact_stops_stand_at_the_corner_and_rounded_corners_do_not(tmp_path: Path) -> None:
    corner = np.array([0.5, 0.1, 0.4])
    least = {}
    for number, kind in enumerate(("exact stops", "rounded corners")):
        recording = run(tmp_path / str(number), f'path_planner = "{kind}"\n')
        way = recording.channels["command_position"].values
        least[kind] = np.linalg.norm(way - corner, axis=1).min()
    assert least["exact stops"] < 1e-6
    assert least["rounded corners"] > 1e-3


@pytest.mark.parametrize(("kind", "most"), [("linear", 2e-5), ("cubic", 5e-8)])
def test_joints_between_interpolation_ticks_are_off_by_as_much_as_their_kind_says(
    tmp_path: Path, kind: str, most: float
) -> None:
    """Lines: at most a·T²/8 with 12 rad/s² of a joint and T = 4 ms; cubics by j·T³/100 or so."""
    rows = [
        run(tmp_path / name, entities).channels["q"].values
        for name, entities in (("a", f'joint_interpolator = "{kind}"\n'), ("b", ""))
    ]
    off = np.abs(rows[0] - rows[1]).max()
    assert most * 1e-3 < off < most


def beside_the_wrist(q5: float) -> str:
    """Return a program with a line of 200 mm on which joint 5 passes this far beside its singular pose."""
    robot, q = load("puma560"), np.array([0.1, 0.9, -2.4, 0.3, q5, 0.2])
    half = np.repeat(forward(robot, q).matrix()[np.newaxis], 41, axis=0)
    half[:, 2, 3] += np.linspace(0.0, 0.1, 41)
    below = half.copy()
    below[:, 2, 3] = 2.0 * half[0, 2, 3] - half[:, 2, 3]
    joints = ", ".join(f"{one:.9f}" for one in np.degrees(inverse_path(robot, below, q)[-1]))
    x, y, z = 1e3 * half[-1, :3, 3]
    line = f"lin ({x:.9f}, {y:.9f}, {z:.9f}; like here) speed 200 mm/s"
    return f"program p\nunits mm, deg, s\nmov joints({joints})\n{line}\n"


def test_past_a_singular_wrist_damped_least_squares_is_quicker_and_as_near_as_it_says(tmp_path: Path) -> None:
    exact, damped = (
        moves(run(tmp_path / name, f'inverse_transform = "{kind}"\n', beside_the_wrist(2e-4)))[-1]
        for name, kind in (("a", "closed form"), ("b", "damped least squares"))
    )
    assert damped.travel == pytest.approx(0.2 / 0.2 + 0.2 / 2.0 + 0.1, abs=0.01)  # as programmed
    assert exact.travel > 2.0 * damped.travel
    assert damped.path_error_max is not None
    assert exact.path_error_max is not None
    assert 1e-5 < damped.path_error_max < 5e-5
    assert exact.path_error_max < 1e-6


def test_damped_least_squares_flies_a_line_at_which_the_exact_answer_jumps(tmp_path: Path) -> None:
    exact = run(tmp_path / "a", "", beside_the_wrist(1e-3))
    damped = run(tmp_path / "b", 'inverse_transform = "damped least squares"\n', beside_the_wrist(1e-3))
    assert "M505" in [one.code for one in exact.findings]
    assert [one.code for one in damped.findings if one.is_error] == []
    off = moves(damped)[-1].path_error_max
    assert off is not None
    assert off < 5e-4


@pytest.mark.parametrize("text", ['interpolator = "trapezodal"\n', 'inverse_transform = "linear"\n'])
def test_another_name_is_an_error_that_says_which_there_are(tmp_path: Path, text: str) -> None:
    (tmp_path / "programs").mkdir()
    (tmp_path / "cell.toml").write_text(CELL + text, "utf-8")
    (tmp_path / "programs" / "main.task").write_text(SQUARE, "utf-8")
    (found,) = [one for one in open_project(tmp_path).compile().diagnostics if one.is_error]
    assert found.code == "X930"
    assert "built-in ones are" in found.hint
