"""Lengths in millimetres that are nearly nothing, as those in metres are: the same rule as in cell files."""

from collections.abc import Iterable

from ropsim.language.check import numerals, units
from ropsim.language.check.body import Body
from ropsim.language.findings import types as kinds
from ropsim.language.report import Placed
from ropsim.language.syntax import nodes

_NEAR = 2.0
"""Lengths below this of which one is no whole number are most often in metres [mm]."""
_MILLIMETRE = 0.001


def check_place(body: Body, node: nodes.Node) -> None:
    """Warn of three bare numbers in parentheses that put something nearly at its origin (T338)."""
    if not isinstance(node, nodes.Tuple) or not _is_near(body, places := [i.value for i in node.items[:3]]):
        return
    shown = ", ".join(f"{numerals.bare(one):g}" for one in places)
    rest = body.line.logical.text[places[-1].end : node.end]
    meant = (f"`({', '.join(f'{body.written(one)} {unit}' for one in places)}{rest}`" for unit in ("m", "mm"))
    message = f"`({shown})` without a unit is in mm, hardly away from its origin"
    body.warn(kinds.OTHER_UNIT, node, message, f"write {', or '.join(meant)}")


def check_length(body: Body, word: str, node: nodes.Node, place: Placed) -> None:
    """Warn of a distance behind a word that is nearly none (T338)."""
    if not _is_near(body, (node,)):
        return
    written = body.written(node)
    number = f"{numerals.bare(node):g}"
    message = f"`{word} {number}` without a unit is {number} mm"
    body.warn(kinds.OTHER_UNIT, place, message, f"write `{word} {written} m`, or `{word} {written} mm`")


def _is_near(body: Body, values: Iterable[nodes.Node]) -> bool:
    """Return whether all lengths are bare numbers in millimetres that look like metres."""
    has_fraction = False
    for one in values:
        number = numerals.bare(one)
        if number is None or abs(number) >= _NEAR:
            return False
        has_fraction = has_fraction or number % 1.0 != 0.0
    return has_fraction and body.world.units.factor(units.LENGTH) == _MILLIMETRE
