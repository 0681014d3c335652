"""The header of a PLY file: its encoding, and the elements with their properties."""

from enum import Enum

from ropsim.core import frozen_dataclass
from ropsim.meshes.formats.soup import damaged

_LONGEST = 65_536  # bytes of a header
_MOST = 200  # elements, and properties of one
_END = b"end_header"

TYPES = {
    **{"char": "i1", "uchar": "u1", "short": "i2", "ushort": "u2", "int": "i4", "uint": "u4"},
    **{"int8": "i1", "uint8": "u1", "int16": "i2", "uint16": "u2", "int32": "i4", "uint32": "u4"},
    **{"float": "f4", "double": "f8", "float32": "f4", "float64": "f8"},
}
"""Numpy's name for each number of PLY, without its byte order."""


class Encoding(Enum):
    """How numbers are written: as text, or by their bytes in an order of numpy's name."""

    TEXT = ""
    LITTLE = "<"
    BIG = ">"


_ENCODINGS = {
    b"ascii": Encoding.TEXT,
    b"binary_little_endian": Encoding.LITTLE,
    b"binary_big_endian": Encoding.BIG,
}


@frozen_dataclass
class Property:
    """A number of every row of an element, or a list of them.

    Attributes:
        name: such as `x`.
        number: type of the number, or of the entries.
        length: type of the number of entries; empty where it is no list.
    """

    name: str
    number: str
    length: str = ""


@frozen_dataclass
class Element:
    """Rows of the same properties, such as `vertex`."""

    name: str
    count: int
    properties: tuple[Property, ...]


@frozen_dataclass
class Header:
    """Header of a file; `size` is the place of the first row [bytes]."""

    encoding: Encoding
    elements: tuple[Element, ...]
    size: int


def read_header(content: bytes) -> Header:
    """Return the header of a PLY file.

    Raises:
        MeshFileError: it is none.
    """
    end = content.find(_END, 0, _LONGEST)
    newline = content.find(b"\n", end)
    if not content.startswith(b"ply") or end < 0 or newline < 0:
        raise damaged("cannot be read as PLY")
    lines = [line.split() for line in content[:end].splitlines()[1:]]
    encoding: Encoding | None = None
    elements: list[tuple[str, int, list[Property]]] = []
    for words in lines:
        match words:
            case [b"format", name, *_]:
                encoding = _ENCODINGS.get(name)
            case [b"element", name, count]:
                elements.append((_word(name), _count(count), []))
            case [b"property", *sort] if elements:
                elements[-1][2].append(_property(sort))
            case [] | [b"comment" | b"obj_info", *_]:
                pass
            case _:
                raise damaged(f"has a header with the line `{_word(b' '.join(words))}`")
    if encoding is None or len(elements) > _MOST or any(len(rows) > _MOST for _, _, rows in elements):
        raise damaged("cannot be read as PLY")
    whole = tuple(Element(name, count, tuple(properties)) for name, count, properties in elements)
    return Header(encoding, whole, newline + 1)


def _property(words: list[bytes]) -> Property:
    match [_word(word) for word in words]:
        case [number, name] if number in TYPES:
            return Property(name, TYPES[number])
        case ["list", length, number, name] if number in TYPES and TYPES.get(length, "f")[0] != "f":
            return Property(name, TYPES[number], TYPES[length])
    raise damaged(f"has a header with the property `{_word(b' '.join(words))}`")


def _count(word: bytes) -> int:
    if not word.isdigit() or len(word) > 15:
        raise damaged(f"has a header with `{_word(word)}` rows")
    return int(word)


def _word(word: bytes) -> str:
    return word[:40].decode("utf-8", "replace")
