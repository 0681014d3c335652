"""The reachable workspace of a point: its volume with an error, its section, and its extremes."""

from functools import lru_cache
from math import sqrt

import numpy as np

from ropsim.core import Diagnostic
from ropsim.model import RobotModel
from ropsim.spatial import Array, record
from ropsim.workspace.diagnostics import assumed_turns
from ropsim.workspace.point import MovedPoint
from ropsim.workspace.ranges import AxisRanges, axis_ranges, even_rows
from ropsim.workspace.volume.extremes import Extreme, extremes
from ropsim.workspace.volume.raster import Section, rastered
from ropsim.workspace.volume.sheets import divided, halved
from ropsim.workspace.volume.sweep import Sweep, SweepKind, sweep_of


@record
class Resolution:
    """How finely a workspace is computed.

    Attributes:
        across: spacings of the lattice along the longer side of the section.
        quadrangles: of all sheets, at most.
    """

    across: int
    quadrangles: int = 300_000


SAMPLES = 256
"""Configurations in which the motion of the point by each axis is measured."""
ONE_SHEET = Resolution(500)
"""If two axes in addition to the first one move the point: 0.1 % in half a second."""
MANY_SHEETS = Resolution(240)
"""Where more of them do: about 1 % in seconds."""


@record
class Reachable:
    """The reachable workspace of a point of an arm.

    Attributes:
        point: of the arm.
        sweep: effect of the first axis, and the frame of the section.
        ranges: of the axes.
        volume: [m³]; an area [m²] where the point moves in a plane.
        error: error bound, estimated by computing with half of the steps.
        section: on a lattice.
        extremes: least and greatest first coordinate of the section, then of the second one.
        findings: such as ranges that were assumed.
    """

    point: MovedPoint
    sweep: Sweep
    ranges: AxisRanges
    volume: float
    error: float
    section: Section
    extremes: tuple[Extreme, ...]
    findings: tuple[Diagnostic, ...] = ()


@lru_cache(maxsize=32)
def reachable(robot: RobotModel, point: MovedPoint, resolution: Resolution | None = None) -> Reachable:
    """Return the workspace that a point reaches within the limits of the joints.

    The first axis sweeps a section, so that only this is computed: sheets of triangles over two axes, one for
    each combination of the others, are laid on a lattice, of which each point stores the range of the sweep
    that reaches it. The volume is the sum over the lattice; the border lies inside by less than the sag of
    the sheets, and everything is done again with half of the steps: the error is the difference of the two,
    and the open area of the lattice along the border.

    Args:
        robot: the arm.
        point: of it, as `moved_point` returns it.
        resolution: how finely; None for `ONE_SHEET` or `MANY_SHEETS`, as the arm is.

    Raises:
        WorkspaceError: W102, a slide has no limits; W103, the first axis does not carry the arm.
        MechanismError: the arm cannot be.
    """
    ranges = axis_ranges(robot)
    sweep = sweep_of(robot, point, ranges)
    ends = extremes(robot, point, sweep, ranges)
    box = np.array([[ends[0].value, ends[2].value], [ends[1].value, ends[3].value]])
    Q = np.array([one.q for one in ends])
    Q = np.concatenate((Q, even_rows(ranges, SAMPLES)))
    most = (resolution or MANY_SHEETS).quadrangles
    division = divided(robot, point, sweep, ranges, Q, most)
    finely = resolution or (MANY_SHEETS if division.inner or division.outer else ONE_SHEET)
    spacing = max(float((box[1] - box[0]).max()), 1e-9) / finely.across
    fine = rastered(robot, point, sweep, ranges, division, box, spacing)
    coarse = rastered(robot, point, sweep, ranges, halved(division), box, 2.0 * spacing)
    volume, rough = _volume(fine, sweep), _volume(coarse, sweep)
    error = abs(volume - rough) + _left_open(fine, sweep)
    found = (assumed_turns(robot.name, ranges.assumed),) if ranges.assumed else ()
    return Reachable(point, sweep, ranges, volume, error, fine, ends, found)


def _volume(section: Section, sweep: Sweep) -> float:
    return float((_weights(section, sweep) * section.share).sum())


def _weights(section: Section, sweep: Sweep) -> Array:
    """Return the weight of each lattice point, [m³] per unit of its share."""
    area = section.spacing**2
    if sweep.kind is SweepKind.TURN:
        return np.asarray(area * np.maximum(section.places()[:, :, 0], 0.0))
    return np.full(section.share.shape, area)


def _left_open(section: Section, sweep: Sweep) -> float:
    """Return the open area of the lattice along the border: points next to others that differ from them.

    Each of them stands for an area of which a part is beyond the border, evenly from none to all, so that k
    of them are off by √(k/12) areas; the threefold of that is taken.
    """
    share = section.share * _weights(section, sweep)
    jumps = [np.abs(np.diff(share, axis=axis)).ravel() for axis in (0, 1)]
    return 3.0 * sqrt(float(sum((one**2).sum() for one in jumps)) / 24.0)
