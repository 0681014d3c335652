"""Catalogue of the part library: kinds of parts by name, and parts made of them."""

from collections.abc import Mapping
from types import MappingProxyType

from ropsim.parts.belt_conveyor import BELT_CONVEYOR
from ropsim.parts.diagnostics import CONFLICTING_MEASURES, PartValueError, UnknownPartError
from ropsim.parts.fence import FENCE
from ropsim.parts.flange import FLANGE
from ropsim.parts.pallet import EUR_PALLET
from ropsim.parts.part_kind import LibraryPart, PartKind, Use
from ropsim.parts.roller_conveyor import ROLLER_CONVEYOR
from ropsim.parts.table import TABLE
from ropsim.parts.turntable import TURNTABLE
from ropsim.parts.two_finger_gripper import TWO_FINGER_GRIPPER
from ropsim.parts.vacuum_gripper import VACUUM_GRIPPER
from ropsim.parts.words import beyond_words, conflict_words

PART_KINDS: Mapping[str, PartKind] = MappingProxyType(
    {
        kind.name: kind
        for kind in (
            TWO_FINGER_GRIPPER,
            VACUUM_GRIPPER,
            FLANGE,
            BELT_CONVEYOR,
            ROLLER_CONVEYOR,
            TURNTABLE,
            FENCE,
            EUR_PALLET,
            TABLE,
        )
    }
)
"""Every kind of part; another one is a file and an entry."""


def kinds_for(use: Use) -> tuple[PartKind, ...]:
    """Return the kinds for one table of a cell file."""
    return tuple(kind for kind in PART_KINDS.values() if kind.use is use)


def part_kind(name: str) -> PartKind:
    """Return the kind of a name.

    Raises:
        UnknownPartError: X925, no kind has this name.
    """
    if name not in PART_KINDS:
        raise UnknownPartError("kind of part", name, PART_KINDS)
    return PART_KINDS[name]


def library_part(kind: str, model: str = "", **values: float) -> LibraryPart:
    """Return a part of the library.

    Args:
        kind: its kind, such as `two_finger_gripper`.
        model: its product, such as `franka_hand`; empty for the defaults of the kind.
        **values: of parameters, in place of the values of the product [SI].

    Raises:
        UnknownPartError: X925, no kind, model or parameter has this name.
        PartValueError: X924, a value is outside its range, or two of them do not fit together.
    """
    found = part_kind(kind)
    product = found.product(model)
    if model and product is None:
        raise UnknownPartError(f"model of `{kind}`", model, (one.name for one in found.products))
    known = {one.name: one for one in found.parameters}
    for name, value in values.items():
        if name not in known:
            raise UnknownPartError(f"parameter of `{kind}`", name, known)
        if not known[name].allows(value):
            raise PartValueError(CONFLICTING_MEASURES.at(None, beyond_words(kind, known[name], value)))
    complete = found.defaults(product) | values
    conflict = found.conflict(complete)
    if conflict is not None:
        shown = [f"{complete[one.name]:g}" for one in conflict]
        words, hint = conflict_words(f"{conflict[0].name}` of `{kind}", conflict, shown)
        raise PartValueError(CONFLICTING_MEASURES.at(None, f"{words}, in SI units", hint=hint))
    return found.make(complete)
