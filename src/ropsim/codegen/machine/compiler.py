"""A compiler of Python functions: numba's stages up to LLVM's text, or numba by its public interface."""

from collections.abc import Callable, Hashable
from enum import Enum
from types import FunctionType
from typing import Any, Protocol


class Bounds(Enum):
    """Whether compiled code checks every index before it uses it."""

    TRUSTED = "trusted"
    CHECKED = "checked"


class Compiler(Hashable, Protocol):
    """Makes functions that compiled code calls."""

    writes_instructions: bool
    """Whether they may be LLVM's instructions (`ropsim.codegen.vector`); else Python text is compiled."""

    @property
    def array_at(self) -> Callable[..., Any]:
        """Return a function of an address and a tuple of lengths: of the array of float64 there."""

    def inside(self, function: FunctionType) -> Callable[..., Any]:
        """Return a function for callers in compiled code, compiled for the types of their arguments."""

    def inside_as(self, function: FunctionType, signature: str, bounds: Bounds) -> Callable[..., Any]:
        """Return a function for callers in compiled code, compiled for a signature as numba writes it."""


Build = Callable[[Compiler], FunctionType]
"""Returns the function `entry` of `Signature.entry_text`, whose globals the compiler has made."""
