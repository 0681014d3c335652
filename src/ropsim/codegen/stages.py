"""The stages of numba up to the text of LLVM; what comes after them is done once, by `machine_code`.

Otherwise numba improves each function by itself and again with each that calls it, and makes machine code of
each, which nobody ever calls. Without that, and with functions that several kernels call compiled once, it
takes half of the time.
"""

from collections.abc import Callable, Iterator
from functools import cached_property
from types import FunctionType
from typing import cast

from llvmlite import ir
from llvmlite.binding import Linkage, ModuleRef
from numba.core import cgutils
from numba.core.ccallback import CFunc
from numba.core.codegen import CPUCodeLibrary, JITCPUCodegen
from numba.core.cpu import CPUContext
from numba.core.registry import CPUDispatcher, CPUTarget, cpu_target
from numba.core.sigutils import normalize_signature
from numba.core.types import Array, Type, UniTuple, float64, unliteral
from numba.core.typing import Context
from numba.core.typing.templates import Signature
from numba.extending import intrinsic

from ropsim.codegen.call_types import CallTypes
from ropsim.codegen.direct import Compiled
from ropsim.codegen.shape_views import array_view

_OPTIONS = {"nopython": True, "error_model": "numpy"}
_INSIDE = {"no_cpython_wrapper": True, "no_cfunc_wrapper": True}
"""Of functions that only compiled code calls."""
_ALONE = {"_nrt": False}
"""Of functions that make no arrays: those of their callers are counted by nobody."""
_ENTRY = "void(CPointer(int64), CPointer(float64))"
_NATIVE = "cfunc."
"""numba's word before the name of a function, for the one that C calls."""


class _Library(CPUCodeLibrary):  # type: ignore[misc]  # numba has no types
    """A function by itself, and those that it calls beside it until all are written down."""

    def _optimize_functions(self, ll_module: ModuleRef) -> None:
        ll_module.data_layout = self._codegen._data_layout

    def finalize(self) -> None:
        """End the function; numba would put all that it calls into it, and again into each that calls it."""
        self._finalized = True

    def get_llvm_str(self) -> str:
        """Return the text of the function and of all that it calls."""
        return str(self._whole())

    def _get_module_for_linking(self) -> ModuleRef:
        return self._for_others

    @cached_property
    def _for_others(self) -> ModuleRef:
        """The function and all that it calls, for numba's own libraries, which may meet it more than once."""
        whole = self._whole()
        for one in whole.functions:
            if not one.is_declaration and one.linkage == Linkage.external:
                one.linkage = "linkonce_odr"
        return whole

    def _whole(self) -> ModuleRef:
        whole = self._final_module.clone()
        for one in self._called(set()):
            part = one._final_module if isinstance(one, _Library) else one._get_module_for_linking()
            whole.link_in(part, preserve=True)
        return whole

    def _called(self, known: set[CPUCodeLibrary]) -> Iterator[CPUCodeLibrary]:
        """Yield what it calls, and what that calls, but for what is known."""
        for one in self._linking_libraries:
            if one not in known:
                known.add(one)
                yield one
                if isinstance(one, _Library):
                    yield from one._called(known)

    def get_pointer_to_function(self, name: str) -> int:  # noqa: ARG002  # as numba calls it
        """Return that there is no machine code."""
        self._ensure_finalized()
        return 0


class _Codegen(JITCPUCodegen):  # type: ignore[misc]  # numba has no types
    _library_class = _Library

    def _add_module(self, module: ModuleRef) -> None: ...

    def set_env(self, env_name: str, env: object) -> None:
        """Do without what only Python's own callers need."""


class _Target(CPUTarget):  # type: ignore[misc]  # numba has no types
    @cached_property
    def target_context(self) -> CPUContext:
        """Return how functions are written down: as numba does for this processor."""
        return cpu_target.target_context.subtarget(
            _internal_codegen=_Codegen("ropsim"), typing_context=self.typing_context
        )

    @cached_property
    def typing_context(self) -> CallTypes:
        """Return what is known of the types of all functions."""
        return CallTypes()


class _Inside(CPUDispatcher):  # type: ignore[misc]  # numba has no types
    """A function that only compiled code calls; made for types of arguments, not for each number there."""

    targetdescr = _Target("cpu")

    def get_call_template(self, args: tuple[Type, ...], kws: dict[str, Type]) -> object:
        """Return what its callers need to know; a number in their text is a number like others."""
        return super().get_call_template(tuple(map(unliteral, args)), kws)


class _Entry(CFunc):  # type: ignore[misc]  # numba has no types
    _targetdescr = _Inside.targetdescr


def inside(function: FunctionType) -> Callable[..., None]:
    """Return a function for callers in compiled code, as these need it."""
    return cast("Callable[..., None]", _Inside(function, targetoptions=_OPTIONS | _INSIDE | _ALONE))


def inside_as(signature: str, *, boundscheck: bool) -> Callable[[FunctionType], Callable[..., None]]:
    """Return what makes such a function of the types of a signature alone.

    Args:
        signature: as numba writes it.
        boundscheck: whether it looks at every index before it uses it.
    """

    def make(function: FunctionType) -> Callable[..., None]:
        made = _Inside(function, targetoptions=_OPTIONS | _INSIDE | {"boundscheck": boundscheck})
        made.compile(signature)
        made.disable_compile()
        return cast("Callable[..., None]", made)

    return make


def outside(function: Callable[..., None]) -> Compiled:
    """Return for callers in Python what `inside` or `inside_as` has made, with machine code by numba."""
    assert isinstance(function, _Inside)
    options = {name: value for name, value in function.targetoptions.items() if name not in _INSIDE | _ALONE}
    return cast("Compiled", CPUDispatcher(function.py_func, targetoptions=options))


def written(entry: FunctionType) -> tuple[str, str]:
    """Return `Signature.entry_text` with all that it calls as a text of LLVM, and its name there."""
    made = _Entry(entry, normalize_signature(_ENTRY), locals={}, options={"error_model": "numpy"} | _ALONE)
    made.compile()
    return made.inspect_llvm(), made.native_name.removeprefix(_NATIVE)


@intrinsic  # type: ignore[untyped-decorator]  # numba has no types
def array_at(_types: Context, address: Type, lengths: UniTuple) -> tuple[Signature, Callable[..., ir.Value]]:
    """Return an array of float64 without gaps: where it is, and its lengths; nobody counts who uses it."""
    kind = Array(float64, lengths.count, "C")

    def view(
        context: CPUContext, builder: ir.IRBuilder, _signature: Signature, arguments: list[ir.Value]
    ) -> ir.Value:
        pointer = context.make_array(kind)(context, builder).data.type
        data = builder.inttoptr(arguments[0], pointer)
        return array_view(
            context, builder, kind, data, cgutils.unpack_tuple(builder, arguments[1], kind.ndim)
        )

    return kind(address, lengths), view
