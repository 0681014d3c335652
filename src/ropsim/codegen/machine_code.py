"""Machine code that stands alone: kept in the cache folder, and run there without the compiler that made it.

Importing numba and reading its cache takes longer than many a simulation. So the object file of a compiled
function is kept by itself and loaded with llvmlite, which takes a tenth of the time. Where it calls what only
numba brings, such as room for new arrays, numba is started first.
"""

from functools import lru_cache
from typing import TYPE_CHECKING

from ropsim.codegen.object_symbols import names_from_elsewhere
from ropsim.core import frozen_dataclass

if TYPE_CHECKING:
    from llvmlite.binding import TargetMachine

_COUNTER = "@NRT_decref"
"""The name of numba's function that counts who uses an array."""
_loaded: list[object] = []
"""Machine code stays in memory as long as the process."""


@frozen_dataclass
class MachineCode:
    """One compiled function.

    Attributes:
        symbol: the name of the function in the object file.
        needs: names that the process must have before the code is loaded.
        object_file: as LLVM writes it for this machine.
    """

    symbol: str
    needs: tuple[str, ...]
    object_file: bytes


class MissingNameError(Exception):
    """Machine code calls something that this process does not have."""


def emit_object(ir: str, symbol: str) -> MachineCode:
    """Return the machine code of one function of a module in LLVM's text form, and of what it calls."""
    import llvmlite.binding as llvm

    module = llvm.parse_assembly(ir)
    for one in (*module.functions, *module.global_variables):
        if not one.is_declaration and one.name != symbol:
            one.linkage = "internal"
    machine = _machine()
    tuning = llvm.create_pipeline_tuning_options(speed_level=3)
    tuning.loop_vectorization, tuning.slp_vectorization = True, False  # as numba does
    builder = llvm.create_pass_builder(machine, tuning)
    passes = llvm.create_new_module_pass_manager()
    passes.add_ipsccp_pass()  # arrays of the caller have no counter: what counts goes once that is seen
    passes.add_simplify_cfg_pass()
    passes.add_global_dead_code_eliminate_pass()
    for _ in range(2 if _COUNTER in ir else 1):
        passes.run(module, builder)
        builder.getModulePassManager().run(module, builder)
    object_file = machine.emit_object(module)
    return MachineCode(symbol, names_from_elsewhere(object_file), object_file)


def load(code: MachineCode) -> int:
    """Return the address of the function; its code stays in memory.

    Raises:
        MissingNameError: the process lacks a name that the code needs.
    """
    import llvmlite.binding as llvm

    engine = llvm.create_mcjit_compiler(llvm.parse_assembly(""), _machine())
    if _missing(code):
        _start_numba()
    missing = _missing(code)
    if missing:
        raise MissingNameError(", ".join(missing))
    _loaded.append(engine)
    engine.add_object_file(llvm.ObjectFileRef.from_data(code.object_file))
    engine.finalize_object()
    address: int = engine.get_function_address(code.symbol)
    return address


def packed(code: MachineCode) -> bytes:
    """Return machine code as bytes."""
    return b"\n".join((code.symbol.encode(), " ".join(code.needs).encode(), code.object_file))


def unpacked(content: bytes) -> MachineCode:
    """Return the machine code that `packed` made bytes of.

    Raises:
        ValueError: these are no such bytes.
    """
    symbol, needs, object_file = content.split(b"\n", 2)
    return MachineCode(symbol.decode(), tuple(needs.decode().split()), object_file)


def host() -> str:
    """Return what machine code depends on besides its source: processor and compiler."""
    import llvmlite
    import llvmlite.binding as llvm

    return f"{llvmlite.__version__} {llvm.get_process_triple()} {llvm.get_host_cpu_name()} {_features()}"


def _missing(code: MachineCode) -> list[str]:
    """Return the names that the code needs and this process lacks: calling one would end it."""
    import llvmlite.binding as llvm

    return [name for name in code.needs if not llvm.address_of_symbol(name)]


def _machine() -> "TargetMachine":
    """Return a new description of this processor; an engine takes it over."""
    import llvmlite.binding as llvm

    llvm.initialize_native_target()
    llvm.initialize_native_asmprinter()
    target = llvm.Target.from_triple(llvm.get_process_triple())
    # as numba does: code for x86 that is run where it is made must not be relocated
    reloc = "static" if target.name.startswith("x86") else "default"
    return target.create_target_machine(
        cpu=llvm.get_host_cpu_name(),
        features=_features(),
        opt=3,
        reloc=reloc,
        codemodel="jitdefault",
        jit=True,
    )


@lru_cache(maxsize=1)
def _features() -> str:
    import llvmlite.binding as llvm

    features: str = llvm.get_host_cpu_features().flatten()
    return features


@lru_cache(maxsize=1)
def _start_numba() -> None:
    """Let numba put the names of its own run time into this process."""
    import numba

    numba.cfunc("void()")(_nothing)


def _nothing() -> None:
    pass
