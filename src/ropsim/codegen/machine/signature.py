"""The arguments of a compiled function: arrays of float64 without gaps, whole numbers, floats and records."""

from collections.abc import Callable
from itertools import count
from typing import Annotated, Any, get_args, get_origin, get_type_hints

import numpy as np
import numpy.typing as npt

from ropsim.core import frozen_dataclass


@frozen_dataclass
class Axes:
    """The number of axes of an array, as a note of its annotation."""

    count: int


Array1 = Annotated[npt.NDArray[np.float64], Axes(1)]
"""An array of float64 without gaps, shape (n,)."""
Array2 = Annotated[npt.NDArray[np.float64], Axes(2)]
"""The same with two axes, shape (n, m)."""
Array3 = Annotated[npt.NDArray[np.float64], Axes(3)]
"""The same with three axes, shape (n, m, k)."""

WHOLE, REAL = 0, -1
"""The kinds of a whole number and of a float; that of an array is the number of its axes."""


@frozen_dataclass
class Record:
    """The kind of a named tuple.

    Attributes:
        made_by: its class.
        kinds: of its fields.
    """

    made_by: type[tuple[Any, ...]]
    kinds: "tuple[Kind, ...]"


Kind = int | Record
"""The kind of an argument: number of axes of an array, `WHOLE`, `REAL` or a record."""
_WORDS = {"f8[::1]": 1, "f8[:,::1]": 2, "f8[:,:,::1]": 3, "i8": WHOLE, "f8": REAL}


@frozen_dataclass
class Signature:
    """The arguments of a compiled function, which returns nothing.

    Attributes:
        kinds: one for each argument.
    """

    kinds: tuple[Kind, ...]

    @classmethod
    def parse(cls, text: str) -> "Signature":
        """Return the signature of a text such as `void(f8[:,::1], i8)`, as numba writes it.

        Raises:
            ValueError: the function returns something, or takes an unsupported argument.
        """
        head, _, rest = text.partition("(")
        words = rest.removesuffix(")").replace(" ", "").replace("],", "];").replace("8,", "8;")
        arguments = tuple(filter(None, words.split(";")))
        if head != "void" or not set(arguments) <= set(_WORDS):
            raise ValueError(f"`{text}` is not void(…) of {', '.join(_WORDS)}")
        return cls(tuple(_WORDS[one] for one in arguments))

    @classmethod
    def of(cls, function: Callable[..., None]) -> "Signature":
        """Return the signature that the annotations of a function state.

        They are `int`, `float`, `Array1`, `Array2`, `Array3`, or a `NamedTuple` class of these and of other
        classes of this kind.

        Raises:
            TypeError: the function returns something, or an argument has another annotation or none.
        """
        hints = get_type_hints(function, include_extras=True)
        code = function.__code__
        names = code.co_varnames[: code.co_argcount]
        if hints.get("return", object) is not type(None):
            raise TypeError(f"{function.__name__}: a kernel returns None, and its annotation says so")
        return cls(tuple(_kind(hints.get(name), f"{function.__name__}: {name}") for name in names))

    @property
    def records(self) -> tuple[type, ...]:
        """Return the classes of its records in the order in which `entry_text` numbers them."""
        found: list[type] = []

        def visit(kinds: tuple[Kind, ...]) -> None:
            for kind in kinds:
                if isinstance(kind, Record):
                    visit(kind.kinds)
                    if kind.made_by not in found:
                        found.append(kind.made_by)

        visit(self.kinds)
        return tuple(found)

    def entry_text(self) -> str:
        """Return the source of `entry`, which calls `called` with the arguments in a block of memory.

        Each word of the block is a whole number or a float: for an array its address and its lengths, for a
        record its fields in order. `whole` and `real` are the same block, as the one and as the other.
        """
        words, records = count(), self.records

        def text(kind: Kind) -> str:
            if isinstance(kind, Record):
                return f"record_{records.index(kind.made_by)}({', '.join(map(text, kind.kinds))})"
            if kind == WHOLE:
                return f"whole[{next(words)}]"
            if kind == REAL:
                return f"real[{next(words)}]"
            address = next(words)
            lengths = "".join(f"whole[{next(words)}], " for _ in range(kind))
            return f"array_at(whole[{address}], ({lengths}))"

        fields = "".join(
            f"# record_{number}: {one.__name__}({', '.join(fields_of(one))})\n"
            for number, one in enumerate(records)
        )
        return f"{fields}def entry(whole, real):\n    called({', '.join(map(text, self.kinds))})\n"


def fields_of(record: type) -> tuple[str, ...]:
    """Return the names of the fields of a `NamedTuple` class; none for another type."""
    fields: tuple[str, ...] = getattr(record, "_fields", ()) if issubclass(record, tuple) else ()
    return fields


def _kind(hint: object, where: str) -> Kind:
    """Return the kind of an argument from its annotation.

    Args:
        hint: the annotation.
        where: names the argument in an error.

    Raises:
        TypeError: compiled code cannot take it.
    """
    if hint is int:
        return WHOLE
    if hint is float:
        return REAL
    if get_origin(hint) is Annotated:
        for note in get_args(hint):
            if isinstance(note, Axes):
                return note.count
    if isinstance(hint, type) and fields_of(hint):
        hints = get_type_hints(hint, include_extras=True)
        return Record(hint, tuple(_kind(hints[name], f"{where}.{name}") for name in fields_of(hint)))
    raise TypeError(
        f"{where}: compiled code takes int, float, Array1 to Array3 and named tuples of these, not {hint}"
    )
