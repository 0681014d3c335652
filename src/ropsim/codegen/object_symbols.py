"""The names that an object file takes from elsewhere, from its symbol table (ELF, and Mach-O on macOS)."""

import struct
from collections.abc import Iterator

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


def names_from_elsewhere(object_file: bytes) -> tuple[str, ...]:
    """Return the names that must be found in the process before the code can run, sorted.

    Args:
        object_file: 64 bit, least significant byte first, as LLVM writes it.

    Raises:
        ValueError: it is of neither format.
    """
    if object_file.startswith(_ELF):
        return tuple(sorted(set(_elf_names(object_file))))
    if object_file.startswith(_MACH_O):
        return tuple(sorted(set(_mach_o_names(object_file))))
    raise ValueError("the object file is neither ELF nor Mach-O")


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
