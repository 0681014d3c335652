"""Drawings of a workspace: its section, and the task seen from above."""

import numpy as np

from ropsim.kinematics import frames_batch
from ropsim.spatial import Array
from ropsim.views.markup.decimate import along_curve
from ropsim.views.reach.plot import Plane
from ropsim.workspace import ArmStudy, PointCheck, Standing, Study, SweepKind, outline, section_coordinates

POINTS = 1200
TOLERANCE = 0.3
"""By how much of a pixel a drawn line may be off."""
LEVELS = 8
"""Steps in which shares are distinguished."""
_AXES = {
    SweepKind.TURN: ("radius from axis 1 [mm]", "height [mm]"),
    SweepKind.SLIDE: ("across axis 1 [mm]", "across axis 1 [mm]"),
    SweepKind.FLAT: ("in the plane [mm]", "in the plane [mm]"),
}


def section_drawing(arm: ArmStudy, study: Study, ident: str) -> str:
    """Return the section of a workspace with the arm at home, tool directions and points of the task."""
    space = arm.workspace
    if space is None:
        return ""
    lines = outline(space.section)
    home = section_coordinates(space.sweep, _at_home(arm))
    every = np.concatenate((*lines, home)) if lines else home
    plane = Plane.around(every[:, 0], every[:, 1])
    parts = []
    if arm.dexterity is not None and arm.dexterity.directions.count > 1:
        for centre, share in zip(arm.dexterity.centres, arm.dexterity.share, strict=True):
            level = np.ceil(share * LEVELS) / LEVELS
            parts.append(plane.square((centre[0], centre[1]), arm.dexterity.size, "cell", 0.5 * float(level)))
    thin = [
        line[along_curve(line[:, 0], line[:, 1], TOLERANCE / plane.scale, POINTS, _NONE)] for line in lines
    ]
    parts += [plane.area(thin, "reached"), plane.line(home, "arm")]
    best = next((one for one in study.standings if one.candidate.robot == arm.robot), None)
    if best is not None:
        for check in best.checks:
            local = check.point.seen_from(best.candidate.X_WB).position
            u, v = section_coordinates(space.sweep, local[np.newaxis])[0].tolist()
            parts.append(_mark(plane, (u, v), check))
    words = ("section of the workspace", "What the point reaches before the first axis turns or shifts it.")
    return plane.drawing(ident, words, _AXES[space.sweep.kind], parts)


def top_drawing(standings: tuple[Standing, ...], reach: float, ident: str) -> str:
    """Return the task from above: points, the best base and its reach, and how many points other bases reach.

    Args:
        standings: of which the first one is drawn with its reach, and others of its robot as squares.
        reach: of the robot [m].
        ident: unique name inside the page.
    """
    best = standings[0]
    bases = [one for one in standings if one.candidate.robot == best.candidate.robot]
    x, y = (float(value) for value in best.candidate.X_WB.position[:2])
    spots = np.array([one.point.position[:2] for one in best.checks])
    places = np.array([one.candidate.X_WB.position[:2] for one in bases])
    corners = np.array([[x - reach, y - reach], [x + reach, y + reach]])
    every = np.concatenate((spots, places, corners))
    plane = Plane.around(every[:, 0], every[:, 1])
    parts = []
    if len(bases) > 2:
        size = _spacing(places)
        for one, place in zip(bases, places, strict=True):
            share = one.reached / len(one.checks)
            parts.append(plane.square((place[0], place[1]), size, "cell", 0.6 * share))
    parts += [plane.circle((x, y), reach, "around"), plane.circle((x, y), 0.03 * reach, "base")]
    parts += [_mark(plane, (spot[0], spot[1]), check) for spot, check in zip(spots, best.checks, strict=True)]
    words = ("the task from above", "Points of the task, the base and how far the arm reaches at most.")
    return plane.drawing(ident, words, ("x [mm]", "y [mm]"), parts)


_NONE = np.empty(0, dtype=np.intp)


def _mark(plane: Plane, place: tuple[float, float], check: PointCheck) -> str:
    mark = plane.ring if check.reach else plane.cross
    return mark(place, check.point.name)


def _at_home(arm: ArmStudy) -> Array:
    """Return the origins of the joint frames at home and the point itself, in the base frame, (k, 3)."""
    robot, space = arm.robot, arm.workspace
    assert space is not None  # its callers have a workspace
    frames = frames_batch(robot, robot.home[np.newaxis])[0]
    point = space.point.positions(robot, robot.home[np.newaxis])
    return np.concatenate((np.zeros((1, 3)), frames[:-1, :3, 3], point))


def _spacing(places: Array) -> float:
    """Return the usual distance of places of a grid along its sides [m]."""
    steps = np.concatenate([np.diff(np.unique(np.round(places[:, axis], 6))) for axis in (0, 1)])
    return float(np.median(steps)) if len(steps) else 0.1
