"""What is found in each part of the control statements."""

from functools import partial

from ropsim.core import Diagnostic, frozen_dataclass
from ropsim.language.check import one_part
from ropsim.language.check.fold import IDENTITY
from ropsim.language.check.one_part import AnyState, CheckedPart, WalkedPart
from ropsim.language.check.sight import Seen, Sight
from ropsim.language.check.silent import words_of
from ropsim.language.check.types import Type
from ropsim.language.questions.bodies import final_world
from ropsim.language.questions.declarations import statements_of
from ropsim.language.questions.groups import Group
from ropsim.language.questions.inputs import BEFORE_CHECK, BEFORE_WALK, BLOCK, TYPES
from ropsim.language.questions.told import inferred
from ropsim.language.questions.walks import own_signature
from ropsim.language.questions.worlds import world_of
from ropsim.language.units import Part, lines_of
from ropsim.program import Block, KnownPlace, points_from
from ropsim.query import Database
from ropsim.spatial import PoseTuple


@frozen_dataclass
class Before:
    """What stands before a part.

    Attributes:
        names: what is known of the names that `mentions` tells of the part, None for nothing.
        states: what is known of open types among them, by the names of variables.
        X_KC: frame of literals, in the work frame; the identity where that frame moves.
        moving: name of the frame of literals where it moves, empty where it stands still.
        joint_count: how many coordinates `joints(…)` has, 0 as long as there is none.
    """

    names: tuple[Seen | None, ...] = ()
    states: tuple[tuple[str, AnyState], ...] = ()
    X_KC: PoseTuple = IDENTITY
    moving: str = ""
    joint_count: int = 0


AT_FIRST = Before()
"""Nothing."""


def mentions(db: Database, unit: str) -> tuple[str, ...]:
    """Return all words of a part, among them each name that it mentions."""
    found: dict[str, None] = {}
    for line in lines_of(db.ask(statements_of, unit)):
        for word in words_of(line.logical.text):
            if word not in found:
                found[word] = None
                found[word.lower()] = None
    return tuple(found)


def walked_part(db: Database, unit: str) -> WalkedPart:
    """Return what a part tells of types when it is looked at silently."""
    before: Before = db.read((BEFORE_WALK, unit))
    world = world_of(db, partial(own_signature, db))
    return one_part.walked_part(world, _part(db, unit), _sight(db, unit, before, ()), dict(before.states))


def variables_of(db: Database, unit: str) -> tuple[str, ...]:
    """Return the variables that a part makes."""
    return tuple(db.ask(walked_part, unit).types)


def checked_part(db: Database, unit: str, around: tuple[str, ...] | None) -> CheckedPart:
    """Return a part, checked.

    Args:
        db: holds the text.
        unit: of the part.
        around: names of all variables before it; None where nobody has asked for them.
    """
    sight = _sight(db, unit, db.read((BEFORE_CHECK, unit)), around)
    types: tuple[tuple[str, Type | None], ...] = db.read((TYPES, unit))
    known = {name: kind for name, kind in types if kind is not None}
    return one_part.checked_part(final_world(db), _part(db, unit), sight, known)


def walked_in(db: Database, group: Group) -> int:
    """Look at a group of parts silently; return how many there are."""
    return len([db.ask(walked_part, unit) for unit in group])


def checked_in(db: Database, group: Group) -> int:
    """Check a group of parts that need no names of variables around them; return how many there are."""
    makes = variables_of if inferred(db) is None else mentions
    for unit in group:
        db.ask(makes, unit)
        db.ask(checked_part, unit, None)
    return len(group)


def points(
    db: Database, unit: str, place: KnownPlace | None
) -> tuple[tuple[Diagnostic, ...], KnownPlace | None]:
    """Return arcs and curves of a part whose points make none, and where it ends if it begins at a place."""
    block: Block = db.read((BLOCK, unit))
    return points_from(block, place)


def _part(db: Database, unit: str) -> Part:
    return Part(unit, db.ask(statements_of, unit))


def _sight(db: Database, unit: str, before: Before, around: tuple[str, ...] | None) -> Sight:
    pairs = zip(db.ask(mentions, unit), before.names, strict=False)
    names = {name: one for name, one in pairs if one is not None}
    return Sight(names, before.X_KC, before.moving, before.joint_count, around)
