"""Paths that a sensor corrects: what remains, which limits hold, and that nothing else changes."""

from dataclasses import dataclass, field, replace
from functools import cache

import numpy as np
import pytest

from ropsim import robots
from ropsim.cellfile import read_cell
from ropsim.controller import Correction, ShiftedArm, ShiftedJoints
from ropsim.core import SourceText
from ropsim.flow import InputChange, OverrideChange, PathTracking, Recording
from ropsim.kinematics import forward_batch
from ropsim.model import (
    Box,
    Cell,
    ControllerModel,
    CorrectionLimits,
    DistanceSensor,
    FixedObject,
    Shape,
    Signal,
    Tool,
)
from ropsim.planning import PathCorrector, Sample, standard_chain
from ropsim.simulation import Fidelity, NobodyWatches, RunOptions, RunView, run
from ropsim.spatial import Array, Pose
from support.cells import one_station
from support.compiled import code_of

ROBOT = robots.load("puma560")
CONTROLLER = robots.default_controller("puma560")
TOP = 0.1
"""Height of the surface below the middle of the paths [m]."""
TICK = 4e-3
"""Interpolation tick [s]."""
SPEED, GAIN, GAP = 0.05, 10.0, 0.01
START = "mov (460, 150, {z}; ry 160 deg)"
LINE = "lin ({x}, 150, {z}; ry 160 deg) speed 50 mm/s"
TRACK = "track gap = 10 mm"
TILT = np.array([np.sin(np.deg2rad(160.0)), 0.0, np.cos(np.deg2rad(160.0))])
"""Direction in which the tool looks."""
NEAR = 1e-6
"""What rows of a recording may be off by [m]."""


def surface(slope: float) -> FixedObject:
    half = np.arctan(slope) / 2.0
    turned = Pose(np.array([0.5, 0.0, TOP]), np.array([np.cos(half), 0.0, -np.sin(half), 0.0]))
    return FixedObject("table", turned @ Pose(np.array([0.0, 0.0, -0.05])), (Shape(Box((0.8, 1.0, 0.1))),))


def cell_with(slope: float = 0.0, controller: ControllerModel = CONTROLLER) -> Cell:
    sensor = DistanceSensor("", 0.3, 0.05)
    return one_station(
        "c",
        ROBOT,
        controller,
        tools={"": Tool("")},
        start=ROBOT.home,
        signals={
            "gap": Signal("gap", is_input=True, analog=True, sensor=sensor),
            "hand": Signal("hand", is_input=True, analog=True, changes=((2.0, 0.001), (2.5, 0.0))),
        },
        objects=(surface(slope),),
    )


FLAT = cell_with()


def recorded(cell: Cell, *lines: str, options: RunOptions | None = None) -> Recording:
    wanted = options or RunOptions(Fidelity.KINEMATIC, record_hz=1000)
    return run(cell, {"robot": code_of(cell, *lines)}, wanted)


def codes(recording: Recording) -> set[str]:
    return {one.code for one in recording.findings} - {"M511"}


@dataclass
class Corrected:
    """The part of a recording in which a sensor corrects a path.

    Attributes:
        recording: the whole.
        rows: of that part.
    """

    recording: Recording
    rows: slice = field(init=False)

    def __post_init__(self) -> None:
        found = np.flatnonzero(~np.isnan(self.recording.rows("correction")))
        self.rows = slice(int(found[0]), int(found[-1]) + 1)

    def of(self, name: str) -> Array:
        values: Array = self.recording.rows(name)[self.rows]
        return values

    def gap(self, slope: float = 0.0) -> Array:
        """Distance to the surface along the tool, less than the one wanted [m], by geometry of our own."""
        normal = np.array([-slope, 0.0, 1.0]) / np.hypot(slope, 1.0)
        heights = (self.of("attained_position") - [0.5, 0.0, TOP]) @ normal
        gaps: Array = heights / -(TILT @ normal) - GAP
        return gaps


def line_at(height: float, length: float = 80.0) -> tuple[str, str]:
    """Lines of a length whose tool is `height` above the distance wanted, seen along the tool [mm]."""
    z, end = f"{1e3 * TOP - (10.0 + height) * TILT[2]:.9f}", f"{460.0 + length:g}"
    return START.format(z=z), LINE.format(x=end, z=z)


@cache
def over_the_flat(height: float, clause: str = "") -> Recording:
    start, line = line_at(height)
    return recorded(FLAT, start, f"{line} {clause}")


def test_a_constant_difference_decays_with_the_time_constant_of_the_gain() -> None:
    start, line = line_at(1.0)
    found = Corrected(recorded(FLAT, start, f"{line} {TRACK} gain 10"))
    error = found.gap()
    assert error[0] == pytest.approx(1e-3, abs=1e-5)
    ratio = np.log(error[300] / error[500]) / 0.2
    assert ratio == pytest.approx(GAIN * (1.0 + GAIN * TICK), rel=5e-3)  # acts one tick after it is read
    assert np.abs(error[-200:]).max() < 1e-9
    assert found.of("correction")[-1] == pytest.approx(1e-3, abs=1e-9)
    assert codes(found.recording) == set()


@pytest.mark.parametrize("gain", [10.0, 20.0])
def test_on_a_slope_the_difference_that_remains_is_its_rise_by_the_gain(gain: float) -> None:
    slope = 0.05
    start, line = line_at(0.0)
    found = Corrected(recorded(cell_with(slope), start, f"{line} {TRACK} gain {gain:g}"))
    middle = slice(1100, 1400)
    shift = found.of("correction")[middle]
    rate = (shift[-1] - shift[0]) / (len(shift) - 1) / 1e-3
    # the tool looks along TILT: shifting it by c moves it along x, too
    assert rate == pytest.approx(-SPEED * slope / (slope * TILT[0] - TILT[2]), rel=1e-3)
    assert found.gap(slope)[middle] == pytest.approx(rate / gain, rel=0.03)


def test_the_path_error_is_that_from_the_corrected_path() -> None:
    found = Corrected(over_the_flat(5.0, TRACK))
    assert found.of("correction").max() > 4.9e-3
    assert found.of("path_error").max() < NEAR


def test_a_move_that_is_not_corrected_is_the_same_as_without_a_sensor_in_the_cell() -> None:
    flat, bare = over_the_flat(0.0, TRACK), over_the_flat(0.0)  # it reads what it is to read
    assert "correction" not in bare.channels
    moved = Corrected(flat)
    assert np.abs(moved.of("correction")).max() < 1e-10
    assert flat.rows("attained_position")[-1] == pytest.approx(bare.rows("attained_position")[-1], abs=1e-10)


def test_a_move_before_one_that_is_corrected_keeps_its_bits() -> None:
    one, two = over_the_flat(5.0, TRACK), over_the_flat(5.0)
    before = Corrected(one).rows.start
    assert before > 500
    assert np.array_equal(one.rows("q_ref")[:before], two.rows("q_ref")[:before])


def test_a_value_that_a_hand_sets_moves_the_tool_as_a_sensor_does_and_nothing_while_it_is_right() -> None:
    start, line = line_at(0.0)
    found = Corrected(recorded(FLAT, start, f"{line} track hand = 0 gain 2"))
    changed = int((2.0 - (found.recording.time[found.rows.start])) * 1e3)
    assert not found.of("correction")[: changed - 1].any()
    assert found.of("correction")[-1] == pytest.approx(2.0 * 0.001 * 0.5, rel=0.02)


def test_limits_of_the_correction_hold_at_every_tick_and_the_one_of_its_size_is_told() -> None:
    limits = CorrectionLimits(size=0.004, speed=0.015, acceleration=0.3)
    start, line = line_at(8.0, 50.0)
    found = Corrected(
        recorded(cell_with(0.0, replace(CONTROLLER, correction=limits)), start, f"{line} {TRACK} gain 30")
    )
    shift = np.concatenate(([0.0], found.of("correction")))[::4]
    speed = np.diff(shift) / 4e-3
    assert shift.max() <= limits.size
    assert shift[-1] == pytest.approx(limits.size, abs=1e-5)
    assert np.abs(speed).max() <= limits.speed * (1.0 + 1e-9)
    assert np.abs(np.diff(speed)).max() / 4e-3 <= limits.acceleration * (1.0 + 1e-6)
    (told,) = [one for one in found.recording.findings if one.code == "S747"]
    assert told.span is not None
    assert told.span.line == 4
    assert "reached 4 mm" in told.message
    assert told.data["limit_m"] == limits.size
    assert found.of("path_error").max() < NEAR


@pytest.mark.parametrize("fidelity", list(Fidelity))
def test_references_with_a_correction_keep_the_limits_of_the_joints_and_have_no_step(
    fidelity: Fidelity,
) -> None:
    start, line = line_at(15.0)
    fast = line.replace("50 mm/s", "2000 mm/s acc 20000 mm/s2")
    options = RunOptions(fidelity, record_hz=1000)
    found = Corrected(recorded(cell_with(0.3), start, f"{fast} {TRACK} gain 25", options=options))
    q, qd = found.of("q_ref"), found.of("qd_ref")
    assert np.abs(found.of("correction")).max() > 1e-3
    assert (np.abs(qd) <= ROBOT.max_speeds).all()
    assert (np.abs(np.diff(qd, axis=0)) <= ROBOT.max_accelerations * 1e-3).all()
    assert np.abs(np.diff(q, axis=0) - (qd[1:] + qd[:-1]) / 2.0 * 1e-3).max() < NEAR
    assert not qd[-1].any()


def test_a_move_behind_a_corrected_one_takes_the_correction_back_without_a_jump() -> None:
    start, line = line_at(5.0, 40.0)
    recording = recorded(FLAT, start, f"{line} {TRACK}", "lin (500, 0, 150; ry 160 deg)")
    q, qd = recording.rows("q_ref"), recording.rows("qd_ref")
    assert np.abs(np.diff(q, axis=0) - (qd[1:] + qd[:-1]) / 2.0 * 1e-3).max() < NEAR
    end = forward_batch(ROBOT, q[-1:])[0, :3, 3]
    assert end == pytest.approx([0.5, 0.0, 0.15], abs=NEAR)


def held(*overrides: tuple[float, float]) -> RunOptions:
    changes = tuple(OverrideChange(*one) for one in overrides)
    return RunOptions(Fidelity.KINEMATIC, record_hz=1000, overrides=changes)


@pytest.mark.slow
def test_a_run_that_is_held_and_slowed_meanwhile_ends_at_the_same_place_and_does_not_drift() -> None:
    slope = 0.1
    start, line = line_at(3.0)
    lines = start, f"{line} {TRACK}"
    free = Corrected(recorded(cell_with(slope), *lines))
    stood = Corrected(
        recorded(cell_with(slope), *lines, options=held((2.0, 0.0), (2.7, 1.0), (3.0, 0.3), (3.5, 1.0)))
    )
    assert stood.recording.time[-1] > free.recording.time[-1] + 0.8
    assert stood.of("attained_position")[-1] == pytest.approx(free.of("attained_position")[-1], abs=2e-6)
    first = stood.recording.time[stood.rows.start]
    while_held = stood.of("correction")[int((2.5 - first) * 1e3) : int((2.6 - first) * 1e3)]
    assert (while_held == while_held[0]).all()
    q, qd = stood.of("q_ref"), stood.of("qd_ref")
    assert np.abs(np.diff(q, axis=0) - (qd[1:] + qd[:-1]) / 2.0 * 1e-3).max() < NEAR
    assert (np.abs(np.diff(qd, axis=0)) <= ROBOT.max_accelerations * 1e-3).all()


@pytest.mark.slow
def test_a_run_with_inputs_of_an_earlier_one_has_the_same_bits() -> None:
    start, line = line_at(3.0)
    inputs = (InputChange(1.8, "gap", 0.013), InputChange(2.2, "gap", 0.008))
    options = RunOptions(Fidelity.DYNAMIC, record_hz=1000, inputs=inputs)
    one, two = (recorded(FLAT, start, f"{line} {TRACK}", options=options) for _ in range(2))
    shift = Corrected(one).of("correction")
    assert shift.max() > 3e-3 > -1e-3 > shift[-1]  # the hand is stronger than the sensor
    for name, channel in one.channels.items():
        assert np.array_equal(channel.values, two.channels[name].values, equal_nan=True)


@pytest.mark.slow
@pytest.mark.parametrize("way", ["(760, 170, 300; ry 90 deg)", "(760, 180, 300; ry 90 deg)"])
def test_a_correction_stops_before_the_arm_is_stretched_out_and_goes_back_where_the_path_leads_there(
    way: str,
) -> None:
    recording = recorded(
        FLAT, "mov (760, 150, 300; ry 90 deg)", f"lin {way} speed 10 mm/s track hand = -0.01"
    )
    found = Corrected(recording)
    (told,) = [one for one in recording.findings if one.code == "S748"]
    assert told.span is not None
    assert told.span.line == 4
    shift, qd = found.of("correction"), found.of("qd_ref")
    assert 5e-3 < shift.max() < 0.02
    assert shift[-1] < shift.max() - 1e-3
    assert codes(recording) == {"S748"}
    assert (np.abs(qd) <= ROBOT.max_speeds).all()
    assert (np.abs(np.diff(qd, axis=0)) <= ROBOT.max_accelerations * 1e-3).all()


def test_a_zone_before_and_at_a_corrected_move_is_a_stop() -> None:
    start, line = line_at(2.0, 0.0)
    recording = recorded(
        FLAT,
        start,
        "lin (450, 0, 150; ry 160 deg) blend 10 mm",
        f"{line.replace('460, 150', '465, 10')} blend 10 mm {TRACK}",
        "lin (500, 0, 200; ry 160 deg)",
    )
    said = [one.message for one in recording.findings if one.code == "M560"]
    assert [text.rpartition(": ")[2] for text in said] == [
        "a sensor corrects the next move",
        "a sensor corrects the move",
    ]


class Towards:
    """A corrector that goes to one shift, whatever is measured; a PathCorrector."""

    def __init__(self, wanted: float) -> None:
        self.wanted = wanted

    def correct(self, measured: Sample, tracking: PathTracking, X_BT: Pose, correction: float) -> float:
        del measured, tracking, X_BT
        return 12.0 * (self.wanted - correction)


def with_corrector(corrector: PathCorrector) -> RunOptions:
    chain = replace(standard_chain(FLAT, FLAT.first), corrector=corrector)
    return RunOptions(Fidelity.KINEMATIC, record_hz=1000, chains={FLAT.first.name: chain})


def test_a_corrector_of_a_user_takes_the_place_of_the_standard_one_within_the_same_limits() -> None:
    start, line = line_at(0.0, 50.0)
    found = Corrected(recorded(FLAT, start, f"{line} {TRACK}", options=with_corrector(Towards(0.004))))
    shift = found.of("correction")
    assert shift[-1] == pytest.approx(0.004, abs=1e-5)
    assert np.abs(np.diff(shift)).max() <= 0.02 * 1e-3 * (1.0 + 1e-9)


def test_a_corrector_that_answers_no_number_is_told_and_nothing_is_shifted() -> None:
    start, line = line_at(3.0, 20.0)
    recording = recorded(FLAT, start, f"{line} {TRACK}", options=with_corrector(Towards(np.nan)))
    (told,) = [one for one in recording.findings if one.code == "C603"]
    assert "`Towards` returned nan as speed of a correction" in told.message
    assert not Corrected(recording).of("correction").any()


def test_a_path_along_which_an_external_axis_goes_is_not_corrected() -> None:
    text = """
[robot]
model = "puma560"
positioner = { radius = 260, height = 400, base = { position = [600, 0, 0] } }
[signals.hand]
input = 1
analog = true
[frames.plate]
parent = "positioner"
position = [0, 0, 0]
"""
    cell, _ = read_cell(SourceText("cell.toml", text), "c")
    assert cell is not None
    near = "loc a = (-170, 0, 160, 180, 0, 0) in plate"
    lines = near, "mov a external (0)", "lin a external (20) track hand = 0.0", "lin a offset (0, 20, 0)"
    recording = run(cell, {cell.first.name: code_of(cell, *lines)}, RunOptions(Fidelity.KINEMATIC))
    (told,) = [one for one in recording.findings if one.code == "M587"]
    assert told.span is not None
    assert told.span.line == 5
    assert "correction" not in recording.channels
    still = near, "mov a external (20)", "lin a offset (0, 20, 0) track hand = -0.01"
    recording = run(cell, {cell.first.name: code_of(cell, *still)}, RunOptions(Fidelity.KINEMATIC))
    assert "M587" not in codes(recording)
    assert np.nanmax(recording.rows("correction")) > 1e-3
    corrected = ~np.isnan(recording.rows("correction"))
    assert np.ptp(recording.rows("q_ref")[corrected, 6]) < 1e-12  # the positioner stands
    assert np.nanmax(recording.rows("path_error")) < NEAR


def test_a_condition_ends_a_motion_that_is_corrected_and_the_shift_stays() -> None:
    start, line = line_at(0.0)
    lines = start, f"{line} track hand = -0.001 until gap < 8 mm store there", "print there.x"
    recording = recorded(FLAT, *lines)
    found = Corrected(recording)
    shift = found.of("correction")
    assert 1.9e-3 < shift[-1] < 4e-3  # the rest while the arm brakes
    assert codes(recording) == set()
    q, qd = recording.rows("q_ref"), recording.rows("qd_ref")
    assert np.abs(np.diff(q, axis=0) - (qd[1:] + qd[:-1]) / 2.0 * 1e-3).max() < NEAR
    assert (np.abs(np.diff(found.of("qd_ref"), axis=0)) <= ROBOT.max_accelerations * 1e-3).all()
    assert found.of("attained_position")[-1, 0] < 0.54


@dataclass
class Hand(NobodyWatches):
    """Presses a key and sets the override of a live run when it has come to given times [s]."""

    acts: list[tuple[float, str, float]]

    @property
    def may_press(self) -> bool:
        """Return True, so that slices are short."""
        return True

    def advanced(self, run: RunView) -> None:
        while self.acts and run.time >= self.acts[0][0]:
            _, what, value = self.acts.pop(0)
            if what == "override":
                run.set_override(value)
            else:
                run.press(what, run.farthest + 1, value)


@pytest.mark.slow
def test_a_live_run_with_keys_and_overrides_is_repeated_to_the_bit() -> None:
    start, line = line_at(3.0)
    hand = Hand([(1.7, "gap", 0.013), (1.9, "override", 0.37), (2.2, "override", 1.0), (2.5, "gap", 0.008)])
    live = recorded(
        FLAT, start, f"{line} {TRACK}", options=RunOptions(Fidelity.KINEMATIC, record_hz=1000, watch=hand)
    )
    assert len(live.facts.inputs) == 2
    assert len(live.facts.overrides) == 2
    options = RunOptions(
        Fidelity.KINEMATIC, record_hz=1000, inputs=live.facts.inputs, overrides=live.facts.overrides
    )
    again = recorded(FLAT, start, f"{line} {TRACK}", options=options)
    for name in ("q_ref", "qd_ref", "correction", "path_error"):
        assert np.array_equal(live.rows(name), again.rows(name), equal_nan=True)


@pytest.mark.parametrize("seed", [1, 2, 3])
def test_fast_motions_with_wild_signals_and_overrides_keep_the_limits_of_the_joints(seed: int) -> None:
    rng = np.random.default_rng(seed)
    times = np.sort(rng.uniform(1.0, 3.0, 12)).tolist()
    changes = tuple(zip(times, rng.uniform(-0.05, 0.05, 12).tolist(), strict=True))
    limits = CorrectionLimits(size=0.03, speed=0.3, acceleration=5.0)
    cell = cell_with(0.0, replace(CONTROLLER, correction=limits))
    hand = Signal("hand", is_input=True, analog=True, changes=changes)
    cell = replace(cell, signals={**cell.signals, "hand": hand})
    ends = [f"({x:.1f}, {y:.1f}, 250; ry 150 deg)" for x, y in rng.uniform((400, -200), (550, 200), (2, 2))]
    axis = ("x", "-y", "z")[seed - 1]
    fast = f"lin {ends[1]} speed 600 mm/s acc 8 m/s2 track hand = 0.0 along {axis} gain 25"
    options = held((1.7, 0.4), (1.9, 0.0), (2.1, 1.0))
    found = Corrected(recorded(cell, f"mov {ends[0]}", fast, options=options))
    q, qd, shift = found.of("q_ref"), found.of("qd_ref"), found.of("correction")
    assert 1e-3 < np.abs(shift).max() <= limits.size
    assert (np.abs(qd) <= ROBOT.max_speeds).all()
    assert (np.abs(np.diff(qd, axis=0)) <= ROBOT.max_accelerations * 1e-3).all()
    assert np.abs(np.diff(q, axis=0) - (qd[1:] + qd[:-1]) / 2.0 * 1e-3).max() < NEAR
    assert found.of("path_error").max() < 1e-5  # rows between two interpolation ticks


@pytest.mark.parametrize(
    ("end", "speed"), [("(550, 150, 250; ry 150 deg)", 900), ("(400, -149, 250; ry 150 deg)", 2)]
)
def test_a_motion_that_is_held_while_its_correction_is_at_its_quickest_brakes_within_the_limits(
    end: str, speed: int
) -> None:
    """Quick motions take most of the accelerations for themselves, slow ones could stop at once."""
    limits = CorrectionLimits(size=0.03, speed=1.0, acceleration=20.0)
    cell = cell_with(0.0, replace(CONTROLLER, correction=limits))
    start = "mov (400, -150, 250; ry 150 deg)"
    line = f"lin {end} speed {speed} mm/s acc 8 m/s2 track hand = 0.05 along -y gain 25"
    found = Corrected(recorded(cell, start, line, options=held((1.6, 0.0), (1.8, 1.0))))
    assert np.abs(found.of("correction")).max() > 1e-3
    assert (np.abs(np.diff(found.of("qd_ref"), axis=0)) <= ROBOT.max_accelerations * 1e-3).all()


def test_a_motion_whose_correction_the_arm_cannot_keep_ends_there(monkeypatch: pytest.MonkeyPatch) -> None:
    follow = ShiftedArm.shifted

    def nowhere_in_the_middle(
        arm: ShiftedArm, q: Array, qd: Array, correction: Correction, rate: float, guess: ShiftedJoints
    ) -> ShiftedJoints | None:
        if 0.475 < arm.pose(q).position[0] < 0.485:
            return None
        return follow(arm, q, qd, correction, rate, guess)

    monkeypatch.setattr(ShiftedArm, "shifted", nowhere_in_the_middle)
    start, line = line_at(15.0, 35.0)
    found = Corrected(recorded(FLAT, start, f"{line} {TRACK}"))
    ends = found.of("command_position")[-1, 0]
    assert 0.475 < ends < 0.485  # it begins at one side of these, and goes to the other
    assert (np.abs(np.diff(found.of("qd_ref"), axis=0)) <= ROBOT.max_accelerations * 1e-3).all()
    (told,) = [one for one in found.recording.findings if one.code == "S748"]
    assert "the motion was ended" in told.message


@pytest.mark.parametrize("speed", [20, 40])
def test_a_path_to_the_stretched_arm_with_a_correction_keeps_the_limits_of_the_joints(speed: int) -> None:
    way = f"lin (770, 170, 300; ry 90 deg) speed {speed} mm/s track hand = -0.01"
    found = Corrected(recorded(FLAT, "mov (760, 150, 300; ry 90 deg)", way))
    qd = found.of("qd_ref")
    assert (np.abs(qd) <= ROBOT.max_speeds).all()
    assert (np.abs(np.diff(qd, axis=0)) <= ROBOT.max_accelerations * 1e-3).all()
    assert "S748" in codes(found.recording)
    assert "S732" not in codes(found.recording)
