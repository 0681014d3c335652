"""Geometry instructions on plain tuples; same form of handlers as in `handlers`."""

import math
from collections.abc import Callable

from ropsim.flow import ListedPoint
from ropsim.icr.machine import trap_kinds as kinds
from ropsim.icr.machine.handlers import Datum, Handler
from ropsim.icr.machine.location import (
    Location,
    axes_of,
    composed,
    external_part,
    in_frame,
    in_posture,
    is_free,
    located,
    offset,
    orientation_free,
    point_of,
    pose_part,
    posture_of,
    tag_of,
    with_axes,
    with_turns,
)
from ropsim.icr.machine.traps import TrapError, out_of_range
from ropsim.icr.types import Type
from ropsim.spatial import quaternion


def _finite(name: str, values: tuple[float, ...]) -> tuple[float, ...]:
    if not all(map(math.isfinite, values)):
        raise out_of_range(f"the result of `{name}` is not finite")
    return values


def _make(count: int, function: Callable[..., Datum]) -> Handler:
    """Return the handler of a function of `count` operands."""

    def run(stack: list[Datum], _values: list[Datum], _operand: Datum) -> None:
        operands = stack[-count:]
        stack[-count:] = [function(*operands)]

    return run


def _make_joints(stack: list[Datum], _values: list[Datum], count: Datum) -> None:
    operands = tuple(stack[-count:])
    stack[-count:] = [operands]


def _make_external(stack: list[Datum], _values: list[Datum], count: Datum) -> None:
    location = stack[-count - 1]
    values = tuple(stack[-count:])
    own = posture_of(location), tag_of(location), axes_of(location), point_of(location)
    stack[-count - 1 :] = [located(pose_part(location), values, *own)]


def _orientation(w: float, x: float, y: float, z: float) -> Datum:
    try:
        return quaternion.normalize((w, x, y, z))
    except (ValueError, OverflowError):
        raise out_of_range(
            f"`MKORI.Q` is given ({w!r}, {x!r}, {y!r}, {z!r}), which has no direction"
        ) from None


def _compose(a: Location, b: Location) -> Location:
    location = composed(a, b)
    _finite("COMPOSE", pose_part(location))
    return location


def _reframe(change: Location, location: Location) -> Location:
    return location if tag_of(location) is not None else _compose(change, location)


def check_same_frame(name: str, a: Datum, b: Datum) -> None:
    """Trap where two poses are given in different task frames.

    Raises:
        TrapError: where one is to the other is not known.
    """
    one, other = tag_of(a), tag_of(b)
    if one != other:
        names = " and ".join(f"`{tag.name}`" if tag else "the task frame in force" for tag in (one, other))
        message = f"`{name}` is given poses in {names}, whose places to each other change"
        raise TrapError(kinds.POSE_UNKNOWN, message, "use locations that are given in one frame")


def _distance(a: Datum, b: Datum) -> float:
    check_same_frame("DIST", a, b)
    return _finite("DIST", (math.dist(a[:3], b[:3]),))[0]


def _angle(a: Datum, b: Datum) -> float:
    check_same_frame("ANGLE", a, b)
    w, x, y, z = quaternion.multiply(quaternion.conjugate(a[3:7]), b[3:7])
    return 2.0 * math.atan2(math.hypot(x, y, z), abs(w))


def _components(value: tuple[float, ...], kind: Type) -> tuple[float, ...]:
    """Return the components that GETC counts: an orientation as the fixed-XYZ angles rx, ry, rz [rad]."""
    if kind is Type.ORI:
        c, b, a = quaternion.to_zyx((value[0], value[1], value[2], value[3]))
        return (a, b, c)
    return value[:3] + _components(value[3:7], Type.ORI) if kind is Type.POSE else value


def _composed(components: tuple[float, ...], kind: Type) -> tuple[float, ...]:
    if kind is Type.ORI:
        a, b, c = components
        return quaternion.from_zyx(c, b, a)
    return components[:3] + _composed(components[3:], Type.ORI) if kind is Type.POSE else components


def get_component(stack: list[Datum], _values: list[Datum], operand: Datum) -> None:
    """GETC; the operand is (index, type of the value)."""
    index, kind = operand
    plain = kind in {Type.VEC, Type.JOINTS} or (kind is Type.POSE and index < 3)
    stack[-1] = stack[-1][index] if plain else _components(stack[-1], kind)[index]


def set_component(stack: list[Datum], _values: list[Datum], operand: Datum) -> None:
    """SETC; the operand is (index, type of the value)."""
    index, kind = operand
    number = stack.pop()
    whole = stack[-1]
    if kind in {Type.VEC, Type.JOINTS} or (kind is Type.POSE and index < 3):
        stack[-1] = (*whole[:index], number, *whole[index + 1 :])
    else:
        components = _components(whole, kind)
        changed = _composed((*components[:index], number, *components[index + 1 :]), kind)
        stack[-1] = (*changed, *whole[7:]) if kind is Type.POSE else changed


def shown(stack: list[Datum], _values: list[Datum], kind: Datum) -> None:
    """FMT; the operand is the type of the value."""
    value = stack[-1]
    if kind is Type.BOOL:
        stack[-1] = "true" if value else "false"
    elif kind is Type.REAL:
        stack[-1] = _number(value)
    elif kind in {Type.INT, Type.STR}:
        stack[-1] = str(value)
    else:
        stack[-1] = _listed(_components(value, kind), _DECIMALS.get(kind, _SI_DECIMALS))
        if kind is Type.POSE and external_part(value):
            stack[-1] += f" external {_listed(external_part(value), _SI_DECIMALS)}"
        if kind is Type.POSE and (request := posture_of(value)) is not None:
            stack[-1] += " free" if is_free(value) else ""
            stack[-1] += f" config ({', '.join(request.words)})" if request.words else ""
            stack[-1] += f" turns ({', '.join(map(str, request.turns))})" if request.turns else ""
        if kind is Type.POSE and (tag := tag_of(value)) is not None:
            stack[-1] += f" in {tag.name}"


def _item(stack: list[Datum], _values: list[Datum], operand: Datum) -> None:
    """ITEM; the operand is the list and its poses as values. The pose knows which point it is."""
    listed, poses = operand
    number = stack[-1]
    if not 0 < number <= len(poses):
        message = f"`{listed.name}` has no element {number}, it has the elements 1 to {len(poses)}"
        raise TrapError(kinds.BOUNDS, message, "elements are counted from 1")
    line = listed.lines[number - 1] if listed.lines else 0
    stack[-1] = (*poses[number - 1], ListedPoint(listed.name, number, listed.source, line))


_SI_DECIMALS = 9
"""Of lengths [m] and angles [rad] in lists: smaller ones are rounding errors."""
_DECIMALS = {Type.VEC: 6}
"""The numbers of a vector may be mm and degrees: `print` shows a location as two of them."""


def _listed(values: tuple[float, ...], decimals: int) -> str:
    return "(" + ", ".join(_number(round(part, decimals)) for part in values) + ")"


def _number(value: float) -> str:
    return format(value + 0.0, ".6g")  # -0.0 + 0.0 is 0.0


GEOMETRY: dict[str, Handler] = {
    "ADD.V": _make(2, lambda a, b: _finite("ADD.V", tuple(x + y for x, y in zip(a, b, strict=True)))),
    "SUB.V": _make(2, lambda a, b: _finite("SUB.V", tuple(x - y for x, y in zip(a, b, strict=True)))),
    "MKVEC": _make(3, lambda x, y, z: (x, y, z)),
    "MKORI.ZYX": _make(3, quaternion.from_zyx),
    "MKORI.Q": _make(4, _orientation),
    "MKPOSE": _make(2, lambda position, orientation: position + orientation),
    "MKJ": _make_joints,
    "MKEXT": _make_external,
    "ITEM": _item,
    "COMPOSE": _make(2, _compose),
    "INFRAME": in_frame,
    "AXES": with_axes,
    "OFFSET": offset,
    "POSTURE": in_posture,
    "TURNS": with_turns,
    "ORI.FREE": orientation_free,
    "REFRAME": _make(2, _reframe),
    "INV": _make(1, lambda a: _finite("INV", quaternion.invert(pose_part(a)))),
    "GETPOS": _make(1, lambda pose: pose[:3]),
    "GETORI": _make(1, lambda pose: pose[3:7]),
    "DIST": _make(2, _distance),
    "ANGLE": _make(2, _angle),
}
"""Mnemonic -> handler."""
