"""Whether drives have masses to move: links without any make the mass matrix singular."""

from functools import lru_cache

from ropsim.dynamics.axis_inertia import mass_matrices
from ropsim.dynamics.diagnostics import AXIS_WITHOUT_INERTIA, MissingMassError
from ropsim.dynamics.drives import reflected_inertia
from ropsim.dynamics.mass_check import idle_axes, uneven_posture
from ropsim.model import Mechanism

_SINGULAR = 1e-9
"""Pivot of a mass matrix, relative to its diagonal, that no simulation can divide by at every step."""


def massless_axes(robot: Mechanism) -> tuple[int, ...]:
    """Return the axes, from 0, whose link has neither mass nor inertia and whose drive no rotor.

    A file often has no number for such a link. Links that other joints move beside the axes, as those of
    parallelograms, do not count.

    Args:
        robot: with drives or without.
    """
    rotors = [reflected_inertia(drive, float(q)) for drive, q in zip(robot.drives, robot.home, strict=False)]
    found = []
    for axis, number in enumerate(robot.axes):
        link = robot.links[number]
        if not (link.mass or link.inertia.any() or (rotors and rotors[axis])):
            found.append(axis)
    return tuple(found)


@lru_cache(maxsize=256)
def check_moved_masses(robot: Mechanism) -> None:
    """Make sure that drives have something to move: links without mass may not make the mass matrix singular.

    A single massless link between others is allowed, as a frame or a cross of axes. With no more moving links
    than mass can be moved in, M·q̈ = τ - h has no answer but rounding.

    Raises:
        MissingMassError: M591, it names the links without mass.
    """
    without = massless_axes(robot)
    if not without:
        return
    q = uneven_posture(robot)
    has_any = any(link.mass or link.inertia.any() for link in robot.links)
    if has_any and not idle_axes(mass_matrices(robot, q[None])[0], _SINGULAR):
        return
    names = ", ".join(f"`{robot.axis_joints[axis].name}`" for axis in without)
    message = (
        f"the links that axes {names} of arm `{robot.name}` move have no mass, and its drives no rotors: "
        "torques would accelerate them without bound"
    )
    hint = (
        "`ropsim robot estimate FILE robots/NEW.stp --payload KG` gives them masses; `--kinematic` runs "
        "without drives"
    )
    raise MissingMassError(AXIS_WITHOUT_INERTIA.at(None, message, hint=hint))
