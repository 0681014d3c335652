"""Closed chains of a robot as instances: the pair where each is cut, and the loop that it closes."""

from ropsim.model import ALL_DIRECTIONS, BASE_LINK, RobotModel
from ropsim.nirox.building import DERIVED, UNSET, Building
from ropsim.nirox.pair_words import pair_of
from ropsim.nirox.writers.places import write_placement
from ropsim.part21 import FALSE, TRUE, Reference, Value


def write_cut(building: Building, robot: RobotModel, number: int) -> tuple[Reference, Reference]:
    """Make joint, pair and loop of a closed chain; links and joints of the tree have been made.

    Args:
        building: takes the instances.
        robot: to be written.
        number: of the cut, from 0.

    Returns:
        The placements of the pair on its first and on its second link.
    """
    cut, name = robot.cuts[number], f"cut {number + 1}"
    ends = building.at(("link", cut.first)), building.at(("link", cut.second))
    joint = building.add(("cut joint", number), "KINEMATIC_JOINT", name, *ends)
    first = write_placement(building, ("cut place", number), cut.X_first)
    second = write_placement(building, ("cut body", number), cut.X_second)
    keyword = pair_of(cut.held)
    free: list[Value] = [DERIVED] * 6
    if keyword == "low_order_kinematic_pair":
        free = [FALSE if one in cut.held else TRUE for one in ALL_DIRECTIONS]
    if keyword == "universal_pair":
        free.append(UNSET)
    values = (name, DERIVED, UNSET, first, second, joint, *free)
    building.add(("cut pair", number), keyword.upper(), *values)
    edges = [_edge(building, number, -1, joint, TRUE)]
    for moved, direction in _path(robot, cut.second, cut.first):
        edges.append(_edge(building, number, moved, building.at(("joint", moved)), direction))
    building.add(("loop", number), "KINEMATIC_LOOP", name, tuple(edges))
    return first, second


def _edge(building: Building, number: int, moved: int, joint: Reference, direction: Value) -> Reference:
    """Return a joint of a loop, passed from its start to its end where the direction is TRUE."""
    key = ("loop edge", number, moved)
    return building.add(key, "ORIENTED_JOINT", "", DERIVED, DERIVED, joint, direction)


def _path(robot: RobotModel, start: int, end: int) -> list[tuple[int, Value]]:
    """Return the joints on the way from one link to another, and whether they are passed as they lead."""
    up, down = _to_base(robot, start), _to_base(robot, end)
    common = set(up) & set(down)
    rise: list[tuple[int, Value]] = [(one, FALSE) for one in up if one not in common]
    return rise + [(one, TRUE) for one in reversed(down) if one not in common]


def _to_base(robot: RobotModel, link: int) -> list[int]:
    found = []
    while link != BASE_LINK:
        found.append(link)
        link = robot.joints[link].parent
    return found
