"""How the kinds of blocks differ: their fields in a file, and what checks and wiring ask of them."""

from collections.abc import Callable, Iterable
from enum import Enum, Flag, StrEnum, auto
from typing import Any, TypeAlias

from ropsim.blockdiagram.blocks import Block
from ropsim.blockdiagram.discrete import Filter
from ropsim.core import frozen_dataclass


class FieldKind(Enum):
    """Type of a field in a file, where it is not an enumeration."""

    REAL = "number"
    REALS = "numbers"
    OPTIONAL_REALS = "numbers or nothing"
    MATRIX = "matrix"
    INTEGER = "whole number"
    INTEGERS = "whole numbers"


Kind: TypeAlias = FieldKind | type[StrEnum]


class Trait(Flag):
    """What a kind of block does with sizes and units.

    Inputs and output of an `ELEMENTWISE` block have equal sizes, those of one that `KEEPS_UNITS` equal units.
    """

    NONE = 0
    ELEMENTWISE = auto()
    KEEPS_UNITS = auto()


def _no_faults(block: Block) -> Iterable[str]:
    del block
    return ()


def _at_once(block: Block) -> bool:
    del block
    return True


@frozen_dataclass
class BlockForm:
    """A kind of block.

    Attributes:
        entity: of the schema.
        block: record.
        fields: names and types of its own fields, in the order of the schema.
        traits: of its inputs and output.
        inputs: least and greatest number of inputs.
        whole: fields with lists of numbers that do not belong to elements.
        faults: says of a block what its numbers, each finite, must not be.
        at_once: whether an output depends on inputs at the same tick; that of a filter follows from it.
        filter: of a block that filters each element, which needs no code of its own; None for all others.
    """

    entity: str
    block: type[Block]
    fields: tuple[tuple[str, Kind], ...] = ()
    traits: Trait = Trait.NONE
    inputs: tuple[int, int] = (1, 1)
    whole: tuple[str, ...] = ()
    faults: Callable[[Any], Iterable[str]] = _no_faults
    at_once: Callable[[Any], bool] = _at_once
    filter: Callable[[Any], Filter] | None = None
