"""Delta arms and their like: a plate on rods with ball joints, led by driven bars or slides on the base.

The class: the interface is on a plate; each axis moves a bar on the base, from which at least one rod leads
to the plate, with a ball joint or a universal joint at both ends. A pose of the plate says where the far end
of each rod is, so each axis has an equation of its own: the distance from there to the near end is the length
of the rod, A·cos θ + B·sin θ = C for a bar that turns (R. Clavel, Conception d'un robot parallèle rapide à 4
degrés de liberté, thesis 925, EPFL 1991), a square root for a slide. So there are two values for each axis,
and 2^n answers at most. Whatever else is in the chains is checked by following them from the rest position,
with a bounded effort: where the tool is not at the pose then, in another assembly, there is no answer.
"""

from itertools import product
from typing import ClassVar, NamedTuple

import numpy as np

from ropsim.kinematics.chain.closed_arrays import ClosedArrays, closed_arrays
from ropsim.kinematics.chain.forward import forward
from ropsim.kinematics.solutions.polish import TASK_SLACK, checked
from ropsim.kinematics.solutions.result import IkStatus, Miss, Posture, Shortfall
from ropsim.kinematics.solutions.solver import Method, Snap
from ropsim.kinematics.solvers.axes import NEAR_SINGULAR
from ropsim.kinematics.solvers.numeric import NumericSolver, numeric
from ropsim.model import ALL_DIRECTIONS, BASE_LINK, JointType, RobotModel
from ropsim.spatial import Array, Pose, record

BALLS = {JointType.UNIVERSAL, JointType.SPHERICAL}
HELD = frozenset(ALL_DIRECTIONS[:3])
MOST_AXES = 6
TURN = 2.0 * np.pi
EFFORT = 16
"""Steps that are made to follow the chains from home to an answer: more cost milliseconds, and lead past dead
centres into other assemblies."""


class Lead(NamedTuple):
    """A bar and one of its rods.

    Attributes:
        placement: of the axis in the base frame, shape (4, 4).
        turns: whether it turns.
        offset: added to its coordinate [rad | m].
        near: end of the rod in the frame of the axis, which moves with it [m], shape (3,).
        far: its other end in the mechanical interface [m], shape (3,).
        length: of the rod [m].
    """

    placement: Array
    turns: bool
    offset: float
    near: Array
    far: Array
    length: float


class Ends(NamedTuple):
    """Two parts of each answer: middle ± aside.

    Attributes:
        middle: direction to the far end of the rod, or its place along a slide [rad | m], shape (k,).
        aside: to both sides of it [rad | m], NaN where the rod is too short or too long, shape (k,).
    """

    middle: Array
    aside: Array


@record
class RodsSolver:
    """Inverse kinematics of an arm of the class.

    Attributes:
        robot: the arm.
        arrays: of it, followed with a bounded effort.
        leads: for each axis.
        search: for the nearest place of a pose that is not reached.
        postures: of the branches, which have no names.
    """

    robot: RobotModel
    arrays: ClosedArrays
    leads: tuple[Lead, ...]
    search: NumericSolver
    postures: tuple[Posture, ...]

    name: ClassVar[str] = "plate on rods"
    method: ClassVar[Method] = Method.ALGEBRAIC
    parts: ClassVar[tuple[str, ...]] = ()
    snapped_by: ClassVar[Snap] = Snap()
    slack: ClassVar[float] = TASK_SLACK

    def branches(self, T: Array, near: Array) -> Array:
        """Return the branches of many poses, shape (k, 2^n, n); see `InverseSolver.branches`."""
        del near
        found = [_ends(lead, T) for lead in self.leads]
        sides = np.array([[one.middle + one.aside, one.middle - one.aside] for one in found])  # (n, 2, k)
        for number, lead in enumerate(self.leads):
            sides[number] -= lead.offset
            if lead.turns:
                sides[number] -= TURN * np.ceil((sides[number] - np.pi) / TURN)
        choices = np.array(list(product((0, 1), repeat=len(self.leads))))  # (b, n)
        rows = sides[np.arange(len(self.leads)), choices].transpose(2, 0, 1)  # (k, b, n)
        rows[np.isnan(rows).any(axis=2)] = np.nan
        return checked(self.arrays, T, np.ascontiguousarray(rows), self.slack)

    def posture(self, q: Array) -> Posture:
        """Return the posture without words: the sides of bars have no names."""
        del q
        return Posture()

    def may_stay(self, q: Array) -> bool:
        """Return whether a bar and its rod are nearly in one line, or a rod at right angles to its slide."""
        return bool(np.abs(self._asides(q)).min() < NEAR_SINGULAR)

    def shortfall(self, X_BM: Array) -> Shortfall:
        """Return why no branch reaches a pose (4, 4), and how far the nearest one is that was found."""
        found, miss = [_ends(lead, X_BM[np.newaxis]) for lead in self.leads], self.search.miss(X_BM)
        for number, one in enumerate(found):
            if np.isnan(one.aside[0]):
                axis = self.robot.axis_joints[number].name
                text = f"axis `{axis}` cannot bring its rod there, and the nearest pose was found numerically"
                return Shortfall(IkStatus.OUT_OF_REACH, miss=Miss(text, miss.distance, miss.angle))
        return Shortfall(IkStatus.OUT_OF_TASK_SPACE, miss=miss)

    def _asides(self, q: Array) -> list[float]:
        """Return sines of the angles, or shares of the rods, by which axes at q (n,) are aside."""
        X = forward(self.robot, q).matrix()[np.newaxis]
        found = []
        for number, lead in enumerate(self.leads):
            apart = float(q[number]) + lead.offset - float(_ends(lead, X).middle[0])
            found.append(np.sin(apart) if lead.turns else apart / lead.length)
        return found


def _ends(lead: Lead, T: Array) -> Ends:
    """Return the two values of an axis for poses (k, 4, 4) of the interface."""
    points = T[:, :3, :3] @ lead.far + T[:, :3, 3] - lead.placement[:3, 3]
    x, y, z = (points @ lead.placement[:3, :3]).T
    ax, ay, az = lead.near
    with np.errstate(invalid="ignore"):
        if not lead.turns:
            squared = lead.length**2 - (x - ax) ** 2 - (y - ay) ** 2
            return Ends(z - az, np.sqrt(squared))
        A, B = x * ax + y * ay, y * ax - x * ay
        C = 0.5 * (lead.near @ lead.near + x * x + y * y + z * z - lead.length**2) - az * z
        return Ends(np.arctan2(B, A), np.arccos(C / np.hypot(A, B)))


def recognise(robot: RobotModel) -> RodsSolver | str:
    """Return the solver of an arm of the class, or the condition that another arm misses."""
    if not 1 <= robot.n <= MOST_AXES:
        return f"it has {robot.n} axes, the class has 1 to {MOST_AXES}"
    plate, rods, leads = robot.tip, _rods(robot), []
    for axis, joint in zip(robot.axes, robot.axis_joints, strict=True):
        if joint.parent != BASE_LINK or joint.type not in {JointType.REVOLUTE, JointType.PRISMATIC}:
            return f"axis `{joint.name}` is no bar or slide on the base"
        led = [ends for ends in rods if set(ends) == {axis, plate}]
        if not led:
            return f"no rod with ball joints leads from axis `{joint.name}` to the interface"
        near, far, length = led[0][axis][0], led[0][plate][0], led[0][axis][1]
        leads.append(
            Lead(
                joint.placement.matrix(),
                joint.type is JointType.REVOLUTE,
                joint.offset,
                near,
                np.asarray((robot.X_nM.inverse() @ Pose(far)).position),
                length,
            )
        )
    arrays, postures = closed_arrays(robot).within(EFFORT), (Posture(),) * 2**robot.n
    return RodsSolver(robot, arrays, tuple(leads), numeric(robot), postures)


def _rods(robot: RobotModel) -> list[dict[int, tuple[Array, float]]]:
    """Return the rods: for the link at each end the place of the ball in its frame, and the length."""
    balls: dict[int, list[tuple[int, Array, Array]]] = {}
    for link, joint in enumerate(robot.joints):
        if joint.type in BALLS and joint.parent != BASE_LINK:
            at, own = joint.placement.position, np.zeros(3)
            balls.setdefault(link, []).append((joint.parent, own, at))
            balls.setdefault(joint.parent, []).append((link, at, own))
    for cut in robot.cuts:
        if set(cut.held) >= HELD and len(cut.held) <= 4 and BASE_LINK not in {cut.first, cut.second}:
            first, second = cut.X_first.position, cut.X_second.position
            balls.setdefault(cut.first, []).append((cut.second, first, second))
            balls.setdefault(cut.second, []).append((cut.first, second, first))
    found = []
    for link, ends in balls.items():
        if len(ends) == 2 and link not in {*robot.axes, robot.tip}:
            length = float(np.linalg.norm(ends[0][1] - ends[1][1]))
            found.append({other: (place, length) for other, _, place in ends})
    return found
