"""Losses from one format of robots to another (codes X993 to X997)."""

from collections.abc import Iterable

from ropsim.core import Diagnostic, Severity, define, plural

LOST_MOTION = define(
    "X993",
    "exchange-loses-motion",
    Severity.WARNING,
    "joints or couplings do not go over: the robot on the other side moves differently",
    """
A robot file and the model hold different kinds of joints and couplings. Read: joints that are not on the
way to the tip, and that nothing on it follows, stand still at their zero, and their bodies ride along
with their weight; springs at joints are left out. Written: URDF has joints that follow one other joint
(`mimic`), none that follow two, and no closed chains; it says nothing of gravity. The message names each
joint. Check whether the other side needs it, and mend the file there.
""",
)

LOST_DRIVE = define(
    "X994",
    "exchange-loses-drives",
    Severity.HINT,
    "data of drives do not go over: motors, gears, friction by direction, controllers",
    """
URDF and MJCF know a joint with viscous and dry friction and a greatest effort; MJCF knows the inertia of
a rotor at the joint too. Amplifiers, motor constants, gears that twist, and friction that differs
between the two directions have no place there; soft limits and calibrations of such files have no place in
the model, nor have attributes of `limit` and `dynamics` that the format does not define. Geometry and rigid
bodies are not touched by that.
""",
)

LOST_DESCRIPTION = define(
    "X995",
    "exchange-loses-description",
    Severity.HINT,
    "names, looks or remarks do not go over; the robot moves and weighs the same",
    """
What stands in no place of the other side: names of links and of frames that are fixed to them, collision
geometry beside what is drawn, textures, sensors, transmissions and other elements for other programs; and
from the model cones, bodies of revolution, outlines and lines, the title, where numbers come from, and the
home position. What is fixed to a link becomes a part of it, with its weight and its shape. A robot without
visual geometry is drawn by its collision geometry; a link with collision geometry alone that is fixed at
the origin of a link that is drawn is left out, as makers describe volumes for self-collision so. All of it
is one finding, with a note on each loss.
""",
)

LOST_MASS = define(
    "X997",
    "exchange-loses-masses",
    Severity.WARNING,
    "masses of links do not go over: the robot on the other side has no weight",
    """
A plain mechanism of AP242 is links, joints and pairs; mass, centre of mass and inertia of its links have no
place there. On the other side the robot moves as it does here, without dynamics. NIROX (`.stp` without
`--as`) has the same mechanism and the masses beside it, and readers of AP242 leave out what they do not know.
""",
)

LOSSES_REFUSED = define(
    "X996",
    "exchange-losses-refused",
    Severity.ERROR,
    "with --strict nothing is written that loses something",
    """
`ropsim robot import` and `ropsim robot export` tell what does not go over from one format to the other and
write the rest. With `--strict` they write nothing where anything is lost, looks and names included. What is
lost stands above this error. NIROX (`.stp`) holds everything that the model has.
""",
)

LOSSES = frozenset(kind.code for kind in (LOST_MOTION, LOST_DRIVE, LOST_MASS, LOST_DESCRIPTION))
"""Codes of losses in reading."""


def losses_refused(read: Iterable[Diagnostic], written: Iterable[Diagnostic]) -> Diagnostic | None:
    """Return the finding that forbids to write with losses; None where nothing is lost.

    Args:
        read: findings of reading the robot.
        written: losses of writing it.
    """
    count = sum(max(1, len(one.notes)) for one in read if one.code in LOSSES) + len(tuple(written))
    message = f"nothing is written, as {plural(count, 'thing')} would be lost"
    return LOSSES_REFUSED.at(None, message, hint="NIROX (`.stp`) holds all of the model") if count else None
