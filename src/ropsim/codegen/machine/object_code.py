"""Object files by llvmlite: from LLVM's text to machine code that stands alone, and into this process.

Importing numba and reading its cache takes longer than many a simulation. The object file of a compiled
function is loaded with llvmlite alone, in a tenth of the time. If it calls functions of numba's run time,
such as memory for new arrays, numba is started first.
"""

import struct
from collections.abc import Iterator
from functools import lru_cache
from typing import TYPE_CHECKING

from ropsim.core import frozen_dataclass

if TYPE_CHECKING:
    from llvmlite.binding import ModuleRef, TargetMachine
    from llvmlite.binding.newpassmanagers import PipelineTuningOptions

_COUNTER = "@NRT_decref"
"""The name of numba's function that counts the references to an array."""
ENTRY = "ropsim_entry"
"""The name of the function that `with_entry` adds."""
_ENTRY_TEXT = """

define i32 @{entry}(ptr %block) {{
  %answers = alloca [2 x ptr]
  %says = getelementptr ptr, ptr %answers, i64 1
  %status = call i32 @"{symbol}"(ptr %answers, ptr %says, ptr %block, ptr %block)
  ret i32 %status
}}
"""
_ELF = b"\x7fELF"
_ELF_SECTIONS = struct.Struct("<Q10xHH")  # e_shoff, then e_shentsize and e_shnum, from byte 40
_ELF_SECTION = struct.Struct("<4xI16xQQI12xQ")  # sh_type, sh_offset, sh_size, sh_link, sh_entsize
_ELF_SYMBOL = struct.Struct("<I2xH16x")  # st_name, st_shndx
_ELF_TABLE = 2  # SHT_SYMTAB
_MACH_O = b"\xcf\xfa\xed\xfe"
_MACH_HEADER, _MACH_COMMANDS = 32, 16
_MACH_TABLE = 2  # LC_SYMTAB
_MACH_SYMBOL = struct.Struct("<IB11x")  # n_strx, n_type
_MACH_PLACE = 0x0E  # N_TYPE, 0 for names from elsewhere
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
    """Machine code calls a function that this process does not have, or lacks its own."""


class NoObjectCodeError(ValueError):
    """Object files of this system cannot be read."""


def with_entry(ir: str, symbol: str) -> str:
    """Return the text of a module with the function `ENTRY` of one block of memory.

    It calls a function in numba's calling convention, which returns a status and takes two more addresses,
    for a result and for the text of an exception: these are not read.

    Args:
        ir: LLVM's text of the module.
        symbol: name of the function `entry` of `Signature.entry_text` in it.
    """
    return ir + _ENTRY_TEXT.format(entry=ENTRY, symbol=symbol)


def emit_object(ir: str, symbol: str) -> MachineCode:
    """Return the machine code of one function of a module in LLVM's text form, and of its callees.

    Raises:
        NoObjectCodeError: this system has object files of another format.
    """
    import llvmlite.binding as llvm

    tuning = llvm.create_pipeline_tuning_options(speed_level=3)
    tuning.loop_vectorization, tuning.slp_vectorization = True, False  # as numba does
    machine = _machine(llvm.get_host_cpu_name(), _features())
    object_file = machine.emit_object(_optimised(ir, symbol, machine, tuning))
    return MachineCode(symbol, names_from_elsewhere(object_file), object_file)


def portable_text(ir: str, symbol: str) -> str:
    """Return a module in LLVM's text form, shorter and for any processor with addresses of 64 bits.

    The passes that need no processor are done: `emit_object` takes half of the time for it. The results of
    the machine code stay equal to the bit, because LLVM keeps the order of all sums.

    Args:
        ir: the module as numba writes it, with `with_entry`.
        symbol: the function that stays callable from outside.
    """
    import llvmlite.binding as llvm

    tuning = llvm.create_pipeline_tuning_options(speed_level=2)
    tuning.loop_vectorization, tuning.slp_vectorization = False, False
    tuning.loop_unrolling = False
    module = _optimised(ir, symbol, _machine("", ""), tuning)
    module.triple = module.data_layout = ""
    return str(module)


def _optimised(
    ir: str, symbol: str, machine: "TargetMachine", tuning: "PipelineTuningOptions"
) -> "ModuleRef":
    """Return a module for a machine after LLVM's passes; only one function stays callable from outside."""
    import llvmlite.binding as llvm

    module = llvm.parse_assembly(ir)
    module.triple, module.data_layout = machine.triple, str(machine.target_data)
    for one in (*module.functions, *module.global_variables):
        if not one.is_declaration and one.name != symbol:
            one.linkage = "internal"
    builder = llvm.create_pass_builder(machine, tuning)
    passes = llvm.create_new_module_pass_manager()
    passes.add_ipsccp_pass()  # arrays of the caller have no counter: then the counting goes
    passes.add_simplify_cfg_pass()
    passes.add_global_dead_code_eliminate_pass()
    for _ in range(2 if _COUNTER in ir else 1):
        passes.run(module, builder)
        builder.getModulePassManager().run(module, builder)
    return module


def load(code: MachineCode) -> int:
    """Return the address of the function; its code stays in memory.

    Raises:
        MissingNameError: the process lacks a name that the code needs, or the code lacks the function.
    """
    import llvmlite.binding as llvm

    machine = _machine(llvm.get_host_cpu_name(), _features())
    engine = llvm.create_mcjit_compiler(llvm.parse_assembly(""), machine)
    if _missing(code):
        _start_numba()
    missing = _missing(code)
    if missing:
        raise MissingNameError(", ".join(missing))
    _loaded.append(engine)
    engine.add_object_file(llvm.ObjectFileRef.from_data(code.object_file))
    engine.finalize_object()
    address: int = engine.get_function_address(code.symbol)
    if not address:
        raise MissingNameError(code.symbol)
    return address


def packed(code: MachineCode) -> bytes:
    """Return machine code as bytes."""
    return b"\n".join((code.symbol.encode(), " ".join(code.needs).encode(), code.object_file))


def unpacked(content: bytes) -> MachineCode:
    """Return the machine code that `packed` made bytes of.

    Raises:
        ValueError: the bytes have another form.
    """
    symbol, needs, object_file = content.split(b"\n", 2)
    return MachineCode(symbol.decode(), tuple(needs.decode().split()), object_file)


def host() -> str:
    """Return the dependencies of machine code other than its source: processor and compiler."""
    import llvmlite
    import llvmlite.binding as llvm

    return f"{llvmlite.__version__} {llvm.get_process_triple()} {llvm.get_host_cpu_name()} {_features()}"


def _missing(code: MachineCode) -> list[str]:
    """Return the names that the code needs and this process lacks: calling one would end it."""
    import llvmlite.binding as llvm

    return [name for name in code.needs if not llvm.address_of_symbol(name)]


def _machine(cpu: str, features: str) -> "TargetMachine":
    """Return a new description of a processor of this system; an engine takes it over."""
    import llvmlite.binding as llvm

    llvm.initialize_native_target()
    llvm.initialize_native_asmprinter()
    target = llvm.Target.from_triple(llvm.get_process_triple())
    # as numba does: code for x86 that is run where it is made must not be relocated
    reloc = "static" if target.name.startswith("x86") else "default"
    return target.create_target_machine(
        cpu=cpu,
        features=features,
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


def names_from_elsewhere(object_file: bytes) -> tuple[str, ...]:
    """Return the names that must be found in the process before the code can run, sorted.

    Args:
        object_file: 64 bit, least significant byte first, as LLVM writes it.

    Raises:
        NoObjectCodeError: it is of neither format.
    """
    if object_file.startswith(_ELF):
        return tuple(sorted(set(_elf_names(object_file))))
    if object_file.startswith(_MACH_O):
        return tuple(sorted(set(_mach_o_names(object_file))))
    raise NoObjectCodeError("the object file is neither ELF nor Mach-O")


def _elf_names(data: bytes) -> Iterator[str]:
    start, size, count = _ELF_SECTIONS.unpack_from(data, 40)
    sections = [_ELF_SECTION.unpack_from(data, start + k * size) for k in range(count)]
    for kind, offset, length, link, _ in sections:
        if kind != _ELF_TABLE:
            continue
        texts = sections[link][1]
        for at in range(offset, offset + length, _ELF_SYMBOL.size):
            name, section = _ELF_SYMBOL.unpack_from(data, at)
            if name and section == 0:
                yield _text(data, texts + name)


def _mach_o_names(data: bytes) -> Iterator[str]:
    (commands,) = struct.unpack_from("<I", data, _MACH_COMMANDS)
    at = _MACH_HEADER
    for _ in range(commands):
        kind, size = struct.unpack_from("<II", data, at)
        if kind == _MACH_TABLE:
            symbols, count, texts = struct.unpack_from("<III", data, at + 8)
            for place in range(symbols, symbols + count * _MACH_SYMBOL.size, _MACH_SYMBOL.size):
                name, of = _MACH_SYMBOL.unpack_from(data, place)
                if name and not of & _MACH_PLACE:
                    yield _text(data, texts + name).removeprefix("_")
        at += size


def _text(data: bytes, start: int) -> str:
    return data[start : data.index(b"\0", start)].decode()
