"""Declared meaning of a name, which a variable, a parameter or another declaration cannot take."""

from ropsim.language.check.scope.types import POSE, Value, known
from ropsim.language.check.scope.world import Listed, Pattern, Poison, Symbol, Variable, World
from ropsim.language.environment import Environment
from ropsim.program import SignalUse, ValueType


def what(symbol: Symbol) -> str:
    """Return the kind of entity behind a name, with its article."""
    match symbol:
        case SignalUse(is_input=is_input, type=kind):
            return f"an {'analog ' if kind is ValueType.REAL else ''}{'input' if is_input else 'output'}"
        case Pattern():
            return "a pattern"
        case Listed():
            return "a list of points"
        case Value(type=kind):
            return "a location" if known(kind) == POSE else "a constant"
    return "a variable"


def declared_as(world: World, name: str) -> str:
    """Return the entity, no variable, that cell or text declare by a name; empty if there is none."""
    symbol = world.symbols.get(name)
    if symbol is not None and not isinstance(symbol, Variable | Poison):
        return what(symbol)
    if name in world.frames:
        return "a frame"
    if name in world.tools:
        return "a tool"
    return "a task" if name in world.own else ""


def hidden_by_parameter(world: World, name: str) -> str:
    """Return the entity that a parameter would hide, variables of all tasks included; empty if none."""
    if isinstance(world.symbols.get(name), Variable):
        return "a variable"
    return declared_as(world, name)


def in_cell(environment: Environment, name: str) -> str:
    """Return the entity of the cell with a name, empty if there is none."""
    if name in environment.frames:
        return "a frame"
    if name in environment.tools:
        return "a tool"
    if name in environment.locations:
        return "a location"
    if name in environment.lists:
        return "a list of points"
    signal = environment.signals.get(name)
    return what(signal) if signal is not None else ""
