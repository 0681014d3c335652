"""What a right cell file means."""

import math

import numpy as np
import pytest

from ropsim import robots
from ropsim.cellfile import read_cell
from ropsim.core import SourceText
from ropsim.icr import DryRun, run
from ropsim.language import Environment
from ropsim.language import compile as compile_text
from ropsim.model import (
    CascadedGains,
    Cell,
    ComputedTorqueGains,
    ControllerKind,
    CorrectionLimits,
    Rates,
    ShortLines,
)
from ropsim.workbench import environment_of
from support.gains import cascaded

POSE_TOLERANCE = 1e-12  # [m], a few roundings of coordinates below 1 m
HEAD = '[robot]\nmodel = "puma560"\n'


def run_of(text: str, environment: Environment) -> DryRun:
    """Return the dry run of a program in an environment."""
    compiled = compile_text(text, environment)
    assert compiled.icr is not None
    return run(compiled.icr)


def cell_of(text: str) -> Cell:
    cell, findings = read_cell(SourceText("cell.toml", HEAD + text), "folder")
    assert [str(found) for found in findings] == []
    assert cell is not None
    return cell


def test_the_smallest_file_gives_the_robot_at_home_with_its_own_controller() -> None:
    cell = cell_of("")
    assert cell.name == "folder"
    assert cell.first.program == "main"
    assert cell.first.robot.name == "puma560"
    assert np.array_equal(cell.first.start, cell.first.robot.home)
    assert cell.first.controller.speed_override == 1.0
    assert cell.first.default_tool == ""
    assert cell.classic.length == 0.01
    assert not cell.parts
    assert not cell.first.tools


def test_name_and_default_program_come_from_the_section_cell() -> None:
    cell = cell_of('[cell]\nname = "line 3"\nprogram = "stack"\n')
    assert (cell.name, cell.first.program) == ("line 3", "stack")


@pytest.mark.parametrize(("unit", "metres"), [("mm", 0.001), ("cm", 0.01), ("m", 1.0), ("inch", 0.0254)])
def test_lengths_are_in_the_unit_of_the_file(unit: str, metres: float) -> None:
    cell = cell_of(f'[units]\nlength = "{unit}"\n[frames.f]\nposition = [1, -2, 0.5]\n')
    expected = metres * np.array([1.0, -2.0, 0.5])
    assert np.allclose(cell.frames["f"].X_PK.position, expected, rtol=0, atol=POSE_TOLERANCE)


def test_angles_may_be_in_radians() -> None:
    cell = cell_of('[units]\nangle = "rad"\n[frames.f]\nposition = [0, 0, 0]\nrpy = [0, 0, 1.5]\n')
    assert cell.frames["f"].X_PK.orientation[3] == pytest.approx(math.sin(0.75))


def test_rpy_turns_about_the_fixed_axes_x_then_y_then_z() -> None:
    cell = cell_of("[frames.f]\nposition = [0, 0, 0]\nrpy = [30, 40, 50]\n")
    a, b, c = (math.radians(angle) for angle in (30, 40, 50))
    rx = np.array([[1, 0, 0], [0, math.cos(a), -math.sin(a)], [0, math.sin(a), math.cos(a)]])
    ry = np.array([[math.cos(b), 0, math.sin(b)], [0, 1, 0], [-math.sin(b), 0, math.cos(b)]])
    rz = np.array([[math.cos(c), -math.sin(c), 0], [math.sin(c), math.cos(c), 0], [0, 0, 1]])
    assert np.allclose(cell.frames["f"].X_PK.rotation(), rz @ ry @ rx, rtol=0, atol=POSE_TOLERANCE)


def test_a_quaternion_may_replace_rpy() -> None:
    cell = cell_of("[frames.f]\nposition = [0, 0, 0]\nquaternion = [0.7071, 0, 0, 0.7071]\n")
    assert np.allclose(
        cell.frames["f"].X_PK.orientation, [math.sqrt(0.5), 0, 0, math.sqrt(0.5)], rtol=0, atol=1e-9
    )


def test_file_and_cell_speak_of_the_world_wherever_the_base_stands() -> None:
    text = (
        "base = { position = [100, 0, 0], rpy = [0, 0, 90] }\n"
        "[frames.f]\nposition = [100, 200, 300]\n"
        "[locations.l]\nposition = [0, 0, 0]\n"
        '[[sinks]]\nname = "bin"\nposition = [100, 50, 0]\nradius = 20\n'
        '[[parts]]\nname = "box"\nsize = [1, 2, 3]\nmass = 1\nposition = [110, 0, 0]\n'
    )
    cell = cell_of(text)
    assert np.allclose(cell.first.X_WB.position, [0.1, 0, 0], rtol=0, atol=POSE_TOLERANCE)
    assert np.allclose(cell.frames["f"].X_PK.position, [0.1, 0.2, 0.3], rtol=0, atol=POSE_TOLERANCE)
    assert np.allclose(cell.locations["l"].position, [0, 0, 0], rtol=0, atol=POSE_TOLERANCE)
    assert np.allclose(cell.sinks[0].position, [0.1, 0.05, 0], rtol=0, atol=POSE_TOLERANCE)
    assert np.allclose(cell.parts[0].X_WO.position, [0.11, 0, 0], rtol=0, atol=POSE_TOLERANCE)


def test_a_tilted_base_turns_gravity_and_an_upright_one_leaves_the_model_alone() -> None:
    upright = cell_of("base = { rpy = [0, 0, 33] }\n")
    wall = cell_of("base = { rpy = [0, 90, 0] }\n")
    assert upright.first.robot is cell_of("").first.robot
    assert np.allclose(wall.first.robot.gravity, [9.81, 0, 0], rtol=0, atol=1e-9)


def test_a_location_points_the_tool_straight_down_unless_told_otherwise() -> None:
    text = (
        "[locations.down]\nposition = [1, 2, 3]\n"
        "[locations.level]\nposition = [1, 2, 3]\ndown = false\n"
        "[locations.turned]\nposition = [1, 2, 3]\nrpy = [0, 0, 90]\n"
    )
    cell = cell_of(text)
    assert np.allclose(cell.locations["down"].rotation(), np.diag([1.0, -1.0, -1.0]), rtol=0, atol=1e-12)
    assert np.allclose(cell.locations["level"].rotation(), np.eye(3), rtol=0, atol=1e-12)
    assert np.allclose(cell.locations["turned"].rotation()[0], [0, -1, 0], rtol=0, atol=1e-12)


def test_the_orientation_of_a_location_may_be_free() -> None:
    text = (
        '[locations.loose]\nposition = [1, 2, 3]\norientation = "free"\n'
        '[locations.fixed]\nposition = [1, 2, 3]\norientation = "given"\n'
        "[locations.plain]\nposition = [1, 2, 3]\n"
    )
    cell = cell_of(text)
    assert cell.free == {"loose"}
    assert environment_of(cell).free == {"loose"}
    (move,) = run_of("program p\nmov loose\n", environment_of(cell)).moves
    assert move.has_free_orientation
    (move,) = run_of("program p\nmov fixed\n", environment_of(cell)).moves
    assert not move.has_free_orientation


def test_another_word_for_the_orientation_is_refused() -> None:
    text = '[locations.loose]\nposition = [1, 2, 3]\norientation = "fre"\n'
    _, findings = read_cell(SourceText("cell.toml", HEAD + text), "folder")
    assert [found.hint for found in findings] == ["did you mean `free`?"]


def test_a_location_may_be_given_in_a_frame() -> None:
    text = (
        "[frames.pallet]\nposition = [500, 0, 100]\nrpy = [0, 0, 90]\n"
        '[locations.corner]\nframe = "pallet"\nposition = [10, 20, 0]\n'
    )
    position = cell_of(text).locations["corner"].position
    assert np.allclose(position, [0.48, 0.01, 0.1], rtol=0, atol=POSE_TOLERANCE)


def test_a_tool_has_pose_mass_inertia_and_gripper() -> None:
    text = (
        'tool = "jaws"\n'
        "[tools.jaws]\nposition = [0, 0, 120]\nmass = 0.8\ncom = [0, 1, 60]\n"
        "inertia = [0.003, 0.002, 0.002, 0.0001, 0, 0.0002]\n"
        "gripper = { open_time = 0.3, close_time = 0.25, capture = 4 }\n"
        "[tools.pen]\nposition = [0, 0, 80]\n"
    )
    cell = cell_of(text)
    jaws = cell.first.tools["jaws"]
    assert cell.first.default_tool == "jaws"
    assert jaws.X_MT.position[2] == pytest.approx(0.12)
    assert (jaws.mass, jaws.com.tolist()) == (0.8, [0.0, 0.001, 0.06])
    assert jaws.inertia.tolist() == [[0.003, 0.0001, 0.0], [0.0001, 0.002, 0.0002], [0.0, 0.0002, 0.002]]
    assert jaws.gripper is not None
    assert (jaws.gripper.open_time, jaws.gripper.close_time, jaws.gripper.capture) == (0.3, 0.25, 0.004)
    assert cell.first.tools["pen"].gripper is None


def test_a_grid_makes_parts_that_run_along_the_first_direction_first() -> None:
    text = (
        '[[parts]]\nname = "box"\nsize = [60, 60, 40]\nmass = 0.5\nposition = [400, 0, 40]\n'
        "grid = { counts = [2, 3], step = [[70, 0, 0], [0, 80, 1]] }\n"
    )
    parts = cell_of(text).parts
    assert [part.name for part in parts] == [f"box_{k}" for k in range(1, 7)]
    assert np.allclose(parts[1].X_WO.position, [0.47, 0, 0.04], rtol=0, atol=POSE_TOLERANCE)
    assert np.allclose(parts[5].X_WO.position, [0.47, 0.16, 0.042], rtol=0, atol=POSE_TOLERANCE)
    assert all(part.supply == "" for part in parts)


def test_a_supply_makes_a_queue_of_parts_at_one_place() -> None:
    text = '[[supplies]]\nname = "infeed"\nsize = [60, 60, 40]\nmass = 0.5\nposition = [1, 2, 3]\ncount = 3\n'
    parts = cell_of(text).parts
    assert [(part.name, part.supply, part.turn) for part in parts] == [
        ("infeed_1", "infeed", 0),
        ("infeed_2", "infeed", 1),
        ("infeed_3", "infeed", 2),
    ]
    assert len({part.X_WO for part in parts}) == 1


def test_signals_have_direction_channel_sort_and_history() -> None:
    text = (
        "[signals.ready]\ninput = 3\ninitial = true\nchanges = [[0.5, false], [2, 1]]\n"
        "[signals.force]\ninput = 3\nanalog = true\ninitial = -2.5\n"
        "[signals.lamp]\noutput = 3\n"
    )
    signals = cell_of(text).signals
    assert (signals["ready"].is_input, signals["ready"].channel, signals["ready"].initial) == (True, 3, 1.0)
    assert signals["ready"].changes == ((0.5, 0.0), (2.0, 1.0))
    assert (signals["force"].analog, signals["force"].initial) == (True, -2.5)
    assert not signals["lamp"].is_input


def test_the_controller_can_be_changed_value_by_value() -> None:
    text = (
        "speed_override = 0.5\nstart = [0, 90, 0, 0, 0, 10]\n"
        "[controller]\ncontrol_hz = 500\nkp = [1, 2, 3, 4, 5, 6]\npath_speed = 150\n"
        "orientation_speed = 90\nin_position = [0.1, 0.1, 0.1, 0.1, 0.1, 0.1]\n"
        'ptp = "time"\nshort_lines = "zones"\n'
        "correction_size = 5\ncorrection_speed = 40\ncorrection_acceleration = 300\n"
    )
    cell = cell_of(text)
    controller = cell.first.controller
    own = robots.cascaded_controller(cell.first.robot, Rates())
    assert controller.speed_override == 0.5
    assert cell.first.start[1] == pytest.approx(math.pi / 2)
    assert controller.rates.control_hz == 500
    assert cascaded(controller).kp.tolist() == [1, 2, 3, 4, 5, 6]
    assert controller.path.speed == pytest.approx(0.15)
    assert controller.path.orientation_speed == pytest.approx(math.pi / 2)
    assert controller.in_position[0] == pytest.approx(math.radians(0.1))
    assert (cascaded(controller).kv < cascaded(own).kv).all()  # slower loops at half the control rate
    assert cascaded(controller).ke.tolist() == cascaded(own).ke.tolist()
    assert controller.origins[0].source.startswith("kp as in the cell file; the others from masses")
    assert controller.path.jerk == own.path.jerk
    assert (controller.ptp.value, own.ptp.value) == ("time", "phase")
    assert (controller.short_lines, own.short_lines) == (ShortLines.ZONES, ShortLines.CURVES)
    assert controller.correction == CorrectionLimits(0.005, 0.04, 0.3)
    assert own.correction == CorrectionLimits(0.02, 0.02, 0.5)


@pytest.mark.parametrize(
    ("line", "kind"),
    [
        ("", ControllerKind.COMPUTED_TORQUE),
        ('law = "fixed gains"', ControllerKind.CASCADED_P_PI),
        ('law = "computed torque"\nkp = [9, 9, 9, 9, 9, 9]', ControllerKind.COMPUTED_TORQUE),
        ("kp = [9, 9, 9, 9, 9, 9]", ControllerKind.CASCADED_P_PI),
        ("ki = [9, 9, 9, 9, 9, 9]", ControllerKind.CASCADED_P_PI),
        ("kp = [9, 9, 9, 9, 9, 9]\nkd = [9, 9, 9, 9, 9, 9]", ControllerKind.COMPUTED_TORQUE),
    ],
)
def test_stated_gains_of_a_geared_arm_are_those_of_loops_unless_kd_is_among_them(
    line: str, kind: ControllerKind
) -> None:
    controller = cell_of(f"[controller]\n{line}\n").first.controller
    assert controller.kind is kind
    if "kp" in line:
        assert isinstance(controller.gains, CascadedGains | ComputedTorqueGains)
        assert controller.gains.kp.tolist() == [9.0] * 6


def test_classic_settings_name_units_and_frame_of_old_files() -> None:
    text = (
        '[frames.table]\nposition = [0, 0, 0]\n[classic]\nlength = "inch"\nangle = "rad"\nframe = "table"\n'
    )
    classic = cell_of(text).classic
    assert (classic.length, classic.angle, classic.frame) == (0.0254, 1.0, "table")


def test_windows_line_ends_make_no_difference() -> None:
    text = HEAD + "[frames.f]\nposition = [1, 2, 3]\n"
    cell, findings = read_cell(SourceText("cell.toml", text.replace("\n", "\r\n")), "folder")
    assert not findings
    assert cell is not None
    assert "f" in cell.frames
