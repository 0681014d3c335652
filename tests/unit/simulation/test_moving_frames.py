"""Task frames on a positioner: locations in them are where the axis has brought them when a move ends."""

from functools import cache

import numpy as np
import pytest

from ropsim import icr, language
from ropsim.cellfile import read_cell
from ropsim.core import SourceText
from ropsim.flow import MessageEvent, ModalState, MoveInstruction, Origin, Recording
from ropsim.kinematics import body_poses, forward, frame_poses
from ropsim.model import Cell, body_tree
from ropsim.planning import standard_chain
from ropsim.simulation import Fidelity, RunOptions, run
from ropsim.spatial import Pose
from ropsim.workbench import environment_of

CELL = """
[robot]
model = "puma560"
base = { position = [100, 0, 0], rpy = [0, 0, 20] }
tool = "jaws"
positioner = { radius = 250, height = 500, base = { position = [600, 150, 0] } }
[tools.jaws]
position = [0, 0, 150]
mass = 0.5
gripper = {}
[frames.fixture]
parent = "positioner"
position = [0, 100, 20]
rpy = [0, 0, 90]
[frames.pallet]
position = [300, -400, 300]
[locations.corner]
frame = "fixture"
position = [30, 0, 40]
[locations.infeed]
position = [400, -200, 400]
[[objects]]
name = "nest"
parent = "positioner"
position = [0, 100, 20]
size = [100, 100, 20]
[[parts]]
name = "box"
size = [40, 40, 40]
mass = 0.2
position = [600, 280, 560]
"""
HEAD = "program main\nunits mm, deg, s\n"
GRID = """pattern slots = grid 1 x 2 from corner step (0, 0, 0), (0, 30, 0)
for each s in slots
  mov s above 80
endf
"""
TURNED = "mov joints(0, 75, -180, 0, -75, 0, {})\n"
REACHED = 1e-6  # [m | -], the polish of inverse kinematics


@cache
def cell_of(text: str = CELL) -> Cell:
    cell, findings = read_cell(SourceText("cell.toml", text), "frames")
    assert [str(one) for one in findings] == []
    assert cell is not None
    return cell


def compiled(lines: str, cell: Cell | None = None, station: str = "") -> language.Compiled:
    cell = cell or cell_of()
    return language.compile(HEAD + lines, environment_of(cell, cell.stations.get(station)), name="main.task")


def ran(lines: str, cell: Cell | None = None) -> Recording:
    code = compiled(lines, cell)
    assert [str(one) for one in code.diagnostics] == []
    assert code.icr is not None
    return run(cell or cell_of(), {"robot": code.icr}, RunOptions(fidelity=Fidelity.KINEMATIC))


def tool_pose_at_the_end(recording: Recording) -> Pose:
    """Return X_WT of the tool of the cell when the run ends."""
    station = cell_of().first
    q = recording.channels["q"].values[-1]
    return station.X_WB @ forward(station.robot, q) @ station.tools["jaws"].X_MT


def in_fixture(
    x: float, y: float, z: float, turned: float, tool: tuple[float, ...] = (0.0, 1.0, 0.0, 0.0)
) -> Pose:
    """Return X_WT of a tool pose in the frame `fixture` [m], with the positioner turned by an angle [rad]."""
    plate = Pose(np.array([0.6, 0.15, 0.5]), np.array([np.cos(turned / 2.0), 0.0, 0.0, np.sin(turned / 2.0)]))
    X_PK = Pose(np.array([0.0, 0.1, 0.02]), np.array([np.sqrt(0.5), 0.0, 0.0, np.sqrt(0.5)]))
    return plate @ X_PK @ Pose(np.array([x, y, z]), np.array(tool))


def assert_there(recording: Recording, X_WT: Pose) -> None:
    assert [str(one) for one in recording.findings] == []
    np.testing.assert_allclose(
        tool_pose_at_the_end(recording).matrix(), X_WT.matrix(), rtol=0.0, atol=REACHED
    )


@pytest.mark.parametrize("turn", [0.0, 40.0, -75.0])
@pytest.mark.parametrize(
    ("lines", "place"),
    [
        ("mov corner\n", (0.03, 0.0, 0.04)),
        ("mov corner above 80\nlin corner\n", (0.03, 0.0, 0.04)),
        ("mov corner above 80\n", (0.03, 0.0, 0.12)),
        ("mov corner offset (10, 20, 30)\n", (0.04, 0.02, 0.07)),
        ("mov corner rel (10, 20, -30)\n", (0.04, -0.02, 0.07)),
        ("mov (10, 20, 60) in fixture\n", (0.01, 0.02, 0.06)),
        ("with frame fixture\n  mov (10, 20, 60)\nendwith\n", (0.01, 0.02, 0.06)),
        ("q = corner above 80\nmov q\n", (0.03, 0.0, 0.12)),
        ("q = corner\nq.z = 100\nmov q\n", (0.03, 0.0, 0.1)),
        ("mov infeed\nvisit corner\n", (0.03, 0.0, 0.09)),
        ("mov corner\nmov here above 50\n", (0.03, 0.0, 0.09)),
        (GRID, (0.03, 0.03, 0.12)),
    ],
)
def test_a_location_in_the_frame_is_reached_wherever_the_positioner_stands(
    turn: float, lines: str, place: tuple[float, float, float]
) -> None:
    task = "task visit(l)\n  mov l above 50\nendtask\n" if "visit" in lines else ""
    recording = ran(task + TURNED.format(turn) + lines)
    assert_there(recording, in_fixture(*place, np.radians(turn)))


def test_a_location_is_relative_until_a_move_is_planned() -> None:
    """What a variable keeps is a place on the plate, not one in the world."""
    lines = "q = corner above 60\n" + TURNED.format(30) + "mov q\n" + TURNED.format(-50) + "mov q\n"
    assert_there(ran(lines), in_fixture(0.03, 0.0, 0.1, np.radians(-50.0)))


def test_locations_that_stand_still_stay_where_they_are() -> None:
    down = (0.0, 1.0, 0.0, 0.0)
    lines = "set frame fixture\n" + TURNED.format(70) + "mov infeed\n"
    recording = ran(lines)
    assert_there(recording, Pose(np.array([0.4, -0.2, 0.4]), np.array(down)))
    recording = ran(TURNED.format(70) + "with frame fixture\n  mov (0, 0, 100) in pallet\nendwith\n")
    assert_there(recording, Pose(np.array([0.3, -0.4, 0.4]), np.array(down)))


def test_numbers_of_a_location_are_those_in_its_frame() -> None:
    recording = ran(TURNED.format(30) + 'print corner.x, " ", corner.z\nprint corner\n')
    texts = [event.text for event in recording.events_of(MessageEvent)]
    assert texts[0].split() == ["30", "mm", "40", "mm"]
    assert texts[1].endswith("in fixture")


def test_a_part_is_gripped_in_the_nest_that_has_turned_away() -> None:
    recording = ran(TURNED.format(-60) + "mov corner above 80\nlin corner\nclose\nlin corner above 80\n")
    assert [str(one) for one in recording.findings] == []
    assert [one.parent for one in recording.placements if one.body == "box"] == ["nest", "tool:jaws"]


def test_a_part_lies_on_the_nest_at_the_location_of_its_frame() -> None:
    """The cell says it twice: as a place in the world with the axis at 0, and in the frame."""
    X_WT = in_fixture(0.03, 0.0, 0.04, 0.0)
    np.testing.assert_allclose(X_WT.position, cell_of().parts[0].X_WO.position, atol=REACHED)
    start = frame_poses(cell_of())["fixture"]
    np.testing.assert_allclose((start @ cell_of().locations["corner"]).matrix(), X_WT.matrix(), atol=REACHED)


def test_the_instruction_names_the_frame_and_leaves_the_one_in_force() -> None:
    code = compiled("mov corner\nmov infeed\n")
    assert code.icr is not None
    moves = [one for one in icr.run(code.icr).instructions if isinstance(one, MoveInstruction)]
    assert [one.modal.frame for one in moves] == ["fixture", ""]
    assert isinstance(moves[0].target, Pose)
    assert moves[0].target.position.tolist() == pytest.approx([0.03, 0.0, 0.04])
    text = icr.disassemble(code.icr)
    assert "INFRAME fixture" in text
    assert icr.disassemble(icr.assemble(text, "main.icr")) == text


def test_distances_between_frames_that_move_against_each_other_are_not_known() -> None:
    recording = ran("d = dist(corner, infeed)\nprint d\n")
    (found,) = recording.findings
    assert found.code == "I465"
    assert "`fixture` and the task frame in force" in found.message
    assert [str(one) for one in ran("d = dist(corner, corner above 50)\nprint d\n").findings] == []


def test_a_frame_of_the_program_cannot_lie_in_one_that_moves() -> None:
    code = compiled("frame shelf = (0, 0, 300) in fixture\nmov infeed\n")
    (found,) = code.diagnostics
    assert (found.code, found.span and found.span.line) == ("N215", 3)
    assert "cannot be given in `fixture`" in found.message


TWO = (
    CELL.replace("[robot]\nmodel", "[stations.right]\nrobot").replace(
        'parent = "positioner"', 'parent = "right/positioner"'
    )
    + '[stations.left]\nrobot = "puma560"\nbase = { position = [600, 900, 0], rpy = [0, 0, -90] }\n'
)


def test_a_frame_of_another_station_is_refused_on_the_line_that_works_in_it() -> None:
    cell = cell_of(TWO)
    code = compiled("mov corner\n", cell, "left")
    assert code.icr is not None
    recording = run(cell, {"left": code.icr}, RunOptions(fidelity=Fidelity.KINEMATIC))
    (found,) = recording.findings
    assert (found.code, found.span and found.span.line) == ("M519", 3)
    assert "task frame `fixture` is moved by the station `right`" in found.message
    own = compiled(TURNED.format(30) + "mov corner\n", cell, "right")
    assert own.icr is not None
    done = run(cell, {"right": own.icr}, RunOptions(fidelity=Fidelity.KINEMATIC))
    assert [str(one) for one in done.findings] == []
    q = done.channels["right/q"].values[-1]
    at = cell.stations["right"]
    tcp = at.X_WB @ forward(at.robot, q) @ at.tools["jaws"].X_MT
    np.testing.assert_allclose(
        tcp.matrix(), in_fixture(0.03, 0.0, 0.04, np.radians(30.0)).matrix(), atol=REACHED
    )


def test_a_frame_on_the_carriage_goes_with_the_arm() -> None:
    text = (
        '[robot]\nmodel = "puma560"\ntrack = { length = 2000 }\n'
        '[frames.rack]\nparent = "track"\nposition = [300, 300, 200]\n'
    )
    cell = cell_of(text)
    code = compiled("mov joints(0, 75, -180, 0, -75, 0, 600)\nmov (0, 0, 200) in rack\n", cell)
    assert code.icr is not None
    recording = run(cell, {"robot": code.icr}, RunOptions(fidelity=Fidelity.KINEMATIC))
    assert [str(one) for one in recording.findings] == []
    q = recording.channels["q"].values[-1]
    assert q[6] == pytest.approx(0.6)
    np.testing.assert_allclose(forward(cell.first.robot, q).position, [0.9, 0.3, 0.75], atol=REACHED)


def test_the_body_tree_and_the_controller_agree_on_where_the_frame_is() -> None:
    cell = cell_of()
    q = np.append(cell.first.robot.home[:6], 0.7)
    plate = body_poses(body_tree(cell), {"robot": q[None]})["link7"][0]
    frame = cell.frames["fixture"]
    np.testing.assert_allclose(
        plate @ frame.X_PK.matrix(), in_fixture(0, 0, 0, 0.7, (1, 0, 0, 0)).matrix(), atol=REACHED
    )


@pytest.mark.parametrize("turn", [0.0, 40.0, -75.0])
@pytest.mark.parametrize(
    ("lines", "place"),
    [
        ("mov corner external ({})\n", (0.03, 0.0, 0.04)),
        ("mov corner above 80 external ({})\n", (0.03, 0.0, 0.12)),
        ("mov (corner external ({})) above 80\n", (0.03, 0.0, 0.12)),
        ("mov (10, 20, 60) in fixture external ({})\n", (0.01, 0.02, 0.06)),
        ("loc p = (10, 20, 60) external ({}) in fixture\nmov p\n", (0.01, 0.02, 0.06)),
        ("with frame fixture\n  mov (10, 20, 60) external ({})\nendwith\n", (0.01, 0.02, 0.06)),
    ],
)
def test_values_of_the_axis_tell_where_its_frame_is(
    turn: float, lines: str, place: tuple[float, float, float]
) -> None:
    recording = ran("mov home\n" + lines.format(turn))
    assert_there(recording, in_fixture(*place, np.radians(turn)))
    assert recording.channels["q"].values[-1][6] == pytest.approx(np.radians(turn), abs=1e-12)


def test_here_keeps_frame_and_values() -> None:
    """The pose commanded last stays with the axis: after a turn `here` goes along with its frame."""
    text = "mov corner external (40)\nlin here above 80\nlin here offset (0, 0, -80)\n"
    assert_there(ran(text), in_fixture(0.03, 0.0, 0.04, np.radians(40.0)))


SHIFTED = """task Go(place)
  with frame pallet
    {}
  endwith
endp

mov joints(0, 75, -180, 0, -75, 0, {})
Go corner
"""


@pytest.mark.parametrize("turn", [0.0, 40.0])
@pytest.mark.parametrize(
    ("line", "place"),
    [
        ("mov place offset (10, 20, 30)", (0.04, 0.02, 0.07)),
        ("mov (place.x + 10, place.y, place.z) in fixture", (0.04, 0.0, 0.04)),
        ("mov place in fixture", (0.03, 0.0, 0.04)),
    ],
)
def test_a_parameter_keeps_its_frame_where_another_one_is_in_force(
    turn: float, line: str, place: tuple[float, float, float]
) -> None:
    """The frame `pallet` stands elsewhere and is turned by nothing but the base."""
    recording = ran(SHIFTED.format(line, turn))
    assert_there(recording, in_fixture(*place, np.radians(turn)))


def test_a_parameter_of_the_work_frame_is_seen_in_the_frame_in_force() -> None:
    """The same task with a location that stands still: `offset` goes along the axes of `pallet`."""
    text = SHIFTED.format("mov place offset (10, 20, 30)", 40.0).replace("Go corner", "Go infeed")
    place = cell_of().locations["infeed"] if "infeed" not in cell_of().located else None
    assert place is not None
    X_WK = cell_of().frames["pallet"].X_PK
    way = X_WK.rotation() @ np.array([0.01, 0.02, 0.03])
    reached = tool_pose_at_the_end(ran(text))
    np.testing.assert_allclose(reached.position, place.position + way, rtol=0.0, atol=REACHED)


def test_rel_takes_the_numbers_of_a_location_and_not_its_frame() -> None:
    """What stands still does not begin to turn because a step is written down in a frame that does."""
    still, turned = (
        tool_pose_at_the_end(ran(TURNED.format(turn) + "mov infeed rel corner\n")) for turn in (0.0, 40.0)
    )
    np.testing.assert_allclose(turned.matrix(), still.matrix(), rtol=0.0, atol=REACHED)


@pytest.mark.parametrize("turn", [0.0, 40.0])
def test_the_frame_begins_where_its_axis_starts(turn: float) -> None:
    """For who looks at the cell and, seen from the base, for the compiler."""
    text = CELL[: CELL.index("[[parts]]")]
    cell = cell_of(text.replace("[tools.jaws]", f"start = [0, 75, -180, 0, -75, 0, {turn}]\n[tools.jaws]"))
    expected = in_fixture(0.0, 0.0, 0.0, np.radians(turn), (1.0, 0.0, 0.0, 0.0))
    np.testing.assert_allclose(
        frame_poses(cell)["fixture"].matrix(), expected.matrix(), rtol=0.0, atol=REACHED
    )
    nominal = Pose.from_tuple(environment_of(cell).frames["fixture"])
    np.testing.assert_allclose(
        (cell.first.X_WB @ nominal).matrix(), expected.matrix(), rtol=0.0, atol=REACHED
    )


def test_a_frame_that_moves_is_known_though_the_program_gives_no_pose_of_it() -> None:
    work = standard_chain(cell_of(), cell_of().first).work
    assert work.frame_findings(ModalState(frame="fixture"), Origin()) == ()
    (found,) = work.frame_findings(ModalState(frame="fixtur"), Origin(visit=3))
    assert (found.code, found.hint) == ("M512", "did you mean `fixture`?")
    assert found.label == "reached in pass 3"
    assert "the frames of the cell are `fixture`, `pallet`" in found.message
