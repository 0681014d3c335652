"""All checks of a diagram, one after the other."""

from itertools import islice

from ropsim.blockdiagram.checks.fault import CONTROLLER, Fault, Part
from ropsim.blockdiagram.checks.numbers import number_faults
from ropsim.blockdiagram.checks.sizes import size_faults
from ropsim.blockdiagram.checks.units import unit_faults
from ropsim.blockdiagram.checks.wires import name_faults, wire_faults
from ropsim.blockdiagram.diagnostics import ALGEBRAIC_LOOP, WRONG_WIRING, DiagramError
from ropsim.blockdiagram.diagram import Diagram
from ropsim.blockdiagram.wiring import LoopError, wiring_of

MOST = 50
"""Faults of a diagram that are reported."""
_NAMED = 6  # blocks of a loop that a message names
_CHECKS = (name_faults, size_faults, number_faults, wire_faults, unit_faults)
"""Each relies on the checks before it."""


def faults_of(diagram: Diagram) -> tuple[Fault, ...]:
    """Return the faults of a diagram; where there are some, later checks are left out."""
    for check in _CHECKS:
        found = tuple(islice(check(diagram), MOST))
        if found:
            return found
    try:
        wiring_of(diagram)
    except LoopError as error:
        return (_loop(diagram, error),)
    return ()


def check_diagram(diagram: Diagram) -> None:
    """Make sure that a diagram has no faults.

    Raises:
        DiagramError: C621 to C625, a check fails.
    """
    found = faults_of(diagram)
    if found:
        raise DiagramError(found[0].finding())


def _loop(diagram: Diagram, error: LoopError) -> Fault:
    if error.element is not None:
        name, element = error.element
        message = f"links lead from element {element + 1} of `{name[:60]}` back to it"
        number = next(k for k, link in enumerate(diagram.links) if link.target == name)
        return Fault(WRONG_WIRING, ("link", number), message)
    named = [f"`{diagram.blocks[k].name[:60]}`" for k in error.blocks[:_NAMED]]
    words = " ▸ ".join(named) + (" ▸ …" if len(error.blocks) > _NAMED else "")
    part: Part = ("block", error.blocks[0]) if error.blocks else CONTROLLER
    message = f"blocks need each other within one control tick: {words}"
    return Fault(ALGEBRAIC_LOOP, part, message, "a delay or an integrator between them opens the loop")
