"""Functions for code that numba compiles whose instructions of LLVM we write down."""

from collections.abc import Callable, Mapping, Sequence
from typing import TYPE_CHECKING, Protocol, cast

from llvmlite import ir

if TYPE_CHECKING:
    from numba.core.types import Type
    from numba.core.typing.templates import Signature

COUNT, NUMBER = "int64", "float64"
ROW, ROWS = "array(float64, 1d, C)", "array(float64, 2d, C)"
"""numba's words for what such functions take: arrays are those of float64 without gaps."""


class Row(Protocol):
    """What is needed of numba's view of an array: where it is, and its lengths."""

    data: ir.Value
    shape: ir.Value


class _Context(Protocol):
    """What is needed of numba's context of a target."""

    def make_array(self, kind: "Type") -> Callable[..., Row]:
        """Return what makes a view of an array of the type."""

    def get_dummy_value(self) -> ir.Value:
        """Return what stands for no value."""


def made(
    name: str,
    takes: Mapping[str, Sequence[str]],
    write: Callable[[ir.IRBuilder, dict[str, ir.Value], dict[str, Row]], None],
) -> Callable[..., None]:
    """Return the function for code that numba compiles; nobody else can call it.

    Args:
        name: of it.
        takes: its arguments and numba's words for what each may be.
        write: writes the call for scalars and arrays.
    """
    from numba import types
    from numba.extending import intrinsic

    def of(taken: tuple["Type", ...]) -> "tuple[Signature, Callable[..., ir.Value]] | None":
        """Return what numba asks for: the types, and who writes the call; None for types that do not fit."""
        if not all(str(one) in allowed for one, allowed in zip(taken, takes.values(), strict=True)):
            return None

        def call(
            context: _Context, builder: ir.IRBuilder, signature: "Signature", arguments: list[ir.Value]
        ) -> ir.Value:
            scalars: dict[str, ir.Value] = {}
            arrays: dict[str, Row] = {}
            for argument, kind, value in zip(takes, signature.args, arguments, strict=True):
                if str(kind) in (ROW, ROWS):
                    arrays[argument] = context.make_array(kind)(context, builder, value)
                else:
                    scalars[argument] = value
            write(builder, scalars, arrays)
            return context.get_dummy_value()

        return types.void(*taken), call

    # numba counts the arguments of the function that it is given
    row = ", ".join(takes)
    scope: dict[str, Callable[..., object]] = {"of": of}
    exec(f"def {name}(context_, {row}): return of(({row},))", scope)  # our own source
    return cast("Callable[..., None]", intrinsic(scope[name]))
