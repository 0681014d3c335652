"""Angles in degrees that have the digits of radians: 1.5708, or 3.14 next to other small numbers."""

from collections.abc import Iterable, Sequence
from math import degrees, pi

from ropsim.language.check.doubts import numerals
from ropsim.language.check.scope.body import Body
from ropsim.language.findings import types as kinds
from ropsim.language.report import Placed
from ropsim.language.syntax import nodes
from ropsim.language.syntax.statements import Setting

_STEP = pi / 4.0
_LAST = 8
"""Multiples of an eighth of a turn that are known by their digits."""
_LARGEST = (_LAST + 0.5) * _STEP
_CERTAIN = 4
"""This number of digits indicates radians regardless of the numbers next to it."""
_LIKELY = 3
"""This number of digits indicates radians if all numbers next to it are small."""
_ROUNDED = 0.005
"""Greatest rounding error of a number that is at most half a turn or a turn."""


def check_joints(body: Body, node: nodes.Joints, angles: Sequence[nodes.Node]) -> None:
    """Warn of joint coordinates of which one has the digits of a part of a turn in radians (T338)."""
    found = _suspect(body, angles, 2.0 * pi)
    if found is not None:
        number, turn = found
        message = f"`joints(…)` has {number:g}°, the digits of {turn:g}° in radians"
        body.warn(kinds.OTHER_UNIT, node, message, "write degrees, or `rad` behind each number")


def check_term(body: Body, term: nodes.Turn) -> None:
    """Warn of an orientation term in radians (T338)."""
    if term.values and term.word != "quat":
        _check(body, term, term.word, term.values, pi)


def check_arc(body: Body, setting: Setting) -> None:
    """Warn of the angle of an arc in radians (T338)."""
    if setting.value is not None:
        _check(body, setting, setting.word, (setting.value,), 2.0 * pi)


def check_angles(body: Body, node: nodes.Tuple) -> None:
    """Warn of the angles of five or six numbers that are in radians (T338)."""
    angles = [item.value for item in node.items[3:]]
    found = _suspect(body, angles, pi)
    if found is not None:
        number, turn = found
        lengths = ", ".join(body.written(item.value) for item in node.items[:3])
        rest = body.line.logical.text[angles[-1].end : node.end]
        text = f"({lengths}, {', '.join(_in_radians(body, angles))}{rest}"
        message = f"this location has {number:g}°, the digits of {turn:g}° in radians"
        body.warn(kinds.OTHER_UNIT, node, message, f"write degrees, or `{text}`")


def _check(body: Body, place: Placed, word: str, values: Sequence[nodes.Node], most: float) -> None:
    found = _suspect(body, values, most)
    if found is None:
        return
    number, turn = found
    message = f"`{word}` has {number:g}°, the digits of {turn:g}° in radians"
    meant = f"`{word} {turn:g} deg`" if len(values) == 1 else "degrees"
    before = body.line.logical.text[place.start : values[0].start]
    text = f"{before}{' '.join(_in_radians(body, values))}"
    body.warn(kinds.OTHER_UNIT, place, message, f"write {meant}, or `{text}`")


def _in_radians(body: Body, values: Iterable[nodes.Node]) -> list[str]:
    return [f"{body.written(one)} rad" for one in values]


def _suspect(body: Body, values: Sequence[nodes.Node], most: float) -> tuple[float, float] | None:
    """Return the first number without unit that looks like radians, and its value in degrees.

    Args:
        body: where they stand.
        values: angles that belong together.
        most: size up to which few digits are enough, if that of all numbers is [rad].
    """
    found, largest = [], 0.0
    for one in values:
        number = numerals.bare(one)
        if number is None:
            return None
        size = abs(number)
        largest = max(largest, size)
        if size < _LARGEST and size % 1.0:
            found.append(number)
    if not found or body.world.units.angle == 1.0:
        return None
    enough = _LIKELY if largest <= most + _ROUNDED else _CERTAIN
    for number in found:
        turn = _turn(abs(number), enough)
        if turn:
            return number, degrees(turn if number > 0.0 else -turn)
    return None


def _turn(size: float, enough: int) -> float:
    """Return the multiple of an eighth of a turn whose digits a size has, 0 where it has too few of them."""
    nearest = round(size / _STEP)
    if not 1 <= nearest <= _LAST:
        return 0.0
    whole, _, decimals = f"{size!r}".partition(".")
    if len((whole + decimals).lstrip("0")) < enough:
        return 0.0
    last, missing = 10.0 ** -len(decimals), nearest * _STEP - size
    is_near = -0.51 * last < missing < last  # rounded, or cut off
    return nearest * _STEP if is_near else 0.0
