"""Results of each part of the control statements."""

from functools import partial

from ropsim.core import Diagnostic, frozen_dataclass
from ropsim.language.blocks.units import Part, lines_of
from ropsim.language.check import one_part
from ropsim.language.check.one_part import AnyState, CheckedPart, InferredPart, PartAlone
from ropsim.language.check.scope.fold import IDENTITY
from ropsim.language.check.scope.sight import Seen, Sight
from ropsim.language.check.scope.types import Type
from ropsim.language.check.statements.silent import words_of
from ropsim.language.questions.bodies import final_world
from ropsim.language.questions.declarations import basics, statements_of
from ropsim.language.questions.groups import Group
from ropsim.language.questions.inputs import BEFORE_CHECK, BEFORE_WALK, BLOCK, JOINT_COUNT, TYPES
from ropsim.language.questions.told import inferred
from ropsim.language.questions.walks import own_signature
from ropsim.language.questions.worlds import world_alone, world_of
from ropsim.program import Block, KnownPlace, points_from
from ropsim.query import Database
from ropsim.spatial import PoseTuple


@frozen_dataclass
class Before:
    """Context before a part.

    Attributes:
        names: meanings of the names in `mentions` of the part, None for none.
        states: evidence for open types among them, by the names of variables.
        X_KC: frame of literals, in the work frame; the identity where that frame moves.
        moving: name of the frame of literals where it moves, empty where it stands still.
        joint_count: how many coordinates `joints(…)` has, 0 as long as there is none.
        ended: name of a frame that was set in a block that has ended, while no location was read since.
    """

    names: tuple[Seen | None, ...] = ()
    states: tuple[tuple[str, AnyState], ...] = ()
    X_KC: PoseTuple = IDENTITY
    moving: str = ""
    joint_count: int = 0
    ended: str = ""


AT_FIRST = Before()
"""Nothing."""


def mentions(db: Database, unit: str) -> tuple[str, ...]:
    """Return all words of a part, among them each name that it mentions."""
    lines = lines_of(db.ask(statements_of, unit))
    words = dict.fromkeys(words_of("\n".join([line.logical.text for line in lines])))
    return tuple(dict.fromkeys((*words, *map(str.lower, words))))


def part_alone(db: Database, unit: str) -> PartAlone | None:
    """Return a part whose variables have their types at their first assignment; None for any other."""
    before: Before = db.read((BEFORE_WALK, unit))
    if before.states:
        return None
    return one_part.part_alone(world_alone(db), _part(db, unit), _sight(db, unit, before, None))


def inferred_part(db: Database, unit: str) -> InferredPart:
    """Return the inference result of a part."""
    alone = db.ask(part_alone, unit)
    if alone is not None:
        return alone.walked
    before: Before = db.read((BEFORE_WALK, unit))
    world = world_of(db, partial(own_signature, db))
    return one_part.inferred_part(world, _part(db, unit), _sight(db, unit, before, ()), dict(before.states))


def variables_of(db: Database, unit: str) -> tuple[str, ...]:
    """Return the variables that a part makes."""
    return tuple(db.ask(inferred_part, unit).types)


def checked_part(db: Database, unit: str, around: tuple[str, ...] | None) -> CheckedPart:
    """Return a part, checked.

    Args:
        db: holds the text.
        unit: of the part.
        around: names of all variables before it; None if they were not requested.
    """
    before: Before = db.read((BEFORE_CHECK, unit))
    if around is None and inferred(db) is None and _is_as_walked(db, unit, before):
        alone = db.ask(part_alone, unit)
        if alone is not None:
            return alone.checked
    sight = _sight(db, unit, before, around)
    types: tuple[tuple[str, Type | None], ...] = db.read((TYPES, unit))
    known = {name: kind for name, kind in types if kind is not None}
    return one_part.checked_part(final_world(db), _part(db, unit), sight, known)


def _is_as_walked(db: Database, unit: str, before: Before) -> bool:
    """Return whether a part sees before it the same context as in the inference pass."""
    if not before.joint_count and db.read(JOINT_COUNT) != db.ask(basics).joint_count:
        return False
    on_walk: Before = db.read((BEFORE_WALK, unit))
    return before == on_walk


def walked_in(db: Database, group: Group) -> int:
    """Infer the types of a group of parts; return their number."""
    return len([db.ask(inferred_part, unit) for unit in group])


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
    return Sight(names, before.X_KC, before.moving, before.joint_count, before.ended, around)
