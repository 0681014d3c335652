"""The example with two arms and a conveyor: posts stand when they are gripped, and never hang on nothing."""

from functools import cache
from itertools import pairwise
from pathlib import Path

import numpy as np

import ropsim
from ropsim.flow import GripEvent, Recording, ReleaseEvent
from ropsim.kinematics import forward_batch
from ropsim.model import Cell

EXAMPLE = Path(__file__).parents[2] / "examples" / "two_arms"
POSTS = ("post_1", "post_2", "post_3")
HANDS = ("infeed/link1", "left/tool:jaws", "right/tool:fork", "table")
NEAREST = 0.008  # [m], the fork swings past the post that it has put down
APART = 0.06  # [m], between the tool centres while both arms hold a post


@cache
def run_of() -> tuple[Cell, Recording]:
    project = ropsim.open(EXAMPLE)
    assert project.cell is not None
    return project.cell, project.simulate()


def test_there_is_nothing_to_find_fault_with_and_every_post_is_at_its_destination() -> None:
    _, recording = run_of()
    assert recording.ok
    assert [str(found) for found in recording.findings] == []
    assert (recording.facts.destinations.wanted, recording.facts.destinations.reached) == (3, 3)


def test_nothing_meets_anything_on_its_way() -> None:
    _, recording = run_of()
    found = ropsim.open(EXAMPLE).collisions(recording)
    assert [str(one) for one in found.findings] == []
    assert found.facts.clearance is not None
    assert found.facts.clearance.distance > NEAREST


def test_a_post_goes_from_the_belt_to_the_left_arm_to_the_right_one_to_the_table() -> None:
    _, recording = run_of()
    for post in POSTS:
        assert tuple(one.parent for one in recording.placements if one.body == post) == HANDS


def test_the_belt_stands_while_a_post_is_gripped_on_it() -> None:
    _, recording = run_of()
    belt = recording.channels["infeed/q"].values[:, 0]
    for grip in (one for one in recording.events_of(GripEvent) if one.station == "left"):
        during = (recording.time >= grip.time) & (recording.time < grip.end)
        assert during.any()
        assert np.ptp(belt[during]) == 0.0


def test_a_post_is_let_go_only_when_the_other_arm_has_gripped_it() -> None:
    _, recording = run_of()
    taken = [one.end for one in recording.events_of(GripEvent) if one.station == "right"]
    let_go = [one.time for one in recording.events_of(ReleaseEvent) if one.station == "left"]
    assert len(taken) == len(let_go) == 3
    assert all(0.0 <= later - earlier < 0.02 for earlier, later in zip(taken, let_go, strict=True))
    assert all(before < after for before, after in pairwise(taken))


def test_the_tools_keep_apart_while_both_hold_the_post() -> None:
    cell, recording = run_of()
    tips = {}
    for name, station in cell.stations.items():
        X_MT = station.tools[station.default_tool].X_MT.matrix()
        X_BT = forward_batch(station.robot, recording.channels[f"{name}/q"].values) @ X_MT
        tips[name] = (station.X_WB.matrix() @ X_BT)[:, :3, 3]
    assert np.linalg.norm(tips["left"] - tips["right"], axis=1).min() > APART
