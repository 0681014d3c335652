"""What external axes move carries parts: the plate of a positioner, the carriage of a track."""

from collections.abc import Mapping
from functools import cache

import numpy as np
import pytest

from ropsim import language
from ropsim.cellfile import read_cell
from ropsim.core import SourceText
from ropsim.flow import Recording, channel_name
from ropsim.kinematics import body_poses
from ropsim.model import Cell, body_tree
from ropsim.simulation import Fidelity, RunOptions, run
from ropsim.spatial import Array
from ropsim.workbench import environment_of

TOOL = "[tools.jaws]\nposition = [0, 0, 150]\nmass = 0.5\ngripper = {}\n"
ONE = (
    '[robot]\nmodel = "puma560"\ntool = "jaws"\n'
    "positioner = { radius = 250, height = 500, base = { position = [550, 0, 0] } }\n"
    + TOOL
    + '[[objects]]\nname = "fixture"\nparent = "positioner"\nposition = [0, 150, 20]\nsize = [80, 80, 20]\n'
    '[[parts]]\nname = "bare"\nsize = [40, 40, 40]\nmass = 0.2\nposition = [450, 0, 540]\n'
    '[[parts]]\nname = "fixed"\nsize = [40, 40, 40]\nmass = 0.2\nposition = [550, 150, 560]\n'
    '[[parts]]\nname = "upper"\nsize = [20, 20, 20]\nmass = 0.1\nposition = [550, 150, 580]\n'
)
TURN = """program main
units mm, deg, s
mov joints(0, 75, -180, 0, -75, 0, 90)
"""
PICK = """mov (550, -100, 540) above 50
lin (550, -100, 540) speed 100
close
lin (550, -100, 540) above 100
mov joints(0, 75, -180, 0, -75, 0, 30)
mov (450, 0, 540) above 50
lin (450, 0, 540) speed 100
open
lin (450, 0, 540) above 100
mov joints(0, 75, -180, 0, -75, 0, -60)
"""
TWO = (
    '[stations.left]\nrobot = "puma560"\ntool = "jaws"\n'
    '[stations.right]\nrobot = "puma560"\nbase = { position = [0, 900, 0] }\n'
    "track = { length = 2000, mount = { position = [-600, 0, 0] } }\n"
    "positioner = { radius = 200, height = 500, base = { position = [0, -500, 0] } }\n"
    + TOOL
    + '[[objects]]\nname = "stand"\nposition = [500, 0, 500]\nsize = [80, 80, 500]\n'
    '[[parts]]\nname = "given"\nsize = [40, 40, 40]\nmass = 0.2\nposition = [500, 0, 540]\n'
    '[[parts]]\nname = "luggage"\nsize = [40, 40, 40]\nmass = 0.2\nposition = [100, 1000, 390]\n'
    "[signals.laid]\noutput = 1\n"
)
LAY = """program left
units mm, deg, s
mov (500, 0, 540) above 50
lin (500, 0, 540) speed 100
close
lin (500, 0, 540) above 50
mov (100, -450, 540) above 50
lin (100, -450, 540) speed 100
open
lin (100, -450, 540) above 100
set laid on
"""
RIDE = """program right
units mm, deg, s
wait until laid
mov joints(0, 75, -180, 0, -75, 0, 400, 120)
"""
EXACT = 1e-9  # [m], rounding of poses
REACHED = 1e-5  # [m], an arm in position


@cache
def cell_of(text: str) -> Cell:
    cell, findings = read_cell(SourceText("cell.toml", text), "carrying")
    assert [str(one) for one in findings] == []
    assert cell is not None
    return cell


@cache
def ran(text: str, fidelity: Fidelity, **programs: str) -> Recording:
    cell = cell_of(text)
    codes = {}
    for name, program in programs.items():
        code = language.compile(program, environment_of(cell, cell.stations[name]), name=f"{name}.task")
        assert [str(one) for one in code.diagnostics] == []
        assert code.icr is not None
        codes[name] = code.icr
    recording = run(cell, codes, RunOptions(fidelity=fidelity))
    assert [str(found) for found in recording.findings] == []
    return recording


def at_the_end(cell: Cell, recording: Recording) -> Mapping[str, Array]:
    """Return X_WB of all parts when the run ends, by the channels and placements of the recording."""
    names = tuple(part.name for part in cell.parts)
    elsewhere = {one.body: (one.parent, one.X_PB) for one in recording.placements if one.body in names}
    Q = {name: recording.channels[channel_name("q", name)].values[-1:] for name in cell.stations}
    return {name: rows[0] for name, rows in body_poses(body_tree(cell), Q, names, elsewhere).items()}


def turned(point: tuple[float, float, float], about: tuple[float, float], angle: float) -> Array:
    """Return a point turned about a vertical axis [m], shape (3,)."""
    x, y = point[0] - about[0], point[1] - about[1]
    c, s = np.cos(angle), np.sin(angle)
    return np.array([about[0] + c * x - s * y, about[1] + s * x + c * y, point[2]])


@pytest.mark.parametrize("fidelity", list(Fidelity))
def test_parts_on_a_positioner_come_along_to_where_its_axis_really_is(fidelity: Fidelity) -> None:
    recording = ran(ONE, fidelity, robot=TURN)
    attained = float(recording.channels["q"].values[-1, 6])
    poses = at_the_end(cell_of(ONE), recording)
    for name, start in {"bare": (0.45, 0.0, 0.54), "fixed": (0.55, 0.15, 0.56)}.items():
        np.testing.assert_allclose(
            poses[name][:3, 3], turned(start, (0.55, 0.0), attained), rtol=0.0, atol=EXACT
        )
        np.testing.assert_allclose(poses[name][:2, 0], [np.cos(attained), np.sin(attained)], atol=EXACT)
    np.testing.assert_allclose(
        poses["upper"][:3, 3], poses["fixed"][:3, 3] + [0.0, 0.0, 0.02], rtol=0.0, atol=EXACT
    )


def test_what_lies_on_an_object_of_the_plate_hangs_on_that_object() -> None:
    parents = {one.body: one.parent for one in ran(ONE, Fidelity.KINEMATIC, robot=TURN).placements}
    assert (parents["bare"], parents["fixed"], parents["upper"]) == ("link7", "fixture", "fixed")
    assert parents["fixture"] == "link7"


def test_a_part_is_gripped_where_the_plate_has_turned_it_and_rides_again_where_it_is_put_down() -> None:
    recording = ran(ONE, Fidelity.KINEMATIC, robot=TURN + PICK)
    poses = at_the_end(cell_of(ONE), recording)
    gripped = [one.parent for one in recording.placements if one.body == "bare"]
    assert gripped == ["link7", "tool:jaws", "link7"]
    # Gripped at 90°, put down at (450, 0) when the axis is at 30°, turned on by -90° then.
    there = turned((0.45, 0.0, 0.54), (0.55, 0.0), -np.pi / 2.0)
    np.testing.assert_allclose(poses["bare"][:3, 3], there, rtol=0.0, atol=REACHED)


@pytest.mark.parametrize(("place", "findings"), [([550, -100, 540], []), ([450, 0, 540], ["S738"])])
def test_destinations_are_looked_at_where_the_plate_has_brought_the_parts(
    place: list[int], findings: list[str]
) -> None:
    text = ONE.replace(
        "position = [450, 0, 540]\n",
        f"position = [450, 0, 540]\ndestination = {{ position = {place}, turn = 180 }}\n",
    )
    cell = cell_of(text)
    code = language.compile(TURN, environment_of(cell), name="main.task")
    assert code.icr is not None
    recording = run(cell, {"robot": code.icr}, RunOptions(fidelity=Fidelity.KINEMATIC))
    assert [one.code for one in recording.findings] == findings


def test_a_part_rides_on_the_positioner_and_on_the_carriage_of_another_station() -> None:
    cell, recording = cell_of(TWO), ran(TWO, Fidelity.KINEMATIC, left=LAY, right=RIDE)
    poses = at_the_end(cell, recording)
    given = turned((0.1, -0.45, 0.54), (0.0, -0.5), np.radians(120.0))
    np.testing.assert_allclose(poses["given"][:3, 3], given, rtol=0.0, atol=REACHED)
    np.testing.assert_allclose(poses["luggage"][:3, 3], [0.5, 1.0, 0.39], rtol=0.0, atol=EXACT)
    parents = {one.body: one.parent for one in recording.placements}
    assert parents["given"].startswith("right/link")
    assert parents["luggage"].startswith("right/link")


def test_the_arm_is_not_carried_by_what_it_has_put_down() -> None:
    """The payload of a station is what hangs in its hands, not what rides on its plate."""
    recording = ran(ONE, Fidelity.KINEMATIC, robot=TURN + PICK)
    assert recording.channels["payload"].values.tolist() == pytest.approx([0.5, 0.7, 0.5])
