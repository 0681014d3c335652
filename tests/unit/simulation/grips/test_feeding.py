"""Supplies on devices: the next part comes when the place of the one before it is free."""

from dataclasses import replace

import numpy as np
import pytest

import ropsim
from ropsim import robots
from ropsim.flow import GripEvent, Placement, Recording
from ropsim.model import (
    WORLD,
    Barrier,
    BeltDrive,
    Box,
    Cell,
    Device,
    FixedObject,
    Gripper,
    IndexDrive,
    Part,
    Shape,
    Signal,
    Sink,
    Station,
    SwitchDrive,
    Tool,
)
from ropsim.model import Cylinder as Disc
from ropsim.simulation import Fidelity, RunOptions, run
from ropsim.spatial import Pose
from ropsim.workbench import environment_of

ARM = robots.load("puma560")
JAWS = Tool("jaws", Pose(np.array([0.0, 0.0, 0.1])), 1.0, gripper=Gripper(0.25, 0.25, 0.02))
DOWN = np.array([0.0, 1.0, 0.0, 0.0])
SPEED, ACCELERATION, LENGTH = 0.25, 1.0, 0.1  # of the belt [m/s, m/s²], of a box along it [m]
TICK = 1e-3  # of the cell's clock [s]


def belt(run: str = "", barrier: Barrier | None = None, length: float = 3.0) -> Device:
    drive = BeltDrive(SPEED, ACCELERATION, run, length, barrier)
    return Device("belt", robots.conveyor(length, 0.2, 0.1), drive, Pose(np.array([-1.0, 0.0, 0.38])))


def boxes(
    count: int, x: float = -0.9, quaternion: tuple[float, ...] = (1.0, 0.0, 0.0, 0.0)
) -> tuple[Part, ...]:
    pose = Pose(np.array([x, 0.0, 0.42]), np.array(quaternion))
    size = np.array([LENGTH, 0.06, 0.04])
    return tuple(Part(f"box_{k + 1}", size, 0.5, pose, "box", k) for k in range(count))


def ran(
    parts: tuple[Part, ...],
    device: Device,
    *lines: str,
    sinks: tuple[Sink, ...] = (),
    objects: tuple[FixedObject, ...] = (),
) -> Recording:
    station = Station("arm", ARM, robots.default_controller(ARM), Pose(), {"jaws": JAWS}, "jaws", program="p")
    signals = {name: Signal(name, is_input=False) for name in ("go", "turn")}
    signals |= {name: Signal(name, is_input=True) for name in ("there", "in_place")}
    places = {"pick": [0.5, 0.0, 0.42], "stock": [0.6, 0.0, 0.42]}
    where = {name: Pose(np.array(place), DOWN) for name, place in places.items()}
    cell = Cell(
        "c",
        {"arm": station},
        parts=parts,
        devices={device.name: device},
        signals=signals,
        locations=where,
        sinks=sinks,
        objects=objects,
    )
    text = "\n".join(["program p", "units mm, deg, s", *lines, ""])
    code = ropsim.language.compile(text, environment_of(cell, station), "p").icr
    assert code is not None
    return run(cell, {"arm": code}, RunOptions(Fidelity.KINEMATIC))


def came(recording: Recording) -> dict[str, float]:
    """Return when each part came [s]."""
    first: dict[str, Placement] = {}
    for one in recording.placements:
        if one.visible and one.parent and one.body.startswith("box"):
            first.setdefault(one.body, one)
    return {name: one.time for name, one in first.items()}


def travelled(time: float) -> float:
    """Return how far a belt has come that starts at 0 [m]."""
    rise = SPEED / ACCELERATION
    return SPEED * (time - rise / 2.0) if time > rise else ACCELERATION * time**2 / 2.0


def test_on_a_running_belt_a_part_comes_as_soon_as_the_one_before_has_left_its_place() -> None:
    recording = ran(boxes(4), belt(), "wait 5 s")
    times = came(recording)
    assert list(times) == ["box_1", "box_2", "box_3", "box_4"]
    for k, time in enumerate(times.values()):
        assert travelled(time) == pytest.approx(k * LENGTH, abs=2 * k * SPEED * TICK + 1e-9)
    assert recording.findings == ()


def test_parts_of_a_supply_never_reach_into_each_other() -> None:
    recording = ran(boxes(4), belt(), "wait 5 s")
    placed = {one.body: one for one in recording.placements if one.parent == "belt/link1"}
    along = sorted(one.X_PB.position[2] for one in placed.values())
    assert np.diff(along).min() >= LENGTH - 1e-6
    assert np.diff(along).max() <= LENGTH + 2 * SPEED * TICK


def test_on_a_belt_that_stands_the_next_part_waits() -> None:
    recording = ran(boxes(2), belt("go"), "wait 2 s", "set go on", "wait 0.3 s", "set go off", "wait 5 s")
    assert list(came(recording)) == ["box_1"]
    recording = ran(boxes(2), belt("go"), "wait 2 s", "set go on", "wait 0.6 s", "set go off", "wait 5 s")
    assert came(recording)["box_2"] == pytest.approx(2.0 + 0.4 + 0.125, abs=5e-3)


def test_a_part_across_the_belt_needs_the_room_of_its_width() -> None:
    across = (np.sqrt(0.5), 0.0, 0.0, np.sqrt(0.5))
    times = came(ran(boxes(2, quaternion=across), belt(), "wait 5 s"))
    assert travelled(times["box_2"]) == pytest.approx(0.06, abs=2 * SPEED * TICK)


def test_parts_of_a_supply_queue_before_a_barrier_and_each_is_fetched() -> None:
    recording = ran(
        boxes(3),
        belt(barrier=Barrier(1.55, "there")),
        "repeat 3",
        "mov pick above 100 mm",
        "wait until there",
        "lin pick",
        "close",
        "lin pick above 100 mm",
        "mov pick offset (0, 300, 100)",
        "open",
        "endr",
    )
    assert [one.part for one in recording.events_of(GripEvent)] == ["box_1", "box_2", "box_3"]
    assert "S721" not in {one.code for one in recording.findings}


def test_a_part_that_leaves_at_the_end_of_its_belt_before_its_place_is_free_makes_room() -> None:
    """The middle of the box is 40 mm before the end of the belt, its length is 100 mm."""
    short = belt(length=1.0)
    recording = ran(boxes(3, x=-0.04), short, "wait 5 s", sinks=(Sink("end", (0.0, 0.0, 0.42), 0.1),))
    assert recording.facts.parts_left == ("box_1", "box_2", "box_3")
    assert recording.findings == ()


def test_a_part_that_another_one_keeps_out_comes_when_that_has_gone() -> None:
    """A box from further up the belt lies in the place when the first one has left it."""
    first, second = boxes(2)
    behind = replace(boxes(1, x=-0.98)[0], name="box_behind", size=np.array([0.05, 0.06, 0.04]), supply="")
    times = came(ran((first, second, behind), belt(), "wait 5 s"))
    assert travelled(times["box_2"]) == pytest.approx(0.98 - 0.9 + 0.05 + 0.025, abs=3 * SPEED * TICK)


def test_a_part_that_a_gripper_takes_makes_room_at_once() -> None:
    recording = ran(boxes(2, x=0.5), belt("go"), "mov pick above 100 mm", "lin pick", "close", "wait 1 s")
    (grip,) = recording.events_of(GripEvent)
    assert grip.part == "box_1"
    assert came(recording)["box_2"] == pytest.approx(grip.end)


def test_over_a_slide_that_is_out_no_part_comes_since_nothing_would_carry_it() -> None:
    plate = (Shape(Box((0.2, 0.2, 0.02)), Pose(np.array([0.0, 0.0, -0.01]))),)
    drive = SwitchDrive("turn", 0.0, 0.5, 0.5, 2.0, "", "in_place")
    slide = Device("slide", robots.slide(plate), drive, Pose(np.array([-0.9, 0.0, 0.38])))
    recording = ran(boxes(2), slide, "set turn on", "wait until in_place", "wait 1 s")
    assert recording.channels["slide/q"].values[-1] == pytest.approx(0.5)
    assert [(one.body, one.parent) for one in recording.placements if one.body == "box_1"] == [
        ("box_1", "slide/link1")
    ]
    assert list(came(recording)) == ["box_1"]


def test_a_table_that_turns_its_part_away_is_given_the_next_one_when_it_stands() -> None:
    plate = (Shape(Disc(0.5, 0.02), Pose(np.array([0.0, 0.0, -0.01]))),)
    drive = IndexDrive("turn", np.pi / 2, 1.0, 4.0, "in_place")
    table = Device("table", robots.rotary(plate), drive, Pose(np.array([-1.2, 0.0, 0.38])))
    recording = ran(boxes(2), table, "wait 1 s", "set turn on", "wait 3 s")
    assert came(recording)["box_2"] == pytest.approx(1.0 + np.pi / 2 + 0.25, abs=2e-3)


def table_slide(way: float, speed: float = 0.5) -> Device:
    """Return a long plate that a signal takes `way` along x [m], under the place of the boxes."""
    plate = (Shape(Box((2.4, 0.4, 0.02)), Pose(np.array([0.0, 0.0, -0.01]))),)
    drive = SwitchDrive("turn", 0.0, way, speed, 2.0, "", "in_place")
    return Device("slide", robots.slide(plate), drive, Pose(np.array([-0.9, 0.0, 0.38])))


PUSHED = ("set turn on", "wait until in_place", "wait 0.2 s")


@pytest.mark.parametrize(("way", "names"), [(0.095, 1), (0.0999, 1), (0.1, 2), (0.105, 2)])
def test_boxes_may_touch_and_no_more(way: float, names: int) -> None:
    """The box is 100 mm long; the plate stands when the place is looked at."""
    assert len(came(ran(boxes(2), table_slide(way), *PUSHED))) == names


@pytest.mark.parametrize(
    ("turn", "size", "other_turn", "gap"),
    [
        (0.0, (0.4, 0.02, 0.1), -45.0, (0.05 + 0.03) / np.sqrt(2.0) + 0.01),
        (45.0, (0.06, 0.06, 0.1), 0.0, 0.05 + 0.03 * np.sqrt(2.0)),
    ],
    ids=["by a face of the neighbour", "by a face of its own"],
)
@pytest.mark.parametrize(("apart", "names"), [(0.01, 2), (-0.01, 1)])
def test_a_face_of_either_part_is_enough_to_keep_them_apart(
    turn: float, size: tuple[float, ...], other_turn: float, gap: float, apart: float, names: int
) -> None:
    """A pillar in the diagonal of the place; along the axes of the other part they overlap."""

    def about_z(degrees: float) -> tuple[float, ...]:
        half = np.radians(degrees) / 2.0
        return (float(np.cos(half)), 0.0, 0.0, float(np.sin(half)))

    aside = (gap + apart) / np.sqrt(2.0)
    pose = Pose(np.array([-0.9 + aside, aside, 0.45]), np.array(about_z(other_turn)))
    neighbour = Part("neighbour", np.array(size), 0.1, pose)
    recording = ran((*boxes(2, quaternion=about_z(turn)), neighbour), table_slide(0.5), *PUSHED)
    assert [one.parent for one in recording.placements if one.body == "neighbour"] == [WORLD]
    assert len(came(recording)) == names


def test_while_a_table_turns_it_is_given_nothing_whatever_else_happens() -> None:
    """The device looks at its signal in the middle of its way; the place is free by then."""
    plate = (Shape(Disc(0.5, 0.02), Pose(np.array([0.0, 0.0, -0.01]))),)
    drive = IndexDrive("turn", np.pi / 2, 1.0, 4.0, "in_place")
    table = Device("table", robots.rotary(plate), drive, Pose(np.array([-1.2, 0.0, 0.38])))
    recording = ran(boxes(2), table, "wait 1 s", "set turn on", "wait 1.2 s", "set turn off", "wait 3 s")
    assert came(recording)["box_2"] == pytest.approx(1.0 + np.pi / 2 + 0.25, abs=2e-3)


def test_a_part_that_stands_where_it_came_keeps_the_next_one_waiting_also_elsewhere() -> None:
    """The second box would come at another place of the stand, which is free."""
    first, second = boxes(2, x=0.6)
    second = replace(second, X_WO=Pose(np.array([0.6, 0.3, 0.42])))
    stand = FixedObject("stand", Pose(np.array([0.6, 0.15, 0.37])), (Shape(Box((0.3, 0.6, 0.02))),))
    recording = ran((first, second), table_slide(0.3), *PUSHED, objects=(stand,))
    assert recording.channels["slide/q"].values[-1] == pytest.approx(0.3)
    assert list(came(recording)) == ["box_1"]
    lines = ("mov stock above 100 mm", "lin stock", "close", *PUSHED)
    assert list(came(ran((first, second), table_slide(0.3), *lines, objects=(stand,)))) == ["box_1", "box_2"]
