"""Inference result of a body."""

from collections.abc import Mapping

from ropsim.core import frozen_dataclass
from ropsim.language.check.scope.body import Body, settled
from ropsim.language.check.scope.types import Type, is_untold
from ropsim.language.check.scope.world import Formal, Signature
from ropsim.language.questions.inputs import INFERRED
from ropsim.query import Database


@frozen_dataclass
class Walked:
    """Inference result of a body.

    Attributes:
        formals: types of its parameters.
        types: of all its variables.
        joint_count: how many coordinates `joints(…)` has in it.
        lacks_result: whether it returns a value for which its header has no type.
        untold: parameters whose types neither header nor body determine.
    """

    formals: tuple[Type, ...]
    types: Mapping[str, Type]
    joint_count: int
    lacks_result: bool
    untold: tuple[str, ...] = ()


@frozen_dataclass
class Inferred:
    """Inference result of all bodies, if use in one determines types in another."""

    bodies: Mapping[str, Walked]
    variables: Mapping[str, Type]


def inferred(db: Database) -> Inferred | None:
    """Return the inference result of all bodies; None if each determines its own types."""
    found: Inferred | None = db.read(INFERRED)
    return found


def told(body: Body, called: Signature | None) -> Walked:
    """Return the inference result of a body, and its signature in that pass."""
    formals: tuple[Formal, ...] = called.formals if called is not None else ()
    types = tuple(settled(one.type) for one in formals)
    untold = tuple(one.name for one in formals if is_untold(one.type))
    return Walked(types, body.types(), body.joint_count, body.lacks_result, untold)
