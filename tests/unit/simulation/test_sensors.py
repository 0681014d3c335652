"""Sensors at the tool: what they read by the geometry of the cell, in waits and in moves."""

from dataclasses import dataclass, field

import numpy as np
import pytest

from ropsim import robots
from ropsim.controller import CompiledLaw, LawError, LawTraits
from ropsim.dynamics import inverse_dynamics
from ropsim.flow import InputChange, MessageEvent, MoveEvent, Recording
from ropsim.kinematics import forward
from ropsim.model import Box, Cell, DistanceSensor, FixedObject, ForceSensor, Part, Shape, Signal, Tool
from ropsim.planning import ArmState, Sample, SensedCell
from ropsim.simulation import Fidelity, RunOptions, run
from ropsim.spatial import Pose
from support.cells import one_station
from support.compiled import code_of
from support.printed import si_numbers

ROBOT = robots.load("puma560")
TABLE_TOP = 0.1
"""Height of the table [m]."""
TABLE = FixedObject(
    "table", Pose(np.array([0.5, 0.0, TABLE_TOP / 2.0])), (Shape(Box((0.6, 1.0, TABLE_TOP))),)
)
SIGNALS = {
    "height": Signal("height", is_input=True, analog=True, sensor=DistanceSensor("", 0.3)),
    "near": Signal("near", is_input=True, sensor=DistanceSensor("robot", 0.05)),
    "force": Signal("force", is_input=True, analog=True, sensor=ForceSensor("", 2e4, 0.01)),
    "go": Signal("go", is_input=True, changes=((0.5, 1.0),)),
}
TICK = 4e-3
"""Interpolation tick [s]."""
PRINTED = 1e-6
"""What `print` shows of a length [m]."""
ABOVE = "mov (500, 0, 300)"


def cell_with(*parts: Part) -> Cell:
    return one_station(
        "c",
        ROBOT,
        robots.default_controller("puma560"),
        tools={"": Tool("")},
        start=ROBOT.home,
        signals=SIGNALS,
        objects=(TABLE,),
        parts=parts,
    )


CELL = cell_with()


def ideal(*lines: str, cell: Cell = CELL, inputs: tuple[InputChange, ...] = ()) -> Recording:
    return run(cell, {"robot": code_of(cell, *lines)}, RunOptions(Fidelity.KINEMATIC, inputs=inputs))


def said(recording: Recording) -> list[str]:
    return [event.text for event in recording.events_of(MessageEvent)]


def end(recording: Recording) -> np.ndarray:
    return forward(ROBOT, recording.rows("q")[-1]).position


@pytest.mark.parametrize(
    ("condition", "told"),
    [
        ("height < 1 mm", "`height < 0.001 m` never came true"),
        ("height < 290 mm", "`height < 0.29 m` was true before"),
        ("force > 500 N", "`force > 500 N` never came true"),
    ],
)
def test_the_limit_of_a_condition_is_told_with_the_unit_of_its_sensor(condition: str, told: str) -> None:
    (found,) = ideal(ABOVE, f"lin (500, 0, 200) speed 200 mm/s until {condition}").findings
    assert told in found.message


def test_the_distance_to_a_table_is_that_of_its_geometry() -> None:
    recording = ideal(
        ABOVE, "print height", "lin (500, 100, 250)", "print height", "mov (500, 0, 500)", "print height"
    )
    found = [float(text) for text in said(recording)]
    assert found == pytest.approx([0.2, 0.15, 0.3], abs=1e-6)  # of the last one it sees nothing: its range
    assert np.interp(recording.duration, *_track(recording, "signal.height")) == found[-1]


def _track(recording: Recording, name: str) -> tuple[np.ndarray, np.ndarray]:
    channel = recording.channels[name]
    assert channel.times is not None
    return channel.times, channel.values


def test_a_part_on_the_table_is_nearer() -> None:
    part = Part("box", np.array([0.05, 0.05, 0.04]), 0.2, Pose(np.array([0.5, 0.0, TABLE_TOP + 0.04])))
    assert said(ideal(ABOVE, "print height", cell=cell_with(part))) == ["0.16"]


@pytest.mark.parametrize(
    ("condition", "height"),
    [("height < 50 mm", TABLE_TOP + 0.05), ("near", TABLE_TOP + 0.05), ("force > 40 N", TABLE_TOP - 0.002)],
)
def test_a_guarded_move_ends_where_a_sensor_says_so(condition: str, height: float) -> None:
    recording = ideal(ABOVE, f"lin (500, 0, 90) speed 20 mm/s until {condition}", "wait 0.1 s")
    braking = 0.02 * 0.4
    assert height - braking - 0.02 * TICK < end(recording)[2] <= height + 1e-9
    assert recording.findings == ()


@pytest.mark.parametrize("speed", [20, 100, 250])
def test_the_place_that_is_kept_is_that_where_the_sensor_said_so(speed: int) -> None:
    """It is true to the way of one interpolation tick, however far the arm needs to stand."""
    search = f"lin (500, 0, 60) speed {speed} mm/s until height < 50 mm store touch"
    recording = ideal(ABOVE, search, "print touch.z")
    (kept,), touched = si_numbers(said(recording)[0]), TABLE_TOP + 0.05
    assert touched - speed * 1e-3 * TICK - PRINTED <= kept <= touched + PRINTED
    assert end(recording)[2] < kept - 0.01 * speed * 1e-3
    assert recording.findings == ()


def test_what_a_condition_kept_is_not_kept_again() -> None:
    search = "lin (500, 0, 60) speed 100 mm/s until height < 50 mm store touch"
    lines = (ABOVE, search, "mov (500, 0, 250) store back", "lin (500, 0, 60) until go is off store there")
    recording = ideal(*lines, "print touch.z, back.z, there.z", inputs=(InputChange(0.1, "go", 1.0),))
    touch, back, there = si_numbers(said(recording)[0])
    assert touch < TABLE_TOP + 0.05 + PRINTED
    assert back == pytest.approx(0.25, abs=PRINTED)
    assert there == pytest.approx(0.06, abs=PRINTED)


def test_behind_a_move_that_is_skipped_the_pose_is_that_where_the_arm_stands() -> None:
    search = "lin (500, 0, 60) speed 100 mm/s until height < 50 mm store touch"
    recording = ideal(ABOVE, search, "lin (5000, 0, 60) store far", "print touch.z - far.z")
    assert si_numbers(said(recording)[0])[0] > 1e-3


def test_the_same_program_gives_the_same_bits() -> None:
    lines = (ABOVE, "lin (500, 0, 90) speed 20 mm/s until near", "wait 0.1 s")
    assert ideal(*lines) == ideal(*lines)


def test_a_key_overrules_a_sensor_from_its_time_on() -> None:
    move = "lin (500, 0, 200) speed 20 mm/s until near"
    pressed = ideal(ABOVE, move, "wait 0.1 s", inputs=(InputChange(3.0, "near", 1.0),))
    assert end(pressed)[2] > 0.25
    assert [found.code for found in ideal(ABOVE, move).findings] == ["S746"]


def test_other_inputs_follow_their_script() -> None:
    assert ideal("wait until go").duration == pytest.approx(0.5, abs=1.5 * TICK)


def test_a_wait_for_a_sensor_is_not_in_vain_while_it_may_change() -> None:
    recording = ideal("wait until near timeout 1 s else print 1")
    assert said(recording) == ["1"]


def test_a_law_does_not_read_what_is_measured_between_slices_only() -> None:
    source = "def law(par, state, ref, meas, load, aux, out):\n    out[0] = aux[0]\n"
    law = CompiledLaw("force_law", source, ("p",), np.zeros((1, 6)), LawTraits(aux=("force",)))
    with pytest.raises(LawError, match="`force_law` reads signal `force`"):
        run(CELL, {"robot": code_of(CELL, ABOVE)}, RunOptions(laws={"robot": law}))


@dataclass
class Wrench:
    """A sensor of a user: the torque that joint 2 has beside what the model of the arm explains at rest."""

    seen: list[ArmState] = field(default_factory=list)

    def read(self, channel: str, time: float, cell: SensedCell) -> Sample:
        arm = cell.arm()
        self.seen.append(arm)
        zeros = np.zeros(arm.robot.n)
        modelled = inverse_dynamics(arm.robot, arm.q, zeros, zeros, payload=arm.payload)
        del channel, time
        return Sample(float((arm.effort - modelled)[1]), valid=True, age=0.0)


def test_an_interface_of_a_user_is_given_the_state_of_the_arm() -> None:
    sensors = Wrench()
    code = code_of(CELL, ABOVE, "wait 1 s", "print force", "lin (500, 0, 250) until force > 1000 N")
    recording = run(CELL, {"robot": code}, RunOptions(sensors=sensors))
    assert recording.events_of(MoveEvent)[1].travel > 0.0
    first = sensors.seen[0]
    assert first.station == "robot"
    assert first.X_WT.position == pytest.approx(forward(ROBOT, first.q).position, abs=1e-12)
    assert abs(float(said(recording)[0])) < 10.0  # [N·m]; what is left is dry friction
    assert np.abs(first.effort[1]) > 15.0
    assert max(np.abs(arm.qd).max() for arm in sensors.seen) > 0.05
