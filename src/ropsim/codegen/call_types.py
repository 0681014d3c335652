"""What calls of numba's own functions give in code that is compiled: found once for the same types.

numba tries all that it knows of `+` whenever one stands in a text, and again when it writes that down: a
third of the time that it takes for a kernel. What it finds depends on function and types of arguments alone.
"""

from numba.core.datamodel.models import OpaqueModel
from numba.core.datamodel.registry import register_default
from numba.core.types import Function, Type
from numba.core.typing import Context
from numba.core.typing.templates import Signature


class _Remembering(Function):  # type: ignore[misc]  # numba has no types
    """A function of numba's that remembers what its calls have given."""

    def __init__(self, templates: object) -> None:
        super().__init__(templates)
        self._given: dict[tuple[Type, ...], Signature] = {}

    def get_call_type(self, context: Context, args: tuple[Type, ...], kws: dict[str, Type]) -> Signature:
        """Return the types of a call; one that cannot be raises an error of numba's."""
        if kws:
            return super().get_call_type(context, args, kws)
        call = tuple(args)
        if call not in self._given:
            self._given[call] = super().get_call_type(context, call, kws)
        return self._given[call]

    def augment(self, other: Type) -> Type | None:
        """Return both functions as one, None where they are not of the same name."""
        return super().augment(_remembering(other))


class CallTypes(Context):  # type: ignore[misc]  # numba has no types
    """What numba knows of types, where functions remember their calls."""

    def _insert_global(self, gv: object, gty: Type) -> None:
        super()._insert_global(gv, _remembering(gty))


def _remembering(kind: Type) -> Type:
    """Return a type of numba's, for a function one that remembers."""
    return _Remembering(kind.templates) if type(kind) is Function else kind


register_default(_Remembering)(OpaqueModel)  # such a function is no value, as numba's own
