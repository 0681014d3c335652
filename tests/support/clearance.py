"""How near arm, gripper and carried part come to everything else in a run, until ropsim looks itself."""

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from ropsim.flow import Placement, Recording
from ropsim.kinematics import body_poses
from ropsim.model import BodyKind, Cell, Part, body_tree, grip_width, tool_body, tool_shapes
from ropsim.spatial import Array, Pose
from support.arm_capsules import PUMA_CAPSULES, Block, base_blocks, block_around, fixed_blocks
from support.separation import FAR, Mask, Track, least_gap

PERIOD = 0.02
"""Of the samples [s]; the TCP goes 40 mm at most between two of them."""
ABOVE = 0.012
"""Gripper and part stand straight above a place when the grasp point is so near to its axis [m]."""


@dataclass(frozen=True, slots=True)
class Clearances:
    """What must be kept [m].

    Attributes:
        links: between links 1 to 6 and all objects and parts, between links 3 to 6 and the robot's base.
        gripper: between gripper and all objects and parts but the one straight under it.
        part: between a carried part and all other parts; and objects, unless it stands straight above the
            place that it is taken from or set down at.
    """

    links: float = 0.03
    gripper: float = 0.006
    part: float = 0.01


@dataclass(frozen=True, slots=True, order=True)
class Nearness:
    """The nearest that two bodies come [m], and when [s]."""

    gap: float
    one: str
    other: str
    time: float


def too_near(cell: Cell, recording: Recording, keep: Clearances | None = None) -> list[Nearness]:
    """Return the pairs that come nearer than they may in a run, nearest first."""
    asked = keep or Clearances()
    return [found for found, least in nearest(cell, recording, asked) if found.gap < least]


def nearest(cell: Cell, recording: Recording, keep: Clearances) -> list[tuple[Nearness, float]]:
    """Return how near each pair comes that comes nearer than `FAR`, and how near it may, nearest first."""
    rows = np.unique(np.searchsorted(recording.time, np.arange(0.0, recording.duration, PERIOD)))
    rows = np.append(rows[rows < len(recording.time) - 1], len(recording.time) - 1)
    time = recording.time[rows]
    tree = body_tree(cell)
    arm = (*tree.names(BodyKind.LINK), tool_body(cell.first.default_tool))
    poses = body_poses(tree, {"robot": recording.channels["q"].values[rows]}, arm)
    frames = np.stack([poses[name] for name in arm], axis=1)
    fixed, base = fixed_blocks(cell), base_blocks(cell)
    resting, carried = _parts(cell, recording, time, frames)
    tcp = frames[:, -1] @ cell.first.tools[cell.first.default_tool].X_MT.matrix()
    found: list[tuple[Nearness, float]] = []

    def look(track: Track, block: Block, when: Mask, least: float) -> None:
        gap, row = least_gap(track, block, when & track.active)
        if gap < FAR:
            found.append((Nearness(gap, track.name, block.name, float(time[row])), least))

    always = np.ones(len(time), dtype=bool)
    for link, track in arm_tracks(frames):
        for block in [*fixed, *(base if link > 2 else [])]:
            look(track, block, always, keep.links)
        for block, lies in resting:
            look(track, block, lies, keep.links)
    for track in _gripper(cell, frames):
        for block in [*fixed, *base]:
            look(track, block, always, keep.gripper)
        for block, lies in resting:
            look(track, block, lies & ~_straight_above(tcp, block), keep.gripper)
    for track, ends in carried:
        grasp = track.poses
        above = np.logical_or.reduce([_straight_above(grasp, end) for end in ends])
        for block in [*fixed, *base]:
            look(track, block, ~above, keep.part)
        for block, lies in resting:
            follows = np.allclose(
                block.centre.position, ends[0].centre.position
            )  # the next one of its supply
            look(track, block, lies & ~above if follows else lies, keep.part)
    return sorted(found, key=lambda pair: pair[0])


def arm_tracks(frames: Array) -> Iterator[tuple[int, Track]]:
    """Yield number and capsules of the links of a PUMA 560 that have the poses (k, 6, 4, 4)."""
    always = np.ones(len(frames), dtype=bool)
    for number, capsules in enumerate(PUMA_CAPSULES, start=1):
        for one in capsules:
            start, end = np.array(one.start), np.array(one.end)
            length = float(np.linalg.norm(end - start))
            along = (end - start) / length
            side = np.cross(along, np.eye(3)[int(np.argmin(np.abs(along)))])
            side /= np.linalg.norm(side)
            X = np.eye(4)
            X[:3, :3] = np.column_stack((side, np.cross(along, side), along))
            X[:3, 3] = (start + end) / 2.0
            half = np.array([0.0, 0.0, length / 2.0])
            yield number, Track(f"link {number}", frames[:, number - 1] @ X, half, one.radius, always)


def _gripper(cell: Cell, frames: Array) -> Iterator[Track]:
    always = np.ones(len(frames), dtype=bool)
    for shape in tool_shapes(cell.first.tools[cell.first.default_tool], grip_width(cell)):
        block = block_around("gripper", shape.pose, shape)
        yield Track("gripper", frames[:, -1] @ block.centre.matrix(), block.half, 0.0, always)


def _parts(
    cell: Cell, recording: Recording, time: Array, frames: Array
) -> tuple[list[tuple[Block, Mask]], list[tuple[Track, list[Block]]]]:
    """Return where parts lie and when; how they are carried, with the places where that begins and ends."""
    parts = {part.name: part for part in cell.parts}
    journeys: dict[str, list[Placement]] = {name: [] for name in parts}
    for one in recording.placements:
        if one.body in parts:
            journeys[one.body].append(one)
    hand = tool_body(cell.first.default_tool)
    resting, carried = [], []
    for name, journey in journeys.items():
        places: list[Block] = []
        ways: list[Track] = []
        until = [*(one.time for one in journey[1:]), np.inf]
        for one, end in zip(journey, until, strict=True):
            when = (time >= one.time) & (time < end)
            if one.parent == hand:
                ways.append(_carried(parts[name], frames[:, -1], one.X_PB, when))
                continue
            places.append(_block(parts[name], _in_world(cell, one)))
            if one.visible:
                resting.append((places[-1], when))
        carried += [(way, places) for way in ways]
    return resting, carried


def _in_world(cell: Cell, one: Placement) -> Pose:
    """Return the pose of a part that lies on nothing that moves, in the world."""
    found = body_poses(body_tree(cell), {}, [one.body], {one.body: (one.parent, one.X_PB)})
    return Pose.from_matrix(found[one.body][0])


def _carried(part: Part, interface: Array, X_MO: Pose, when: Mask) -> Track:
    block = _block(part, X_MO)
    return Track(part.name, interface @ block.centre.matrix(), block.half, 0.0, when)


def _block(part: Part, X: Pose) -> Block:
    half = np.array(part.size) / 2.0
    return Block(part.name, X @ Pose(np.array([0.0, 0.0, -half[2]])), half)


def _straight_above(poses: Array, block: Block) -> Mask:
    """Return for poses (k, 4, 4) whether their origin lies near the axis of a part."""
    offset = (poses[:, :3, 3] - block.centre.position) @ block.centre.rotation()
    return np.asarray(np.hypot(offset[:, 0], offset[:, 1]) < ABOVE)
