"""Long jumps: how a program of C leaves many calls at once, as emscripten compiles it.

A call that may be left so goes through an import `invoke_…`. Jumping is an exception here; the import that
catches it puts the stack back and tells the program, which then looks whether it is the one that was meant.
"""

from collections.abc import Callable
from typing import TYPE_CHECKING, cast

if TYPE_CHECKING:
    from wasmtime import Func, Store, Table


class LongJump(Exception):  # noqa: N818 - no error: it is how the program goes on
    """The program leaves calls."""


def jump() -> None:
    """Leave all calls up to the next one that may be left so."""
    raise LongJump


def invoke(
    name: str, store: "Store", table: Callable[[], "Table"], exported: Callable[..., int]
) -> Callable[..., int | None]:
    """Return the function of an import such as `invoke_viii`.

    Args:
        name: the import; a `v` after the underline says that it has no result.
        store: the state of the program.
        table: gives its table of functions, once there is one.
        exported: calls a function of the program by its name.
    """
    failed = None if name.startswith("invoke_v") else 0

    def called(index: int, *arguments: int) -> int | None:
        stack = exported("emscripten_stack_get_current")
        try:
            function = cast("Func", table().get(store, index & 0xFFFFFFFF))
            result: int | None = function(store, *arguments)
        except LongJump:
            exported("_emscripten_stack_restore", stack)
            exported("setThrew", 1, 0)
            return failed
        return result

    return called
