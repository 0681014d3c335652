"""Straight-line source to instructions of LLVM, without numba's stages for programs of any kind.

A formula of hundreds of lines has one type and no branch: there is nothing to find out about it. Written
down directly it is compiled in a third of the time.
"""

import ast
from collections.abc import Callable
from typing import TYPE_CHECKING, Protocol, cast

from llvmlite import ir

from ropsim.codegen.instructions import REAL, Instructions

if TYPE_CHECKING:
    from numba.core.types import Type
    from numba.core.typing.templates import Signature


class _Context(Protocol):
    """What is needed of numba's context of a target."""

    def make_array(self, kind: "Type") -> Callable[..., ir.Value]:
        """Return what makes a view of an array of the type."""

    def get_dummy_value(self) -> ir.Value:
        """Return what stands for no value."""


def straight_line(text: str) -> Callable[..., None]:
    """Return a function for code that numba compiles; nobody else can call it.

    Args:
        text: of a function of one-dimensional arrays of float64, as `emit` writes it.
    """
    from numba import types
    from numba.extending import intrinsic

    (function,) = ast.parse(text).body
    assert isinstance(function, ast.FunctionDef)
    names = [argument.arg for argument in function.args.args]

    def of(taken: tuple["Type", ...]) -> "tuple[Signature, Callable[..., ir.Value]] | None":
        """Return what numba asks for: the types, and who writes the call; None for types that do not fit."""
        if not all(_is_row(one) for one in taken):
            return None

        def call(
            context: _Context, builder: ir.IRBuilder, signature: "Signature", arguments: list[ir.Value]
        ) -> ir.Value:
            called = _written(builder.module, function, names)
            rows = zip(signature.args, arguments, strict=True)
            builder.call(called, [context.make_array(kind)(context, builder, row).data for kind, row in rows])
            return context.get_dummy_value()

        return types.void(*taken), call

    # numba counts the arguments of the function that it is given
    row = ", ".join(names)
    scope: dict[str, Callable[..., object]] = {"of": of}
    exec(f"def {function.name}(context_, {row}): return of(({row},))", scope)  # our own source
    return cast("Callable[..., None]", intrinsic(scope[function.name]))


def _is_row(kind: "Type") -> bool:
    """Return whether a type of numba is that of a one-dimensional array of float64 without gaps."""
    return str(kind) == "array(float64, 1d, C)"


def _written(module: ir.Module, function: ast.FunctionDef, names: list[str]) -> ir.Function:
    """Return the function in a module; it is written down where it is not there yet."""
    symbol = f"straight_line.{function.name}"
    known = module.globals.get(symbol)
    if known is not None:
        return known
    row = REAL.as_pointer()
    made = ir.Function(module, ir.FunctionType(ir.VoidType(), [row] * len(names)), symbol)
    made.linkage = "internal"
    lines = Instructions(ir.IRBuilder(made.append_basic_block()), dict(zip(names, made.args, strict=True)))
    for line in function.body:
        lines.write(line)
    lines.builder.ret_void()
    return made
