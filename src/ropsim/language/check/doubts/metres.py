"""Lengths in millimetres that are nearly nothing, probably written in metres."""

from collections.abc import Iterable, Iterator
from dataclasses import fields, is_dataclass

from ropsim.language.check.doubts import numerals
from ropsim.language.check.scope import units
from ropsim.language.check.scope.body import Body
from ropsim.language.findings import types as kinds
from ropsim.language.report import Placed
from ropsim.language.syntax import nodes
from ropsim.language.syntax.statements import Setting

_NEAR_NONE = 0.1
"""Distances below this are most often in metres; heights and blends of some tenths are usual [mm]."""
_NEAR = 2.0
"""Lengths below this of which one is no whole number are most often in metres [mm]."""
_MILLIMETRE = 0.001


def check_place(body: Body, node: nodes.Tuple) -> None:
    """Warn of a location whose numbers put it nearly at its origin (T338).

    One on the z of its frame may well be that near to its origin, `(0, 0, 0.2)` between layers.
    """
    if any(numerals.bare(item.value) != 0.0 for item in node.items[:2]):
        _check(body, node)


def check_frame(body: Body, node: nodes.Node) -> None:
    """Warn of a frame or a tool that is nearly at its origin, unless it corrects another one (T338)."""
    if isinstance(node, nodes.Tuple) and not _is_correction(node):
        _check(body, node)


def check_length(body: Body, word: str, node: nodes.Node, place: Placed) -> None:
    """Warn of a distance behind a word that is nearly none (T338)."""
    if not _is_near(body, (node,), _NEAR_NONE):
        return
    written = body.written(node)
    number = f"{numerals.bare(node):g}"
    message = f"`{word} {number}` without a unit is {number} mm"
    body.warn(kinds.OTHER_UNIT, place, message, f"write `{word} {written} m`, or `{word} {written} mm`")


def _check(body: Body, node: nodes.Tuple) -> None:
    places = [item.value for item in node.items[:3]]
    if not _is_near(body, places, _NEAR):
        return
    shown = ", ".join(f"{numerals.bare(one):g}" for one in places)
    rest = body.line.logical.text[places[-1].end : node.end]
    meant = (f"`({', '.join(f'{body.written(one)} {unit}' for one in places)}{rest}`" for unit in ("m", "mm"))
    message = f"`({shown})` without a unit is in mm, hardly away from its origin"
    body.warn(kinds.OTHER_UNIT, node, message, f"write {', or '.join(meant)}")


def _is_near(body: Body, values: Iterable[nodes.Node], near: float) -> bool:
    """Return whether all lengths are bare numbers in millimetres that look like metres.

    They do not where another length of the line is clearly in millimetres.
    """
    has_fraction = False
    for one in values:
        number = numerals.bare(one)
        if number is None or abs(number) >= near:
            return False
        has_fraction = has_fraction or number % 1.0 != 0.0
    is_near = has_fraction and body.world.units.factor(units.LENGTH) == _MILLIMETRE
    return is_near and not _has_long(body)


def _is_correction(node: nodes.Tuple) -> bool:
    """Return whether a pose turns as little as it shifts."""
    angles = [item.value for item in node.items[3:]]
    for term in node.turns:
        if not term.values:
            return False
        angles += term.values
    numbers = [numerals.bare(one) for one in angles]
    return any(numbers) and all(one is not None and abs(one) < _NEAR for one in numbers)


def _has_long(body: Body) -> bool:
    """Return whether a bare length of the line in hand is not near; each line is searched once."""
    line, has_long = body.looked_through
    if line is not body.line:
        has_long = any(abs(numerals.bare(one) or 0.0) >= _NEAR for one in _lengths(body.line.statement))
        body.looked_through = body.line, has_long
    return has_long


def _lengths(statement: object) -> Iterator[nodes.Node]:
    """Yield the lengths of places, shifts and steps, and the values behind `above` and `blend`."""
    work = [statement]
    while work:
        part = work.pop()
        match part:
            case nodes.Tuple(items=items):
                yield from (item.value for item in items[:3])
            case nodes.Binary(op="above", right=right) | Setting(word="blend", value=right) if right:
                yield right
        if isinstance(part, tuple):
            work += part
        elif is_dataclass(part):
            work += (getattr(part, one.name) for one in fields(part))
