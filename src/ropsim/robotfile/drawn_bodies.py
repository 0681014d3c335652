"""Bodies of an arm that are only drawn: rods and cranks without mass that follow axes and carry nothing."""

from dataclasses import replace

from ropsim.core import frozen_dataclass
from ropsim.model import Link, RobotModel


@frozen_dataclass
class Undrawn:
    """An arm without bodies that are only drawn.

    Attributes:
        robot: the arm; it moves as before.
        names: of the joints whose bodies are left out.
    """

    robot: RobotModel
    names: tuple[str, ...]


def without_drawn_bodies(robot: RobotModel) -> Undrawn:
    """Return an arm without the rods behind its joints, and without the looks of cranks of coupled axes."""
    made, names = robot, []
    while _is_rod(made):
        last = len(made.joints) - 1
        names.append(made.joints[last].name)
        kept = tuple(one for one in made.couplings if one.dependent != last)
        made = replace(made, joints=made.joints[:-1], links=made.links[:-1], couplings=kept)
    links = list(made.links)
    for number in made.axes[: made.n] if made.couplings else ():
        carries = any(joint.parent == number for joint in made.joints)
        if _weighs_nothing(links[number]) and links[number].shapes and not carries and number != made.tip:
            links[number] = replace(links[number], shapes=())
            names.append(made.joints[number].name)
    return Undrawn(replace(made, links=tuple(links)) if names else robot, tuple(names))


def _is_rod(robot: RobotModel) -> bool:
    """Return whether the last body of an arm follows others, weighs nothing and carries nothing."""
    last = len(robot.joints) - 1
    if last < 1 or robot.cuts or any(joint.type.freedoms != 1 for joint in robot.joints):
        return False
    follows = any(one.dependent == last for one in robot.couplings)
    leads = any(last in dict(one.terms) for one in robot.couplings)
    return (
        follows and not leads and _weighs_nothing(robot.links[last]) and last not in (*robot.axes, robot.tip)
    )


def _weighs_nothing(link: Link) -> bool:
    return link.mass == 0.0 and not link.inertia.any()
