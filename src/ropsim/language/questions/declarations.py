"""Declarations of the text outside tasks, name by name."""

from collections.abc import Iterator
from dataclasses import replace

from ropsim.language.blocks.units import CONTROL, Items, Part
from ropsim.language.check import declarations
from ropsim.language.check.declarations import Declared
from ropsim.language.check.scope import fold
from ropsim.language.check.scope.table import Marked
from ropsim.language.check.scope.types import is_open
from ropsim.language.check.scope.units import UnitSystem
from ropsim.language.check.scope.world import Symbol, Variable, World
from ropsim.language.cutting.reading import CALLABLE, Names
from ropsim.language.environment import Environment
from ropsim.language.questions.callers import is_own
from ropsim.language.questions.groups import Group, part_groups
from ropsim.language.questions.inputs import DECLARED, ENVIRONMENT, LISTS, PART, PARTS
from ropsim.language.questions.told import inferred
from ropsim.language.report import Report, TooManyFindingsError
from ropsim.language.syntax.text import Line
from ropsim.query import Database
from ropsim.spatial import PoseTuple


def declared(db: Database) -> Declared:
    """Return the declarations of the text outside tasks."""
    environment: Environment = replace(db.read(ENVIRONMENT), lists=db.read(LISTS))
    report = Report(CONTROL)
    try:
        own = Marked(lambda name: db.ask(is_own, name))
        parts = tuple(_declaring_parts(db))
        return declarations.world(parts, environment, report, Names(db, CALLABLE), own)
    except TooManyFindingsError:
        return Declared(_nothing(environment), tuple(report.log))


def _declaring_parts(db: Database) -> Iterator[Part]:
    """Yield possible declarations, and all items up to the first one that is none."""
    is_above = True
    for group in db.ask(part_groups):
        if not is_above:
            yield from db.ask(declaring_in, group)
            continue
        for unit in group:
            items = db.ask(declaring_above if is_above else declaring, unit)
            is_above = is_above and db.ask(stands_above, unit)
            if items:
                yield Part(unit, items)


def declaring_in(db: Database, group: Group) -> tuple[Part, ...]:
    """Return the possible declarations in a group of parts."""
    found = ((unit, db.ask(declaring, unit)) for unit in group)
    return tuple(Part(unit, items) for unit, items in found if items)


def declaring(db: Database, unit: str) -> Items:
    """Return the items of a part that may declare something."""
    return tuple(item for item in db.read((PART, unit)) if declarations.may_declare(item))


def declaring_above(db: Database, unit: str) -> Items:
    """Return the items of a part that may declare something, and all up to the first one that does not."""
    items: Items = db.read((PART, unit))
    first = next((k for k, item in enumerate(items) if not declarations.may_stand_above(item)), len(items))
    rest = (item for item in items[first + 1 :] if declarations.may_declare(item))
    return (*items[: first + 1], *rest)


def stands_above(db: Database, unit: str) -> bool:
    """Return whether all items of a part may stand above the choice of the work frame."""
    return all(map(declarations.may_stand_above, db.read((PART, unit))))


def _nothing(environment: Environment) -> World:
    system = UnitSystem(environment.length, environment.angle)
    return World(
        environment,
        system,
        is_strict=False,
        is_classic=False,
        frame="",
        X_BK=fold.IDENTITY,
        frames={},
        tools={},
    )


def _declared(db: Database) -> Declared:
    found: Declared = db.read(DECLARED)
    return found


def basics(db: Database) -> World:
    """Return the data of the whole text, without any names."""
    return replace(_declared(db).world, frames={}, tools={}, symbols={})


def frame(db: Database, name: str) -> PoseTuple | None:
    """Return a frame."""
    return _declared(db).world.frames.get(name)


def tool(db: Database, name: str) -> PoseTuple | None:
    """Return a tool."""
    return _declared(db).world.tools.get(name)


def declared_symbol(db: Database, name: str) -> Symbol | None:
    """Return the declared meaning of a name; the type of a variable may be open."""
    return _declared(db).world.symbols.get(name)


def names_in(db: Database, table: str) -> tuple[str, ...]:
    """Return the names of all `frames`, `tools` or `symbols`."""
    return tuple(getattr(_declared(db).world, table))


def untyped(db: Database) -> frozenset[str]:
    """Return the variables declared without a type, whose types only use determines."""
    symbols = _declared(db).world.symbols.items()
    return frozenset(name for name, one in symbols if isinstance(one, Variable) and is_open(one.type))


def symbol(db: Database, name: str) -> Symbol | None:
    """Return the global meaning of a name; the types of variables are known."""
    found = db.ask(declared_symbol, name)
    if isinstance(found, Variable) and is_open(found.type):
        types = inferred(db)
        assert types is not None
        return replace(found, type=types.variables[name])
    return found


def statements(db: Database) -> Items:
    """Return the control statements without the declarations among them."""
    return tuple(item for unit in db.read(PARTS) for item in db.ask(statements_of, unit))


def statements_of(db: Database, unit: str) -> Items:
    """Return a part of them without the declarations."""
    return tuple(
        item
        for item in db.read((PART, unit))
        if not isinstance(item, Line) or type(item.statement) not in declarations.WITHOUT_CODE
    )
