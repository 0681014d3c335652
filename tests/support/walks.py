"""Random stretches of moves for any arm, and what the reference of a plan asks of it, tick by tick."""

from dataclasses import dataclass, replace

import numpy as np

from ropsim.flow import ModalState, MotionKind, MoveInstruction
from ropsim.kinematics import forward_batch
from ropsim.model import Payload, RobotModel
from ropsim.planning import MotionChain, MotionPlan, MotionState, arm_bounds, plan
from ropsim.spatial import Array, Pose
from support.motion import references

WITHIN = 1.0 + 1e-9  # of limits: rounding
WITHIN_TOOL = 1.0 + 1e-3  # paths of joints are true to 1e-9 m between samples, seen by third differences
_MARGIN = 0.1  # of the range of a joint, on either side
_FEWEST_TICKS = 8
_SHORT = MotionKind.LIN, MotionKind.LIN, MotionKind.CIRC, MotionKind.SPLINE
_KINDS = MotionKind.PTP, MotionKind.LIN, MotionKind.CIRC, MotionKind.SPLINE
_POINTS = {MotionKind.PTP: 1, MotionKind.LIN: 1, MotionKind.CIRC: 2, MotionKind.SPLINE: 3}


@dataclass(frozen=True)
class Walk:
    """A stretch of moves.

    Attributes:
        q_start: joint coordinates at its start [rad | m], shape (n,).
        moves: in order; all but the last with a zone.
    """

    q_start: Array
    moves: tuple[MoveInstruction, ...]


def random_walk(chain: MotionChain, random: np.random.Generator) -> Walk:
    """Return two to seven moves of all kinds between poses that the arm can take, with zones of all sizes."""
    robot = chain.robot
    q = _between(robot, random.uniform(size=robot.n))
    start, moves = q, []
    for _ in range(random.integers(2, 8)):
        kind = _KINDS[random.integers(len(_KINDS))]
        reach = 0.5 if kind is MotionKind.PTP else 10.0 ** random.uniform(-3.0, -0.5)
        points = [_near(robot, q, reach, random) for _ in range(_POINTS[kind])]
        poses = [_pose(robot, one) for one in points]
        zone = float(random.choice([0.0, 10.0 ** random.uniform(-5.0, -0.5)]))
        speed = 10.0 ** random.uniform(-2.0, 0.5)
        modal = ModalState(ptp_speed=random.uniform(0.05, 1.0), path_speed=speed, zone=zone)
        external = tuple(float(points[-1][axis]) for axis in robot.external)
        moves.append(MoveInstruction(kind, poses[-1], modal, external=external, via=tuple(poses[:-1])))
        q = points[-1]
    return Walk(start, tuple(moves))


def hairpins(chain: MotionChain, random: np.random.Generator) -> Walk:
    """Return three to eight lines, arcs and curves of millimetres that turn back, most of them sharply."""
    robot = chain.robot
    start = _between(robot, random.uniform(size=robot.n))
    X_BT, ahead = _pose(robot, start), _direction(random.normal(size=3))
    external = tuple(float(start[axis]) for axis in robot.external)
    size, here, moves = 10.0 ** random.uniform(-3.3, -2.3), X_BT.position, []
    for number in range(random.integers(3, 9)):
        aside = _direction(np.cross(ahead, random.normal(size=3)))
        opening = 10.0 ** random.uniform(-3.0, 0.3)
        way = ((-1.0) ** number * ahead + opening * aside) * size * random.uniform(0.5, 2.0)
        kind = _SHORT[random.integers(len(_SHORT))]
        off = aside * size * random.normal(scale=0.3)
        shares = {MotionKind.LIN: (), MotionKind.CIRC: (0.5,), MotionKind.SPLINE: (0.3, 0.7)}[kind]
        via = tuple(Pose(here + share * way + off, X_BT.orientation) for share in shares)
        zone, speed = 10.0 ** random.uniform(-5.0, -2.7), 10.0 ** random.uniform(-1.0, 0.5)
        here = here + way
        modal = ModalState(path_speed=speed, zone=zone)
        moves.append(MoveInstruction(kind, Pose(here, X_BT.orientation), modal, external=external, via=via))
    return Walk(start, tuple(moves))


def faults_of(chain: MotionChain, walk: Walk, payload: Payload) -> list[str]:
    """Return which laws the plan of a walk breaks: limits of joints and tool at each tick, and continuity."""
    planned, refusal = plan(chain, walk.moves, MotionState.at_rest(walk.q_start), payload)
    if planned is None:
        return [] if refusal else ["neither a plan nor a refusal"]
    robot, period = chain.robot, planned.period
    asked, of_tool = shares(robot, planned, payload), tool_shares(robot, planned)
    faults = [f"{name} of a joint {share:.12g}" for name, share in asked.items() if not share <= WITHIN]
    faults += [f"{name} of the tool {share:.9g}" for name, share in of_tool.items() if share > WITHIN_TOOL]
    q, qd, qdd = references(planned)
    bend = np.abs(np.diff(qdd, axis=0)).max(initial=0.0)
    for name, way, rate, most in (
        ("position", q, qd, bend * period + 1e-9),
        ("speed", qd, qdd, bend + 1e-6),
    ):
        jump = np.diff(way, axis=0) / period - (rate[1:] + rate[:-1]) / 2.0
        if not np.abs(jump).max(initial=0.0) <= most:
            faults.append(f"{name} of a joint jumps")
    return faults


def cost_of_zones(chain: MotionChain, walk: Walk, payload: Payload) -> list[str]:
    """Return what is wrong where a walk with its zones takes longer than with a stop at each point."""
    start = MotionState.at_rest(walk.q_start)
    flown, _ = plan(chain, walk.moves, start, payload)
    if flown is None:
        return []
    moves = [replace(one, modal=replace(one.modal, zone=0.0)) for one in walk.moves[: len(flown.moves)]]
    stopped, _ = plan(chain, moves, start, payload)
    if stopped is None or len(stopped.moves) < len(moves) or flown.ticks <= stopped.ticks:
        return []
    return [f"{flown.duration:g} s with zones, {stopped.duration:g} s with stops"]


def shares(robot: RobotModel, plan: MotionPlan, payload: Payload) -> dict[str, float]:
    """Return the largest shares of the limits of speed, acceleration, jerk and torque that a plan takes."""
    q, qd, qdd = references(plan)
    bounds = arm_bounds(robot, payload)
    asked = {
        "speed": (qd, robot.max_speeds),
        "acceleration": (qdd, robot.max_accelerations),
        "jerk": (np.diff(qdd, axis=0) / plan.period, robot.max_jerks),
    }
    if bounds.effort is not None and bounds.joints.effort is not None:
        asked["torque"] = (bounds.effort(q, qd, qdd), bounds.joints.effort)
    return {name: float((np.abs(values) / limit).max(initial=0.0)) for name, (values, limit) in asked.items()}


def tool_shares(robot: RobotModel, plan: MotionPlan) -> dict[str, float]:
    """Return the largest shares of the limits of the tool that a plan takes, by differences of TCP positions.

    Looked at is what is on paths of the tool that no external axis moves, ticks at borders left out; at a
    corner the limits of the move count that has the higher ones.
    """
    q = references(plan)[0]
    worst = dict.fromkeys(("speed", "acceleration", "jerk"), 0.0)
    begins = [0, *(move.last for move in plan.moves[:-1])]
    for piece in plan.path_segments:
        if piece.path is None or piece.frame is not None or piece.last - piece.first < _FEWEST_TICKS:
            continue
        rows = q[piece.first + 1 : piece.last + 1]
        places = (forward_batch(robot, rows) @ piece.X_MT.matrix())[:, :3, 3]
        on = [
            move.limits.tool
            for begin, move in zip(begins, plan.moves, strict=True)
            if move.limits and begin <= piece.last and move.last > piece.first
        ]
        for order, name in enumerate(worst, 1):
            rates = np.diff(places, order, axis=0) / plan.period**order
            limit = max(getattr(each, name) for each in on)
            worst[name] = max(worst[name], float(np.linalg.norm(rates, axis=1).max() / limit))
    return worst


def _between(robot: RobotModel, share: Array) -> Array:
    low, high = (np.clip(limit, -np.pi, np.pi) for limit in (robot.lower_limits, robot.upper_limits))
    q: Array = low + (_MARGIN + (1.0 - 2.0 * _MARGIN) * share) * (high - low)
    return q


def _near(robot: RobotModel, q: Array, reach: float, random: np.random.Generator) -> Array:
    low, high = _between(robot, np.zeros(robot.n)), _between(robot, np.ones(robot.n))
    near: Array = np.clip(q + random.uniform(-reach, reach, robot.n) * (high - low), low, high)
    return near


def _direction(vector: Array) -> Array:
    return np.asarray(vector / np.linalg.norm(vector))


def _pose(robot: RobotModel, q: Array) -> Pose:
    return Pose.from_matrix(forward_batch(robot, q[None])[0])
