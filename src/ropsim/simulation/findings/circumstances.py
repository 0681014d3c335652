"""Causes in hints of findings besides the motion: a changed joint controller, a meant contact."""

from collections.abc import Iterable

from ropsim.core import frozen_dataclass
from ropsim.model import Cell, ControllerKind, ControllerModel, RobotModel
from ropsim.robots import controller_under, possible_laws

_GAINS = "if gains were set in the cell, `ropsim controller response CELL` says whether the loop is stable"
OWN_LAW = "if the law is your own, `ropsim controller response CELL` says whether the loop is stable"
"""Advice where a run has a law of the user."""


@frozen_dataclass
class Circumstances:
    """Causes besides the motion for a joint that falls behind or swings.

    Attributes:
        loop: advice where the joint controller is not the standard one; empty where it is.
        contact: words on the contact that held the arm back; empty without.
    """

    loop: str = ""
    contact: str = ""

    def hint(self, usual: str) -> str:
        """Return a hint: first the contact, then the usual advice, then the loop."""
        first = f"{self.contact}; otherwise " if self.contact else ""
        return f"{first}{usual}; or, {self.loop}" if self.loop else f"{first}{usual}"


def loop_words(robot: RobotModel, controller: ControllerModel) -> str:
    """Return advice where gains or law of an arm are not the standard ones; empty where they are.

    Args:
        robot: the arm.
        controller: of it.
    """
    if controller.kind is ControllerKind.FILE:
        return OWN_LAW
    if not robot.drives or controller.kind is ControllerKind.IDEAL:
        return ""
    laws = possible_laws(robot)
    if controller.kind == laws[0]:
        same = controller_under(robot, controller.rates, controller.kind).gains == controller.gains
        return "" if same else _GAINS
    return _GAINS


def contact_words(cell: Cell, force: float) -> str:
    """Return words on the meant contacts that held an arm back; empty without a force.

    Args:
        cell: with its contacts.
        force: greatest contact force [N].
    """
    if not force > 0.0:
        return ""
    names = _named(one.name for one in cell.contacts)
    return f"it was held back by {names}, with up to {force:.3g} N: see whether that is meant"


def _named(contacts: Iterable[str]) -> str:
    names = [f"`{one}`" for one in contacts]
    return f"contact {names[0]}" if len(names) == 1 else f"one of the contacts {', '.join(names)}"
