"""The values of variables and expressions, as the manual says."""

import math
from collections.abc import Mapping
from dataclasses import dataclass, field, replace

from support.programs import places
from support.programs.nodes import PLACE, Expr
from support.programs.numbers import DEGREE, REAL, TRUTH, WHOLE, Number
from support.programs.places import ARM, BASE, FRAMES, INFEED, Place

Datum = Number | Place
LEAST = 1e-5
"""Nearer to the axis of the base than this the azimuth of a point is a matter of rounding [m]."""
FAR = 1e3
"""Where a pose is no longer exact to `agreement.PLACES` [m]."""
AXES = {"x": 0, "y": 1, "z": 2}
_ZERO: dict[str, Datum] = {"int": 0, "num": 0.0, "length": 0.0, PLACE: 0.0, "bool": False}


class TooLongError(Exception):
    """The program goes on for longer than it is followed, or farther away than rounding allows."""


@dataclass(slots=True)
class Scope:
    """The variables of a task or of the control statements, those of open loops, and the frame in force."""

    own: dict[str, Datum]
    loops: list[dict[str, Datum]] = field(default_factory=list)
    counting: list[str] = field(default_factory=list)
    frame: Place = BASE


def constant(one: Expr) -> Number:
    """Return the value of an expression without variables.

    Raises:
        TrapError: it has none.
    """
    return Values({}).number(Scope({}), one)


class Values:
    """What expressions are worth.

    Attributes:
        inputs: the inputs of the cell.
        shared: variables that all tasks see, and those of the control statements.
        fixed: locations that the program declares.
        here: where the arm stands.
    """

    def __init__(self, inputs: Mapping[str, bool]) -> None:
        self.inputs = inputs
        self.shared: dict[str, Datum] = {}
        self.fixed: dict[str, Place] = {}
        self.here = ARM["home"]

    def store(self, scope: Scope, name: str, value: Datum) -> None:
        around = next((loop for loop in reversed(scope.loops) if name in loop), None)
        known = around if around is not None else scope.own
        if name not in known and name in self.shared:
            known = self.shared
        known[name] = _like(known.get(name), _near(value) if isinstance(value, Place) else value)

    def value(self, scope: Scope, one: Expr) -> Datum:
        return self.place(scope, one) if one.kind == "loc" else self.number(scope, one)

    def find(self, scope: Scope, one: Expr, name: str) -> Datum:
        for names in (*reversed(scope.loops), scope.own, self.shared):
            if name in names:
                return names[name]
        return _ZERO[one.kind]

    def number(self, scope: Scope, one: Expr) -> Number:
        if one.op == "literal":
            return one.value
        if one.op in ("name", "counter"):
            found = self.find(scope, one, one.text)
            assert not isinstance(found, Place)
            return found
        if one.op == "signal":
            return self.inputs[one.text]
        if one.op == "of":
            return places.seen(self.place(scope, one.parts[0]), scope.frame).at[AXES[one.text]]
        if one.op == "dist":
            a, b = (self.place(scope, part).at for part in one.parts)
            return math.dist(a, b)
        values = [self.number(scope, part) for part in one.parts]
        if one.op == "not":
            return not values[0]
        is_whole = all(part.kind == "int" for part in one.parts)
        if one.op in TRUTH:
            is_exact = is_whole or one.parts[0].kind == "bool"
            return TRUTH[one.op](*(part if is_exact else float(part) for part in values))
        return WHOLE[one.op](*values) if is_whole and one.op in WHOLE else _real(one, values)

    def place(self, scope: Scope, one: Expr) -> Place:
        return _near(self.found_place(scope, one))

    def found_place(self, scope: Scope, one: Expr) -> Place:
        if one.op == "name":
            known = {"infeed": INFEED, **self.fixed}
            found = known[one.text] if one.text in known else self.find(scope, one, one.text)
            assert isinstance(found, Place)
            return found
        if one.op == "reference":
            return self.place(scope, Expr("name", "loc", text="l" if one.text == "1" else f"l{one.text}"))
        if one.op == "here":
            return replace(self.here, axes=scope.frame.turn)
        if one.op == "in" and one.parts[0].is_written:
            return self.place(replace(scope, frame=FRAMES[one.text]), one.parts[0])
        numbers = [float(self.number(scope, part)) for part in one.parts if part.kind != "loc"]
        if one.op == "location":
            turn = places.rotation(one.text, numbers[3] * DEGREE) if len(numbers) > 3 else places.DOWN
            return places.read_in(Place(turn, (numbers[0], numbers[1], numbers[2])), scope.frame)
        if one.op == "polar":
            return _polar(numbers, scope.frame)
        if one.op == "like":
            at = places.read_in(Place(places.DOWN, (numbers[0], numbers[1], numbers[2])), scope.frame)
            return replace(at, turn=self.place(scope, one.parts[3]).turn)
        base = self.place(scope, one.parts[0])
        if one.op == "in":
            return places.read_in(places.seen(base, scope.frame), FRAMES[one.text])
        if one.op == "above":
            way = places.turned(base.turn, (0.0, 0.0, -numbers[0]))
        else:
            axes = base.turn if one.op == "rel" else base.axes
            way = places.turned(axes, (numbers[0], numbers[1], numbers[2]))
        return replace(base, at=places.added(base.at, way))


def _real(one: Expr, values: list[Number]) -> Number:
    found = REAL[one.op](*map(float, values))
    return found if one.kind == "int" else float(found)


def _polar(numbers: list[float], frame: Place) -> Place:
    """Return the location of x, y, z, pitch, roll: the azimuth is that of the point in the base frame."""
    there = places.read_in(Place(places.DOWN, (numbers[0], numbers[1], numbers[2])), frame)
    if math.hypot(there.at[0], there.at[1]) < LEAST:
        raise TooLongError
    turn = places.rotation("rz", math.atan2(there.at[1], there.at[0]))
    for axis, angle in (("ry", numbers[3] * DEGREE), ("rx", numbers[4] * DEGREE), ("ry", math.pi / 2.0)):
        turn = places.product(turn, places.rotation(axis, angle))
    return replace(there, turn=turn)


def _near(place: Place) -> Place:
    if max(map(abs, place.at)) > FAR:
        raise TooLongError
    return place


def _like(old: Datum | None, value: Datum) -> Datum:
    """Return a value as the type that a variable has: a whole number widens to a real one."""
    return float(value) if isinstance(old, float) and type(value) is int else value
