"""Placements: the recording tells where every part was, as the running state had it."""

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field, replace

import numpy as np
import pytest

import ropsim
from ropsim.flow import Placement, Recording
from ropsim.kinematics import NO_BLOCKS, body_poses
from ropsim.model import BodyKind, Cell, FixedObject, Gripper, Part, Sink, Tool, body_tree
from ropsim.robots import default_controller, load
from ropsim.simulation import Fidelity, RunOptions, RunView, run
from ropsim.simulation.testing import (
    CellRun,
    Moment,
    Placements,
    Seat,
    changes,
    close_on,
    initial_parts,
    payload,
    release,
)
from ropsim.spatial import Pose
from ropsim.workbench import environment_of
from support.cells import one_station

JAWS = Tool("jaws", Pose(np.array([0.0, 0.0, 0.12])), 1.0, gripper=Gripper(0.2, 0.2, 0.005))
ARM = load("puma560")
DOWN = np.array([0.0, 1.0, 0.0, 0.0])
ROUNDING = 1e-12
"""Of poses that are composed a few times, with coordinates below two metres."""


HAND = "tool:jaws"


def part(name: str, x: float, y: float, supply: str = "", turn: int = 0) -> Part:
    return Part(name, np.full(3, 0.05), 0.25, Pose(np.array([x, y, 0.3])), supply, turn)


CELL = one_station(
    "c",
    ARM,
    default_controller("puma560"),
    X_WB=Pose(np.array([0.1, -0.05, 0.02]), np.array([0.995, 0.0, 0.0, 0.1])),
    tools={"jaws": JAWS},
    default_tool="jaws",
    parts=(part("a", 0.5, 0.1, "s", 0), part("b", 0.5, 0.1, "s", 1), part("c", 0.5, -0.1)),
    objects=(FixedObject("shelf", Pose(np.array([0.5, 0.0, 0.25])), ()),),
    sinks=(Sink("bin", (0.5, 0.3, 0.3), 0.02),),
    locations={
        "near": Pose(np.array([0.5, 0.1, 0.3]), DOWN),
        "far": Pose(np.array([0.5, -0.1, 0.3]), DOWN),
        "out": Pose(np.array([0.5, 0.3, 0.3]), DOWN),
    },
    start=ARM.home,
)
LINES = ("mov near", "close", "mov out", "open", "mov far", "close", "mov near above 100 mm", "wait 1 s")


STACKS = {"a1": "a", "b": "", "a": "", "a2": "a", "a1x": "a1", "b1": "b"}
"""On what each part hangs."""


@pytest.mark.parametrize(
    ("asked", "family"),
    [
        (("a",), ("a", "a1", "a2", "a1x")),
        (("a1x",), ("a1x",)),
        (("b", "a1", "a", "b1"), ("b", "b1", "a1", "a1x", "a", "a2")),
        ((), ()),
    ],
)
def test_what_hangs_on_parts_comes_behind_them_and_once(
    asked: tuple[str, ...], family: tuple[str, ...]
) -> None:
    placements = Placements({name: Seat(parent, "", Pose()) for name, parent in STACKS.items()})
    assert placements.family(*asked) == family


@dataclass
class Looker:
    """Notes where all parts are, in the world, whenever something has been done."""

    seen: dict[float, dict[str, Pose]] = field(default_factory=dict)

    def advanced(self, run: RunView) -> None:
        assert isinstance(run, CellRun)
        poses = run.moment(run.tick).poses(run.parts)
        self.seen[run.time] = poses  # the last look at a time is that after the gripper has acted

    @property
    def may_press(self) -> bool:
        return False

    def reading(self, run: RunView) -> None:
        pass

    def ended(self, run: RunView) -> None:
        pass


def ran(cell: Cell, watch: Looker | None = None, lines: Iterable[str] = LINES) -> Recording:
    text = "\n".join(("program p", "units mm, deg, s", *lines))
    compiled = ropsim.language.compile(text, environment_of(cell))
    assert compiled.icr is not None
    return run(cell, {"robot": compiled.icr}, RunOptions(Fidelity.KINEMATIC, 1000, watch=watch or Looker()))


def hanging(recording: Recording, time: float) -> Mapping[str, Placement]:
    """Return the placement of each body in force at a time."""
    return {one.body: one for one in recording.placements if one.time <= time + 1e-9}


def in_world(cell: Cell, recording: Recording, time: float) -> dict[str, np.ndarray]:
    """Return the poses X_WB of all parts that are there, from the recording alone."""
    q = [np.interp(time, recording.time, column) for column in recording.channels["q"].values.T]
    now = {name: one for name, one in hanging(recording, time).items() if one.visible}
    tree = body_tree(cell)
    parts = [name for name in tree.names(BodyKind.PART) if name in now]
    elsewhere = {name: (now[name].parent, now[name].X_PB) for name in parts}
    poses = body_poses(tree, {"robot": np.array([q])}, parts, elsewhere)
    return {name: matrices[0] for name, matrices in poses.items()}


def test_the_recording_has_every_part_where_the_run_had_it() -> None:
    watch = Looker()
    recording = ran(CELL, watch)
    assert {one.body for one in recording.placements if one.time > 0.0} == {"a", "b", "c"}
    for time, poses in watch.seen.items():
        told = in_world(CELL, recording, time)
        assert set(told) == set(poses)
        for name, pose in poses.items():
            np.testing.assert_allclose(told[name], pose.matrix(), atol=ROUNDING)


def test_every_body_has_a_placement_at_the_start_in_the_order_of_the_tree() -> None:
    recording, bodies = ran(CELL), body_tree(CELL).bodies
    first = recording.placements[: len(bodies)]
    assert {one.time for one in first} == {0.0}
    assert [(one.body, one.parent, one.visible) for one in first] == [
        (body.name, body.parent, body.visible) for body in bodies
    ]


def test_a_part_hangs_on_the_tool_then_on_something_else_or_is_gone() -> None:
    recording = ran(CELL)
    acts = [one for one in recording.events if one.kind in {"grip", "release"}]
    times = [one.time + one.duration for one in acts]
    moved = [one for one in recording.placements if one.time > 0.0]
    assert [one.time for one in moved] == pytest.approx([times[0], times[0], times[1], times[2]])
    assert [(one.body, one.parent, one.visible) for one in moved] == [
        ("a", "tool:jaws", True),
        ("b", "", True),
        ("a", "", False),
        ("c", "tool:jaws", True),
    ]


def test_an_object_elsewhere_in_the_cell_changes_no_placement_of_a_part() -> None:
    far = FixedObject("far", Pose(np.array([3.0, 3.0, 0.0])), ())
    one, other = ran(CELL), ran(replace(CELL, objects=(far, *CELL.objects)))
    for recording in (one, other):
        assert any(placement.body == "a" for placement in recording.placements)
    assert [placement for placement in other.placements if placement.body != "far"] == list(one.placements)


def held_with_load() -> tuple[Placements, Placements, Moment]:
    """Return parts before and after the gripper has taken `a`, on which `c` lies, and that moment."""
    state = initial_parts(CELL)
    state = state.with_seats({"c": replace(state.seats["c"], parent="a")})
    X_WM = Pose(np.array([0.5001, 0.1, 0.4202]), np.array([0.005, 1.0, 0.03, 0.004]))
    moment = Moment({HAND: X_WM}, NO_BLOCKS)
    return state, close_on(state, CELL, JAWS, HAND, moment), moment


def test_taking_and_leaving_move_no_part() -> None:
    before, held, moment = held_with_load()
    after = release(held, CELL, {HAND}, moment)
    assert held.held({HAND}) == "a"
    for name in ("a", "c"):
        pose = before.seats[name].pose.matrix()
        np.testing.assert_allclose(moment.pose(held.seats[name]).matrix(), pose, atol=ROUNDING)
        np.testing.assert_allclose(after.seats[name].pose.matrix(), pose, atol=ROUNDING)


def test_what_lies_on_a_part_comes_along_and_weighs() -> None:
    before, held, moment = held_with_load()
    parts = {one.name: one for one in CELL.parts}
    assert set(held.carried({HAND})) == {"a", "c"}
    assert (held.seats["a"].parent, held.seats["c"].parent) == ("tool:jaws", "a")
    assert payload(held.carried({HAND}), parts, JAWS).mass == pytest.approx(1.5)
    told = [one.body for one in changes(1.0, before, held, {})]
    assert told == ["a", "b"]  # `c` hangs on `a` as before, `b` is the next one of the supply
    gone = release(held, replace(CELL, sinks=(Sink("here", (0.5, 0.1, 0.3), 0.1),)), {HAND}, moment)
    assert set(gone.left) == {"a", "c"}
    assert [(one.body, one.visible) for one in changes(2.0, held, gone, {})] == [("a", False), ("c", False)]
