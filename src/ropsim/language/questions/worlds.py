"""Context of a body while types are unknown."""

from collections.abc import Callable, Container, Mapping
from dataclasses import replace

from ropsim.language.check.one_part import InferredElsewhereError
from ropsim.language.check.scope.table import Marked, Table
from ropsim.language.check.scope.types import is_open, opened
from ropsim.language.check.scope.world import Signature, Symbol, TaskOrigins, Variable, World
from ropsim.language.questions.callers import alike, all_tasks, is_own, library
from ropsim.language.questions.declarations import basics, declared_symbol, frame, names_in, tool, untyped
from ropsim.query import Database

NOTHING_TOLD: Mapping[str, TaskOrigins] = {}
"""Origins of plain numbers in tasks while types are unknown."""


def world_of(db: Database, called: Callable[[str], Signature | None]) -> World:
    """Return the world as a body sees it while types are not known."""
    return world_with(db, called, open_symbols(db), frozenset(), db.ask(basics).joint_count)


def world_alone(db: Database) -> World:
    """Return the world for a part whose types no other body determines.

    It raises `InferredElsewhereError` if the part reads a task, or at a variable of open type.
    """

    def called(name: str) -> Signature | None:
        if db.ask(is_own, name) or db.ask(library, name) is not None:
            raise InferredElsewhereError
        return None

    def symbol_of(name: str) -> Symbol | None:
        found = db.ask(declared_symbol, name)
        if isinstance(found, Variable) and is_open(found.type):
            raise InferredElsewhereError
        return found

    symbols: Table[Symbol] = Table(symbol_of, lambda: db.ask(names_in, "symbols"))
    return world_with(db, called, symbols, frozenset(), db.ask(basics).joint_count)


def open_symbols(db: Database) -> Table[Symbol]:
    """Return the global meanings of names, variables of open type with cells of their own."""

    def symbol_of(name: str) -> Symbol | None:
        found = db.ask(declared_symbol, name)
        return of_body(found) if found is not None else None

    return Table(symbol_of, lambda: db.ask(names_in, "symbols"))


def world_with(
    db: Database,
    called: Callable[[str], Signature | None],
    symbols: Table[Symbol],
    without_result: Container[str],
    joint_count: int,
    origins: Mapping[str, TaskOrigins] = NOTHING_TOLD,
) -> World:
    """Return the world for a body with these inputs."""
    text = db.ask(basics)
    return World(  # thousands of times in a text: field by field, as `replace` takes three times as long
        text.environment,
        text.units,
        text.is_strict,
        text.is_classic,
        text.frame,
        text.X_BK,
        Table(lambda name: db.ask(frame, name), lambda: db.ask(names_in, "frames")),
        Table(lambda name: db.ask(tool, name), lambda: db.ask(names_in, "tools")),
        symbols,
        text.has_axes,
        Table(called, lambda: all_tasks(db)),
        without_result,
        joint_count,
        db.ask(untyped),
        Marked(lambda name: db.ask(is_own, name)),
        Table(lambda lower: db.ask(alike, lower) or None, tuple),
        origins,
    )


def of_body(found: Symbol) -> Symbol:
    """Return a symbol as one body sees it: a variable of open type with a cell of its own."""
    return replace(found, type=opened(found.type)) if isinstance(found, Variable) else found
