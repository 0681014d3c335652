"""Text and binary form give each other for programs at random; damaged bytes are refused or have one form."""

from functools import cache

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from ropsim.icr import assemble, disassemble, encoded, program_id, read_binary, run, verify
from ropsim.icr.binary.layout import CHECKSUM
from support.examples import examples
from support.fuzzing.binaries import signed
from support.programs.making import program
from support.programs.text import written
from support.tasks import compiled

BATCH = 20
BUDGET = 20_000


@cache
def binary(seed: int) -> bytes:
    code = compiled(written(program(seed))).icr
    assert code is not None
    return encoded(code)


@pytest.mark.parametrize("first", range(0, 100, BATCH))
def test_text_and_binary_of_compiled_programs_give_each_other(first: int) -> None:
    for seed in range(first, first + BATCH):
        code = compiled(written(program(seed))).icr
        assert code is not None
        text, content = disassemble(code), encoded(code)
        again, found = read_binary(content)
        assert again is not None, found
        assert disassemble(again) == text
        assert encoded(assemble(text)) == content
        assert program_id(again) == program_id(code)
        assert len(content) < len(text)


@settings(max_examples=examples(300), derandomize=True, deadline=None)
@given(st.binary(max_size=200))
def test_any_bytes_are_answered(content: bytes) -> None:
    assert read_binary(content)[1]
    assert read_binary(signed(b"ICB\x00\x01\x00" + content))[1]


@settings(max_examples=examples(300), derandomize=True, deadline=None)
@given(st.sampled_from(range(5)).map(binary), st.data())
def test_damaged_bytes_with_a_right_checksum_are_refused_or_have_one_form(
    content: bytes, data: st.DataObject
) -> None:
    bare = content[:-CHECKSUM]
    at = data.draw(st.integers(4, len(bare) - 1))
    other = signed(bare[:at] + data.draw(st.binary(max_size=3)) + bare[at + data.draw(st.integers(0, 3)) :])
    again, found = read_binary(other)
    assert (again is None) == bool(found)
    if again is not None and not verify(again):
        assert encoded(assemble(disassemble(again))) == other
        assert run(again, budget=BUDGET) == run(again, budget=BUDGET)
