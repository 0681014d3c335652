"""The binary form of ICR: golden bytes, one form only, and damage that is told."""

import hashlib
from dataclasses import replace
from pathlib import Path

import pytest

from ropsim.icr import Program, UnverifiedError, assemble, disassemble, encoded, read_binary
from ropsim.icr.binary.layout import CHECKSUM
from ropsim.icr.binary.supply import DamageError, Supply
from support.manual import DOCS, blocks

GOLDEN = sorted((Path(__file__).parents[2] / "golden" / "icr").glob("*.icr"))
TEXTS = {path.stem: path.read_text("ascii") for path in GOLDEN}
TEXTS |= {
    str(one): one.text for one in blocks(DOCS / "reference" / "icr.md", "icr") if "error:" not in one.text
}
SMALL = """ICR 1.0 tiny
REQUIRE CAP IO
VAR n INT
IO DO lamp BOOL
PROC main
LOCAL b BOOL
  PUSH INT -1
  STORE n
  PUSH BOOL TRUE
  STORE b
  LOAD b
  OUT lamp
  HALT
END
"""


def signed(content: bytes | bytearray) -> bytes:
    """Return bytes with their checksum."""
    return bytes(content) + hashlib.sha256(content).digest()


def refused(content: bytes) -> str:
    program, found = read_binary(content, "a.icb")
    assert program is None
    return found[0].code


@pytest.mark.parametrize("name", sorted(TEXTS))
def test_text_and_binary_give_each_other(name: str) -> None:
    program = assemble(TEXTS[name])
    content = encoded(program)
    again, found = read_binary(content)
    assert (again, found) == (program, ())
    assert isinstance(again, Program)
    assert disassemble(again) == disassemble(program)
    assert encoded(assemble(disassemble(again))) == content


def test_the_bytes_are_those_of_the_manual() -> None:
    content = encoded(assemble(SMALL))
    assert content[:-CHECKSUM] == (
        b"ICB\x00\x01\x00"
        b"\x01\x05\x04tiny"
        b"\x02\x05\x00\x01\x02IO"
        b"\x03\x02\x01\x01"
        b"\x04\x08\x01\x01\x00\x04lamp"
        b"\x07\x21\x01\x04main\x00\x01\x00\x00"
        b"\x07\x01\x01\x01\x01\x01\x03\x01\x01\x01\x00\x01\x01\x03\x00\x01\x02\x00\x07\x02\x00\x00\x01"
        b"\x80\x04\x01n\x01b"
    )
    assert content[-CHECKSUM:] == hashlib.sha256(content[:-CHECKSUM]).digest()


@pytest.mark.parametrize("name", ["square", "signals"])
def test_no_changed_bit_and_no_cut_gets_through(name: str) -> None:
    content = encoded(assemble(TEXTS[name]))
    assert {refused(content[:end]) for end in range(len(content))} == {"I405"}
    changed = bytearray(content)
    for at in range(len(content)):
        changed[at] ^= 1 << at % 8
        assert refused(bytes(changed)) in ("I405", "I410")
        changed[at] ^= 1 << at % 8
    assert refused(content + b"\x00") == "I405"


@pytest.mark.parametrize(
    ("old", "new", "code"),
    [
        (b"\x02\x05\x00\x01\x02IO", b"\x02\x06\x80\x00\x01\x02IO", "I406"),  # a number longer than it need be
        (b"\x03\x02\x01\x01", b"\x03\x02\x01\x08", "I405"),  # no such type
        (b"\x03\x02\x01\x01", b"\x03\x02\xff\x01", "I405"),  # more than the bytes can hold
        (b"\x03\x02\x01\x01", b"\x03\x0b" + b"\xff" * 10 + b"\x01", "I405"),  # more than 64 bits
        (b"\x04\x08\x01\x01", b"\x04\x08\x01\x04", "I405"),  # no such kind of channel
        (b"\x07\x02\x00\x00\x01", b"\x07\x02\x01\x00\x01", "I405"),  # no such channel
        (b"\x07\x02\x00\x00\x01", b"\x0f\x02\x00\x00\x01", "I405"),  # no such instruction
        (b"\x80\x04\x01n\x01b", b"\x80\x04\x01n\x01n", "I406"),  # the global variable is hidden
        (b"\x80\x04\x01n\x01b", b"\x80\x04\x01n\x01\xff", "I405"),  # no UTF-8
        (b"\x80\x04\x01n\x01b", b"\x80\x05\x01n\x01b\x00", "I405"),  # too long
        (b"\x80\x04\x01n\x01b", b"", "I405"),  # without names
        (b"\x80\x04", b"\x08\x04", "I405"),  # an unknown section
        (b"\x01\x05\x04tiny", b"", "I405"),  # without a program name
    ],
)
def test_what_is_wrong_is_told(old: bytes, new: bytes, code: str) -> None:
    content = encoded(assemble(SMALL))[:-CHECKSUM]
    assert content.count(old) == 1
    assert refused(signed(content.replace(old, new))) == code


def test_another_version_is_refused_as_that() -> None:
    assert refused(signed(b"ICB\x00\x02\x00")) == "I410"


def test_only_programs_that_may_run_are_written() -> None:
    program = assemble(SMALL)
    with pytest.raises(UnverifiedError) as raised:
        encoded(replace(program, capabilities=()))
    assert raised.value.diagnostic.code == "I427"
    with pytest.raises(UnverifiedError) as raised:
        encoded(assemble(SMALL.replace("LOCAL b", f"LOCAL {256 * 'b'}").replace(" b\n", f" {256 * 'b'}\n")))
    assert raised.value.diagnostic.code == "I407"


def supply(content: bytes) -> Supply:
    return Supply(content, 0, len(content))


@pytest.mark.parametrize("number", [0, 1, 127, 128, 2**63, 2**64 - 1])
def test_numbers_have_at_most_64_bits(number: int) -> None:
    def written(value: int) -> bytes:
        groups = [value >> shift & 0x7F for shift in range(0, max(value.bit_length(), 1), 7)]
        return bytes([*(group | 0x80 for group in groups[:-1]), groups[-1]])

    assert supply(written(number)).number("a count") == number
    with pytest.raises(DamageError, match="64 bits"):
        supply(written(2**64 + number)).number("a count")


@pytest.mark.parametrize(("length", "is_allowed"), [(1, True), (255, True), (256, False), (0, False)])
def test_names_have_1_to_255_bytes(length: int, is_allowed: bool) -> None:
    text = "n" * length
    head = [length & 0x7F | 0x80, length >> 7] if length > 127 else [length]
    given = supply(bytes(head) + text.encode())
    if is_allowed:
        assert given.name("a name") == text
    else:
        with pytest.raises(DamageError, match="allowed are 1 to 255"):
            given.name("a name")
