"""The index of the robot library: each built-in robot in a line, from its model."""

import numpy as np

from ropsim.kinematics import frames_batch, solver_of
from ropsim.model import OriginKind, RobotModel, coupled_limits
from ropsim.robots import CatalogueEntry
from ropsim.spatial import Array

MAKERS = (
    *("ABB", "Adept", "FANUC", "Franka Emika", "KUKA", "Manutec", "PATU", "Stanford", "Stäubli", "Unimation"),
    *("Universal Robots", "Yaskawa"),
)
"""What titles begin with."""
GROUPS = {
    "axes": ("axes", "lengths"),
    "limits": ("limits",),
    "speeds": ("speed",),
    "accelerations": ("acceleration",),
    "torques": ("torque",),
    "payload": ("payload",),
    "masses": ("mass",),
    "drives": ("motor", "gear", "drives"),
    "friction": ("friction",),
}
"""Kinds of numbers and words that groups of parameters with them are called by."""
KINDS = tuple(kind.value for kind in OriginKind)
_SAMPLES, _SEED, _WAYS = 1000, 1, 16
_FIRST_STEP, _LAST_STEP = 0.3, 1e-4  # of the search [rad | m]


def entry(robot: RobotModel) -> CatalogueEntry:
    """Return the line of a robot."""
    maker = next((one for one in MAKERS if robot.title.startswith(f"{one} ")), "")
    return CatalogueEntry(
        name=robot.name,
        maker=maker,
        model=robot.title.removeprefix(maker).strip(),
        axes=robot.n,
        rated_payload=robot.rated_payload,
        reach=reach(robot),
        solver=solver_of(robot).name,
        data=tuple(_data(robot)),
        source=robot.origins[0].source,
    )


def _data(robot: RobotModel) -> list[str]:
    """Return the groups of numbers of a robot with their kinds, `published` unless one is named."""
    there = {
        "masses": any(link.mass for link in robot.links),
        "drives": bool(robot.drives),
        "friction": bool(robot.drives),
    }
    found = []
    for group, words in GROUPS.items():
        kinds = {one.kind for one in robot.origins if any(word in _named(one.parameters) for word in words)}
        if kinds and there.get(group, True):
            named = [kind for kind in KINDS if kind in kinds]
            found.append(group if named == ["published"] else f"{group} {' and '.join(named)}")
    return found


def _named(parameters: str) -> str:
    """Return the name of a group without its accuracy, in which torque limits are no limits of joints."""
    return parameters.partition(" (")[0].replace("torque limits", "torques")


def reach(robot: RobotModel) -> float:
    """Return how far the wrist comes from axis 1 within the limits [m], found by a search.

    The wrist is where the last but one axis begins; of arms with three or four axes where the last one does,
    of those with fewer it is the interface.
    """
    place = -1 if robot.n < 3 else robot.axes[-1 if robot.n < 5 else -2]
    low, high = np.maximum(robot.lower_limits, -np.pi), np.minimum(robot.upper_limits, np.pi)
    rng = np.random.default_rng(_SEED)
    Q = rng.uniform(low, high, (_SAMPLES, robot.n))
    best, step = Q[int(np.argmax(_away(robot, Q, place)))], _FIRST_STEP
    while step > _LAST_STEP:
        ways = np.vstack(
            (np.zeros(robot.n), np.eye(robot.n), -np.eye(robot.n), rng.normal(size=(_WAYS, robot.n)))
        )
        tried = np.clip(best + step * ways, low, high)
        away = _away(robot, tried, place)
        most = int(np.argmax(away))
        step = step if away[most] > away[0] + 1e-9 else 0.5 * step
        best = tried[most]
    return float(_away(robot, best[None], place)[0])


def _away(robot: RobotModel, Q: Array, place: int) -> Array:
    """Return how far a frame is from axis 1 [m]; less than 0 where joints that follow exceed their limits."""
    first = robot.joints[0].placement
    away = frames_batch(robot, Q)[:, place, :3, 3] - first.position
    axis = first.rotation()[:, 2]
    beyond = coupled_limits(robot).excess(Q).sum(axis=1)
    return np.asarray(
        np.where(beyond > 0.0, -beyond, np.linalg.norm(away - np.outer(away @ axis, axis), axis=1))
    )
