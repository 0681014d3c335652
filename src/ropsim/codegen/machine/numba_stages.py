"""numba's stages up to LLVM's text, and its types and intrinsics: the only file that imports `numba.core`.

The later stages run once, in `object_code`. numba itself optimises each function alone and again with each
caller, and makes machine code of each, which is never called. Without that, and with functions that several
kernels call compiled once, compiling takes half of the time.

numba tries all its overloads of `+` whenever one stands in a text, and again when it writes that one down: a
third of its time for a kernel. The result depends on function and types of arguments alone, so `_CallTypes`
keeps it.
"""

from collections.abc import Callable, Iterator, Mapping, Sequence
from functools import cached_property
from types import FunctionType
from typing import Any, Protocol, cast

from llvmlite import ir
from llvmlite.binding import Linkage, ModuleRef
from numba.core import cgutils, types
from numba.core.ccallback import CFunc
from numba.core.codegen import CPUCodeLibrary, JITCPUCodegen
from numba.core.cpu import CPUContext
from numba.core.datamodel.models import OpaqueModel
from numba.core.datamodel.registry import register_default
from numba.core.registry import CPUDispatcher, CPUTarget, cpu_target
from numba.core.sigutils import normalize_signature
from numba.core.types import Array, Function, Integer, Type, UniTuple, float64, int64, intp, unliteral
from numba.core.typing import Context
from numba.core.typing.templates import Signature
from numba.extending import intrinsic
from numba.np.arrayobj import populate_array

from ropsim.codegen.machine.compiler import Bounds

_OPTIONS = {"nopython": True, "error_model": "numpy"}
_INSIDE = {"no_cpython_wrapper": True, "no_cfunc_wrapper": True}
"""Of functions that only compiled code calls."""
_ALONE = {"_nrt": False}
"""Of functions that make no arrays: arrays of their callers are not reference-counted."""
_ENTRY = "void(CPointer(int64), CPointer(float64))"
_NATIVE = "cfunc."
"""numba's word before the name of a function, for the one that C calls."""
COUNT, NUMBER = "int64", "float64"
ROW, ROWS = "array(float64, 1d, C)", "array(float64, 2d, C)"
"""numba's words for the arguments of an `instructions` function: arrays are of float64 without gaps."""
_Written = tuple[Signature, Callable[..., ir.Value]]


class _Remembering(Function):  # type: ignore[misc]  # numba has no types
    """A function of numba's that keeps the types of its calls."""

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


class _CallTypes(Context):  # type: ignore[misc]  # numba has no types
    """numba's knowledge of types, where functions keep the types of their calls."""

    def _insert_global(self, gv: object, gty: Type) -> None:
        super()._insert_global(gv, _remembering(gty))


def _remembering(kind: Type) -> Type:
    """Return a type of numba's; of a function, one that keeps the types of its calls."""
    return _Remembering(kind.templates) if type(kind) is Function else kind


register_default(_Remembering)(OpaqueModel)  # this type is no value, like numba's own function types


class _Library(CPUCodeLibrary):  # type: ignore[misc]  # numba has no types
    """A function alone; its callees stay separate until all are emitted."""

    def _optimize_functions(self, ll_module: ModuleRef) -> None:
        ll_module.data_layout = self._codegen._data_layout

    def finalize(self) -> None:
        """End the function; numba would link all its callees into it, and again into each that calls it."""
        self._finalized = True

    def get_llvm_str(self) -> str:
        """Return the text of the function and of its callees."""
        return str(self._whole())

    def _get_module_for_linking(self) -> ModuleRef:
        return self._for_others

    @cached_property
    def _for_others(self) -> ModuleRef:
        """The function and its callees, for numba's own libraries, which may meet it more than once."""
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
        """Yield its direct and indirect callees, except known ones."""
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
        """Omit the environment, which only Python callers need."""


class _Target(CPUTarget):  # type: ignore[misc]  # numba has no types
    @cached_property
    def target_context(self) -> CPUContext:
        """Return how functions are written down: as numba does for this processor."""
        return cpu_target.target_context.subtarget(
            _internal_codegen=_Codegen("ropsim"), typing_context=self.typing_context
        )

    @cached_property
    def typing_context(self) -> _CallTypes:
        """Return the typing context of all functions."""
        return _CallTypes()


class _Inside(CPUDispatcher):  # type: ignore[misc]  # numba has no types
    """A function that only compiled code calls; made for types of arguments, not for each number there."""

    targetdescr = _Target("cpu")

    def get_call_template(self, args: tuple[Type, ...], kws: dict[str, Type]) -> object:
        """Return the typing data for its callers; a number in their text is a number like others."""
        return super().get_call_template(tuple(map(unliteral, args)), kws)


class _Entry(CFunc):  # type: ignore[misc]  # numba has no types
    _targetdescr = _Inside.targetdescr


class Stages:
    """Compiles with numba's stages up to LLVM's text; see `Compiler`."""

    writes_instructions = True

    @property
    def array_at(self) -> Callable[..., Any]:
        """Return the function of an address and lengths."""
        return cast("Callable[..., Any]", _array_at)

    def inside(self, function: FunctionType) -> Callable[..., Any]:
        """Return a function for callers in compiled code, compiled for the types of their arguments."""
        return cast("Callable[..., Any]", _Inside(function, targetoptions=_OPTIONS | _INSIDE | _ALONE))

    def inside_as(self, function: FunctionType, signature: str, bounds: Bounds) -> Callable[..., Any]:
        """Return a function for callers in compiled code, compiled for a signature as numba writes it."""
        checked = {"boundscheck": bounds is Bounds.CHECKED}
        made = _Inside(function, targetoptions=_OPTIONS | _INSIDE | checked)
        made.compile(signature)
        made.disable_compile()
        return cast("Callable[..., Any]", made)

    def llvm_text(self, entry: FunctionType) -> tuple[str, str]:
        """Return `entry` of `Signature.entry_text` with its callees as LLVM's text, and its name there."""
        options = {"error_model": "numpy"} | _ALONE
        made = _Entry(entry, normalize_signature(_ENTRY), locals={}, options=options)
        made.compile()
        return made.inspect_llvm(), made.native_name.removeprefix(_NATIVE)


STAGES = Stages()
"""The one compiler of this kind: functions that several kernels call are compiled once in a process."""


class Row(Protocol):
    """A view of an array in LLVM's instructions.

    Attributes:
        data: address of its first number.
        shape: its lengths.
    """

    data: ir.Value
    shape: ir.Value


def instructions(
    name: str,
    takes: Mapping[str, Sequence[str]],
    write: Callable[[ir.IRBuilder, dict[str, ir.Value], dict[str, Row]], None],
) -> Callable[..., None]:
    """Return a function of LLVM's instructions for callers in compiled code.

    Args:
        name: of it.
        takes: its arguments and numba's words for the types that each may have.
        write: writes the call for scalars and arrays.
    """

    def of(taken: tuple[Type, ...]) -> _Written | None:
        """Return types and writer of a call, as numba needs them; None for types that do not fit."""
        if not all(str(one) in allowed for one, allowed in zip(taken, takes.values(), strict=True)):
            return None

        def call(
            context: CPUContext, builder: ir.IRBuilder, signature: Signature, arguments: list[ir.Value]
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


@intrinsic  # type: ignore[untyped-decorator]  # numba has no types
def _array_at(_types: Context, address: Type, lengths: UniTuple) -> _Written:
    """Return an array of float64 without gaps: its address and lengths; its references are not counted."""
    kind = Array(float64, lengths.count, "C")

    def view(
        context: CPUContext, builder: ir.IRBuilder, _signature: Signature, arguments: list[ir.Value]
    ) -> ir.Value:
        pointer = context.make_array(kind)(context, builder).data.type
        data = builder.inttoptr(arguments[0], pointer)
        return _array_view(
            context, builder, kind, data, cgutils.unpack_tuple(builder, arguments[1], kind.ndim)
        )

    return kind(address, lengths), view


@intrinsic  # type: ignore[untyped-decorator]  # numba has no types
def as_row(_types: Context, array: Type) -> _Written | None:
    """Return the numbers of an array without gaps one behind the other."""
    if not isinstance(array, Array) or array.layout != "C":
        return None
    kind = Array(float64, 1, "C")

    def write(
        context: CPUContext, builder: ir.IRBuilder, _signature: Signature, arguments: list[ir.Value]
    ) -> ir.Value:
        given = context.make_array(array)(context, builder, arguments[0])
        count = context.get_constant(intp, 1)
        for length in cgutils.unpack_tuple(builder, given.shape, array.ndim):
            count = builder.mul(count, length)
        return _array_view(context, builder, kind, given.data, [count])

    return kind(array), write


@intrinsic  # type: ignore[untyped-decorator]  # numba has no types
def as_table(_types: Context, array: Type, rows: Type, columns: Type) -> _Written | None:
    """Return the first numbers of an array as a table."""
    if array != Array(float64, 1, "C") or not isinstance(rows, Integer) or not isinstance(columns, Integer):
        return None
    kind = Array(float64, 2, "C")

    def write(
        context: CPUContext, builder: ir.IRBuilder, _signature: Signature, arguments: list[ir.Value]
    ) -> ir.Value:
        given = context.make_array(array)(context, builder, arguments[0])
        return _array_view(context, builder, kind, given.data, arguments[1:])

    return kind(array, int64, int64), write


def _array_view(
    context: CPUContext, builder: ir.IRBuilder, kind: Array, data: ir.Value, shape: list[ir.Value]
) -> ir.Value:
    """Return an array of float64 without gaps at an address; its references are not counted."""
    made = context.make_array(kind)(context, builder)
    size = itemsize = context.get_constant(intp, 8)
    strides = [size]
    for length in reversed(shape[1:]):
        size = builder.mul(size, length)
        strides.insert(0, size)
    populate_array(made, data, shape, strides, itemsize, meminfo=None)
    return made._getvalue()
