"""Expressions at random, over the names in sight."""

from dataclasses import dataclass, field
from random import Random

from support.programs.nodes import PLACE, Expr
from support.programs.numbers import MM, TrapError
from support.programs.values import TooLongError, constant

_WHOLES = (0, 1, 2, 3, 5, 7, 10, 1_000_000_000_000)
_NUMBERS = ("0.0", "0.5", "1.5", "2.5", "0.25", "3.0", "0.1", "90.0", "1e-9", "1e12", "0.49999999999999994")
_LENGTHS = ("0", "1", "5", "12.5", "100")
_COMPARE = ("=", "==", "<>", "<", "<=", ">", ">=")


@dataclass(slots=True)
class Sight:
    """What an expression may name.

    Attributes:
        names: kinds of variables.
        constants: declared ones, as literals whose text is their name.
        counters: names of open loops over patterns.
        references: how many reference locations there are.
    """

    names: dict[str, str] = field(default_factory=dict)
    constants: list[Expr] = field(default_factory=list)
    counters: list[str] = field(default_factory=list)
    references: int = 0

    def of(self, kind: str) -> list[str]:
        """Return the variables of a kind."""
        return [name for name, one in self.names.items() if one == kind]


def literal(random: Random, kind: str) -> Expr:
    """Return a value as it is written."""
    if kind == "int":
        value = random.choice(_WHOLES)
        return Expr("literal", kind, text=str(value), value=value)
    if kind == "num":
        text = random.choice(_NUMBERS)
        return Expr("literal", kind, text=text, value=float(text))
    if kind == "bool":
        truth = random.random() < 0.5
        return Expr("literal", kind, text="true" if truth else "false", value=truth)
    text = random.choice(_LENGTHS)
    return Expr("literal", kind, text=f"{text} mm", value=float(text) * MM)


def place(random: Random) -> Expr:
    """Return a location as three numbers, some with a turn."""
    numbers = tuple(literal(random, "length") for _ in range(3))
    if random.random() < 0.3:
        turn = Expr("literal", "num", text="30.0", value=30.0)
        return Expr("location", "loc", (*numbers, turn), text=random.choice(("rx", "ry", "rz")))
    return Expr("location", "loc", numbers)


def made(random: Random, sight: Sight, kind: str, depth: int) -> Expr:
    """Return an expression of a kind; where the compiler can know its value, it has one."""
    for _ in range(20):
        found = _made(random, sight, kind, depth)
        if found.kind == "loc" or _is_right(found):
            return found
    return literal(random, kind)


def _is_right(one: Expr) -> bool:
    """Return whether no part that the compiler computes traps, which it would refuse, or lies too far."""
    divides = one.op in ("/", "mod") and one.parts[1].is_constant
    try:
        if one.is_constant or divides:
            value = constant(one.parts[1] if divides and not one.is_constant else one)
            return not (divides and value == 0)
    except (TrapError, TooLongError):
        return False
    return True


def _made(random: Random, sight: Sight, kind: str, depth: int) -> Expr:
    if depth <= 0 or random.random() < 0.15:
        return _leaf(random, sight, kind)
    makers = {"loc": _location, PLACE: _read, "bool": _condition, "int": _whole, "length": _length}
    return makers.get(kind, _number)(random, sight, depth)


def _whole(random: Random, sight: Sight, depth: int) -> Expr:
    op = random.choice(("+", "-", "*", "mod", "min", "max", "neg", "abs", "round", "trunc"))
    if op in ("round", "trunc"):
        return Expr(op, "int", (made(random, sight, "num", depth - 1),))
    count = 1 if op in ("neg", "abs") else 2
    return Expr(op, "int", tuple(made(random, sight, "int", depth - 1) for _ in range(count)))


def _length(random: Random, sight: Sight, depth: int) -> Expr:
    op = random.choice(("+", "-", "*", "/", "neg", "abs", "min", "max", "as mm", "mod", "more mm"))
    first = made(random, sight, "num" if op == "as mm" else "length", depth - 1)
    if op in ("neg", "abs", "as mm"):
        return Expr(op, "length", (first,))
    if op == "more mm":
        return Expr(op, "length", (first, literal(random, random.choice(("int", "num")))))
    second = random.choice(("num", "int")) if op in ("*", "/") else "length"
    return Expr(op, "length", (first, made(random, sight, second, depth - 1)))


def _leaf(random: Random, sight: Sight, kind: str) -> Expr:
    names = sight.of(kind)
    if kind == "int" and sight.counters and random.random() < 0.3:
        name = f"{random.choice(sight.counters)}.{random.choice(('row', 'col', 'layer'))}"
        return Expr("name", kind, text=name)
    constants = [one for one in sight.constants if one.kind == kind]
    if constants and random.random() < 0.3:
        return random.choice(constants)
    if kind == "bool" and random.random() < 0.1:
        return Expr("signal", kind, text="part_ok")
    if kind == "loc" and random.random() < 0.2:
        return Expr("here", kind, text="here")
    if names and random.random() < 0.75:
        return Expr("name", kind, text=random.choice(names))
    if kind == "loc":
        return Expr("name", kind, text="infeed") if random.random() < 0.3 else place(random)
    return literal(random, kind)


def _number(random: Random, sight: Sight, depth: int) -> Expr:
    def part(one: str) -> Expr:
        return made(random, sight, one, depth - 1)

    op = random.choice(
        ("+", "-", "*", "/", "mod", "min", "max", "neg", "abs", "sqrt", "sin", "cos", "tan", "asin", "acos",
         "atan2", "per mm", "/ length")
    )  # fmt: skip
    if op == "per mm":
        return Expr(op, "num", (part("length"),))
    if op == "/ length":
        return Expr("/", "num", (part("length"), part("length")))
    if op in ("neg", "abs", "sqrt", "sin", "cos", "tan", "asin", "acos"):
        return Expr(op, "num", (part("num"),))
    if op == "/":
        return Expr(op, "num", (part(random.choice(("int", "num"))), part(random.choice(("int", "num")))))
    pair = [part("num"), part(random.choice(("int", "num")))]
    random.shuffle(pair)
    return Expr(op, "num", (pair[0], pair[1]))


def _condition(random: Random, sight: Sight, depth: int) -> Expr:
    op = random.choice(("and", "or", "not", "compare", "compare", "compare", "same"))
    if op == "not":
        return Expr(op, "bool", (made(random, sight, "bool", depth - 1),))
    kind = "bool" if op != "compare" else random.choice(("int", "num", "length"))
    sign = op if op in ("and", "or") else random.choice(_COMPARE if op == "compare" else ("=", "==", "<>"))
    return Expr(sign, "bool", (made(random, sight, kind, depth - 1), made(random, sight, kind, depth - 1)))


def _read(random: Random, sight: Sight, depth: int) -> Expr:
    op = random.choice(("of", "of", "dist", "+", "- ", "min"))
    if op == "of":
        return Expr(op, PLACE, (_leaf(random, Sight(sight.names), "loc"),), text=random.choice("xyz"))
    if op == "dist":
        return Expr(op, PLACE, (_location(random, sight, depth - 1), _location(random, sight, depth - 1)))
    pair = (made(random, sight, PLACE, depth - 1), made(random, sight, "length", depth - 1))
    return Expr(op.strip(), PLACE, pair)


def written_place(random: Random) -> Expr:
    """Return a location in numbers that the compiler knows, of any sort."""
    numbers = tuple(literal(random, "length") for _ in range(3))
    model = Expr("name", "loc", text="infeed")
    return _oriented(random, random.choice(("location", "polar", "like")), numbers, model)


def _oriented(random: Random, op: str, numbers: tuple[Expr, ...], model: Expr) -> Expr:
    """Return a location of three numbers with the orientation of its sort."""
    if op == "polar":
        angles = (
            Expr("literal", "num", text=str(n), value=n) for n in random.choices((90.0, 30.0, 0.0), k=2)
        )
        return Expr(op, "loc", (*numbers, *angles))
    return Expr(op, "loc", (*numbers, model) if op == "like" else numbers)


def _location(random: Random, sight: Sight, depth: int) -> Expr:
    if depth <= 0:
        return _leaf(random, sight, "loc")
    op = random.choice(("location", "polar", "like", "above", "offset", "rel", "in", "in", "offset"))
    way = random.choice(("length", "length", PLACE))
    if op in ("location", "polar", "like"):
        numbers = tuple(made(random, sight, way, depth - 1) for _ in range(3))
        return _oriented(random, op, numbers, _leaf(random, sight, "loc"))
    base = _location(random, sight, depth - 1)
    if op == "in":
        return Expr(op, "loc", (base,), text=random.choice(("base", "pallet", "shelf", "tilted")))
    count = 1 if op == "above" else 3
    return Expr(op, "loc", (base, *(made(random, sight, way, depth - 1) for _ in range(count))))
