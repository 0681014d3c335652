"""Arms whose closed chains move the joints on the way to the tool: cylinders at a two-link arm, a five-bar.

The joints on the way, one behind the other, make the *plain* arm, which is in one of the classes and has all
its branches. For each of them the chains are solved the other way round, the joints on the way given and the
axes unknown: the same closed chains with other axes, followed from the rest position. An answer counts where
the chains, followed by the axes, have the interface at the pose: it is in the assembly of the rest position.
"""

from dataclasses import replace
from functools import lru_cache

import numpy as np

from ropsim.kinematics.chain.arrays import on_step
from ropsim.kinematics.chain.closed_arrays import ClosedArrays, closed_arrays, closed_arrays_at
from ropsim.kinematics.chain.closed_motion import joint_motion
from ropsim.kinematics.chain.closure import closed_states, states_along
from ropsim.kinematics.solutions.polish import checked
from ropsim.kinematics.solutions.result import IkStatus, Miss, Posture, Shortfall
from ropsim.kinematics.solutions.solver import InverseSolver
from ropsim.kinematics.solvers.plain_arm import PlainArmSolver
from ropsim.model import (
    Joint,
    JointTree,
    JointType,
    Link,
    RobotModel,
    first_coordinates,
    joint_tree,
    passive_coordinates,
)
from ropsim.spatial import Array, frozen, record

TURN = 2.0 * np.pi


@record
class Switched:
    """Closed chains with the joints on the way to the interface as axes.

    Attributes:
        plain: the arm of these joints alone.
        arrays: the closed chains, with n of these joints as axes and p other coordinates.
        back: for each axis of the robot its place among the n + p.
        there: for each of the n + p its place among axes and loops of the robot.
    """

    plain: RobotModel
    arrays: ClosedArrays
    back: tuple[int, ...]
    there: tuple[int, ...]


@record
class LoopedSolver(PlainArmSolver):
    """Inverse kinematics of an arm with closed chains, in the coordinates of its axes.

    Attributes:
        plain: solver of the arm that the joints on the way alone make.
        arrays: of the robot.
        switched: its chains the other way round.
    """

    plain: InverseSolver
    arrays: ClosedArrays
    switched: Switched

    def joints(self, q: Array) -> Array:
        """Return coordinates of the joints on the way [rad | m], shape (n,), from those of the axes (n,)."""
        return self._state(q)[: self.arrays.n]

    def branches(self, T: Array, near: Array) -> Array:
        """Return all branches of many poses, shape (k, m, n); see `InverseSolver.branches`."""
        beside = self._state(near)
        found = self.plain.branches(T, beside[: self.arrays.n])
        present = ~np.isnan(found[:, :, 0])
        rows = self._turned(found[present])
        out = np.full(found.shape, np.nan)
        out[present] = self._followed(rows, beside)
        return checked(self.arrays, T, out, self.slack)

    def posture(self, q: Array) -> Posture:
        """Return the posture of axes at q [rad | m], shape (n,)."""
        return self.plain.posture(self.joints(q))

    def may_stay(self, q: Array) -> bool:
        """Return whether axes at q (n,) are near to a singular configuration."""
        return self.plain.may_stay(self.joints(q))

    def shortfall(self, X_BM: Array) -> Shortfall:
        """Return why no branch reaches a pose, shape (4, 4)."""
        there = self.plain.branches(X_BM[np.newaxis], self.switched.arrays.home[: self.arrays.n])
        if np.isnan(there[:, :, 0]).all():
            return self.plain.shortfall(X_BM)
        return Shortfall(
            IkStatus.OUT_OF_REACH, miss=Miss("the closed chains lock on the way there", 0.0, 0.0)
        )

    def _state(self, q: Array) -> Array:
        """Return the coordinates of the switched chains for axes at q (n,), shape (n + p,)."""
        state = closed_states(self.arrays, q[np.newaxis])[0][0]
        return np.ascontiguousarray(state[list(self.switched.there)])

    def _turned(self, rows: Array) -> Array:
        """Return joints of the plain arm, those within chains in the turn that is nearest to home."""
        n, arrays = self.arrays.n, self.switched.arrays
        slides = np.array([joint.type is JointType.PRISMATIC for joint in self.switched.plain.joints])
        turns = TURN * ((arrays.turning == 0.0) & ~slides)
        whole = np.round((rows - arrays.home[:n]) / TURN)
        return np.ascontiguousarray(rows - turns * whole)

    def _followed(self, rows: Array, beside: Array) -> Array:
        """Return the axes for joints of the plain arm (k, n), NaN where the chains lock on the way there."""
        arrays, back = self.switched.arrays, list(self.switched.back)
        states, results = closed_states(arrays, rows)
        for k in np.flatnonzero(results[:, 0] < 1.0):
            states[k : k + 1], results[k : k + 1] = states_along(arrays, rows[k : k + 1], beside)
        found = states[:, back]
        found[results[:, 0] < 1.0] = np.nan
        turns = TURN * self.arrays.turning
        return np.asarray(found - turns * np.ceil((found - np.pi) / TURN))


@lru_cache(maxsize=64)
def switched_loops(robot: RobotModel) -> Switched | None:
    """Return the chains of a robot with the joints on the way to its interface as axes.

    Args:
        robot: with closed chains and n axes.

    Returns:
        None where the way has not n joints of one freedom, each with a coordinate of its own.
    """
    tree, arrays = joint_tree(robot), closed_arrays(robot)
    way = list(tree.way(robot.interface_link))
    rows = np.column_stack((tree.T, tree.P))[way]
    own = (rows == 1.0).sum(axis=1) == 1
    if len(way) != robot.n or not own.all() or np.count_nonzero(rows) != robot.n or tree.c[way].any():
        return None
    links = [tree.carriers.index(step) for step in way]
    if any(robot.joints[link].type.freedoms != 1 for link in links):
        return None
    first = first_coordinates(robot.joints)
    home = joint_motion(robot, robot.home[np.newaxis]).position[0]
    numbers = [first[link] for link in links]
    other = replace(
        robot,
        joints=tuple(_driven(joint) for joint in robot.joints),
        axes=tuple(links),
        home=frozen(home[numbers]),
        drives=(),
        external=(),
        springs=(),
        dh=(),
    )
    others = passive_coordinates(other)
    if len(others) != arrays.p:
        return None
    made = closed_arrays_at(other, home[list(others)])
    order = [*numbers, *others]
    places = [*(first[axis] for axis in robot.axes), *passive_coordinates(robot)]
    if made.rank < made.p or set(order) != set(places):
        return None
    back = tuple(order.index(first[axis]) for axis in robot.axes)
    there = tuple(places.index(number) for number in order)
    return Switched(_plain(robot, tree, way, links, home[numbers]), made, back, there)


def _driven(joint: Joint) -> Joint:
    """Return a joint with rates that an axis may have; kinematics does not ask for them."""
    return replace(joint, max_speed=1.0, max_acceleration=1.0, max_jerk=1.0)


def _plain(robot: RobotModel, tree: JointTree, way: list[int], links: list[int], home: Array) -> RobotModel:
    """Return the serial arm of the joints on the way."""
    joints = tuple(
        Joint(
            name=robot.joints[link].name,
            type=tree.types[step],
            placement=tree.placements[step],
            offset=tree.offsets[step],
            lower=robot.joints[link].lower,
            upper=robot.joints[link].upper,
            max_speed=1.0,
            max_acceleration=1.0,
            max_jerk=1.0,
        )
        for step, link in zip(way, links, strict=True)
    )
    return RobotModel(
        name=robot.name,
        title=robot.title,
        joints=joints,
        links=(Link(0.0, np.zeros(3), np.zeros((3, 3))),) * len(joints),
        drives=(),
        home=home,
        X_nM=on_step(tree, robot.tip, robot.X_nM),
    )
