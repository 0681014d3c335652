"""The arm of a robot with external axes: inverse kinematics solves it with external axes at rest."""

from collections.abc import Iterator
from dataclasses import replace
from functools import lru_cache

import numpy as np

from ropsim.model.findings import mechanism_diagnostics as kinds
from ropsim.model.mechanism.coordinates import coordinates
from ropsim.model.mechanism.links import BASE_LINK, Coupling, LoopCut
from ropsim.model.mechanism.loop_check import loop_coordinates
from ropsim.model.mechanism.mechanism import first_coordinates
from ropsim.model.mechanism.mechanism_check import MechanismError, check_mechanism
from ropsim.model.robots.robot import RobotModel
from ropsim.spatial import Array, frozen, record


@record
class HeldArm:
    """The arm of a robot with external axes.

    Attributes:
        arm: the arm alone; its base frame is the frame of `carrier`.
        carrier: link of the robot on which it hangs, `BASE_LINK` where its base stands still.
        axes: number of each axis of the arm among the axes of the robot.
    """

    arm: RobotModel
    carrier: int
    axes: tuple[int, ...]


@lru_cache(maxsize=64)
def held_arm(robot: RobotModel) -> HeldArm:
    """Return the arm of a robot whose external axes stand still.

    It is the part behind the last link, on the chain to the interface, that external axes move.

    Raises:
        MechanismError: the robot is impossible or has no arm, or a coupling mixes external axes with axes of
            the arm.
    """
    check_mechanism(robot)
    if not robot.has_arm:
        raise MechanismError(
            kinds.BAD_EXTERNAL.at(
                None,
                f"`{robot.name}` has external axes only, and no arm for inverse kinematics",
                hint="leave an axis to the arm, or move the robot by its joint coordinates",
                data={"found": robot.external, "allowed": robot.n},
            )
        )
    external = set(external_links(robot))
    way, link = [], robot.tip
    while link != BASE_LINK:
        way.append(link)
        link = robot.joints[link].parent
    carrier = next((link for link in way if link in external), BASE_LINK)
    kept = [
        number
        for number in range(len(robot.joints))
        if number not in external and (carrier == BASE_LINK or carrier in _above(robot, number))
    ]
    places = {number: place for place, number in enumerate(kept)} | {carrier: BASE_LINK}
    joints = tuple(
        replace(robot.joints[number], parent=places.get(robot.joints[number].parent, BASE_LINK))
        for number in kept
    )
    axes = tuple(k for k in range(robot.n) if k not in robot.external and robot.axes[k] in places)
    drives = robot.drives
    arm = replace(
        robot,
        joints=joints,
        links=tuple(robot.links[number] for number in kept) if robot.links else (),
        drives=tuple(drives[k] for k in axes) if drives else (),
        home=frozen([robot.home[k] for k in axes]),
        axes=tuple(places[robot.axes[k]] for k in axes),
        couplings=tuple(_couplings(robot, kept)),
        cuts=tuple(_cuts(robot, places)),
        springs=(),
        joint_springs=(),
        tip=places[robot.tip],
        external=(),
    )
    return HeldArm(arm, carrier, axes)


@lru_cache(maxsize=64)
def carrying_links(robot: RobotModel) -> frozenset[int]:
    """Return the numbers of the links that carry the arm of a robot: its carrier and all below.

    Raises:
        MechanismError: a coupling mixes external axes with axes of the arm.
    """
    link, found = held_arm(robot).carrier, set()
    while link != BASE_LINK:
        found.add(link)
        link = robot.joints[link].parent
    return frozenset(found)


def external_links(robot: RobotModel) -> tuple[int, ...]:
    """Return the numbers of the links that external axes alone move, and of links fixed to them.

    Raises:
        MechanismError: a coupling mixes external axes with axes of the arm.
    """
    first, n = first_coordinates(robot.joints), robot.n
    T = _moving(robot)
    inner = [k for k in range(n) if k not in robot.external]
    found: list[int] = []
    for number, joint in enumerate(robot.joints):
        rows = T[first[number] : first[number + 1]]
        moved, by_arm = bool(rows.any()), bool(rows[:, inner].any())
        if moved and by_arm and rows[:, list(robot.external)].any():
            raise MechanismError(
                kinds.MIXED_AXES.at(
                    None,
                    f"joint `{joint.name}` of `{robot.name}` follows external axes and axes of the arm",
                    hint="make the axes that it follows all external, or none of them",
                )
            )
        if (moved and not by_arm) or (not moved and joint.parent in found):
            found.append(number)
    return tuple(found)


def _moving(robot: RobotModel) -> Array:
    """Return which axes move the coordinates of all joints, by couplings or closed chains, shape (N, n)."""
    made = coordinates(robot)
    T, P = made.T != 0.0, made.P != 0.0
    by = np.zeros((P.shape[1], robot.n), dtype=bool)  # which axes move each passive coordinate
    loops = [list(loop_coordinates(robot, cut)) for cut in robot.cuts]
    for _ in loops:  # chains that share passive coordinates share axes
        for loop in loops:
            passive = P[loop].any(axis=0)
            by[passive] |= T[loop].any(axis=0) | by[passive].any(axis=0)
    return np.asarray(T | (P[:, :, np.newaxis] & by).any(axis=1), dtype=np.float64)


def _cuts(robot: RobotModel, places: dict[int, int]) -> Iterator[LoopCut]:
    """Yield the closed chains of the arm, with its links counted anew."""
    for cut in robot.cuts:
        first, second = places.get(cut.first), places.get(cut.second)
        if first is not None and second is not None and first != second:
            yield replace(cut, first=first, second=second)


def _above(robot: RobotModel, number: int) -> set[int]:
    found = set()
    link = robot.joints[number].parent
    while link != BASE_LINK:
        found.add(link)
        link = robot.joints[link].parent
    return found


def _couplings(robot: RobotModel, kept: list[int]) -> list[Coupling]:
    """Return the couplings of the joints that are kept, with their coordinates counted anew."""
    first = first_coordinates(robot.joints)
    old = [number for joint in kept for number in range(first[joint], first[joint + 1])]
    new = {number: place for place, number in enumerate(old)}
    return [
        Coupling(new[one.dependent], tuple((new[k], factor) for k, factor in one.terms), one.constant)
        for one in robot.couplings
        if one.dependent in new
    ]


def axes_words(robot: RobotModel) -> str:
    """Return how many axes a robot has, and which: "8: 6 of the arm, then E1 (track), E2 (positioner)".

    The axes of a robot without external axes are not listed.

    Raises:
        MechanismError: a coupling of the robot mixes external axes with axes of its arm.
    """
    if not robot.external or not robot.has_arm:
        return f"{robot.n}"
    return f"{robot.n}: {robot.n - len(robot.external)} of the arm, then {external_words(robot)}"


def external_words(robot: RobotModel) -> str:
    """Return the external axes of a robot with an arm by their names: "E1 (track), E2 (positioner)".

    Raises:
        MechanismError: a coupling of the robot mixes external axes with axes of its arm.
    """
    carrying, named = carrying_links(robot), []
    for k in robot.external:
        word = "track" if robot.axes[k] in carrying else "positioner"
        named.append(f"{robot.axis_joints[k].name} ({word})")
    return ", ".join(named)
