"""The canonical form of exchange files: one text for one content, and the content comes back."""

from dataclasses import replace
from functools import cache
from math import inf, nan

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from ropsim.core import SourceText
from ropsim.part21 import (
    Absent,
    Binary,
    Enumeration,
    ExchangeFile,
    Instance,
    Record,
    Reference,
    Typed,
    Value,
    canonical,
    read_exchange,
    write_exchange,
)
from support.characters import ANY
from support.examples import examples

HEADER = (
    Record("FILE_DESCRIPTION", (("",), "2;1")),
    Record("FILE_NAME", ("", "", ("",), ("",), "", "", "")),
    Record("FILE_SCHEMA", (("A",),)),
)
WORDS = st.from_regex(r"[A-Z][A-Z0-9_]{0,6}", fullmatch=True, alphabet=ANY)


def values(count: int) -> st.SearchStrategy[Value]:
    """Return parameters that refer to instances 1 to `count`."""
    simple = st.one_of(
        st.integers(-(10**9), 10**9),
        st.floats(allow_nan=False, allow_infinity=False),
        st.text(st.characters(exclude_categories=["Cs"]), max_size=6),
        st.sampled_from(Absent),
        WORDS.map(Enumeration),
        st.integers(1, count).map(Reference),
        st.from_regex(r"[0-3][0-9A-F]{0,4}", fullmatch=True, alphabet=ANY).map(Binary),
    )
    return st.recursive(
        simple,
        lambda inner: st.one_of(st.lists(inner, max_size=3).map(tuple), st.builds(Typed, WORDS, inner)),
    )


@cache
def records(count: int) -> st.SearchStrategy[list[Record]]:
    """Return what an instance consists of, with references to instances 1 to `count`."""
    record = st.builds(Record, WORDS, st.lists(values(count), max_size=4).map(tuple))
    return st.lists(record, min_size=1, max_size=2)


@st.composite
def files(draw: st.DrawFn) -> ExchangeFile:
    count = draw(st.integers(1, 8))
    numbers = draw(st.lists(st.integers(1, 10**6), min_size=count, max_size=count, unique=True))
    made = [Instance(number, tuple(draw(records(count)))) for number in range(1, count + 1)]
    names = dict(zip(range(1, count + 1), numbers, strict=True))
    turned = [Instance(names[one.number], tuple(renamed(r, names) for r in one.records)) for one in made]
    return ExchangeFile(HEADER, tuple(turned))


def renamed(record: Record, names: dict[int, int]) -> Record:
    def turn(value: Value) -> Value:
        match value:
            case Reference(number):
                return Reference(names[number])
            case Typed(keyword, inner):
                return Typed(keyword, turn(inner))
            case tuple():
                return tuple(turn(one) for one in value)
            case _:
                return value

    return Record(record.keyword, tuple(turn(value) for value in record.values))


@pytest.mark.slow
@given(files())
@settings(max_examples=examples(60), deadline=None)
def test_reading_what_was_written_gives_the_same_text_and_the_same_content(file: ExchangeFile) -> None:
    text = write_exchange(file)
    back, findings = read_exchange(SourceText("a.stp", text))
    assert findings == ()
    assert write_exchange(back) == text
    assert replace(back, places=None) == canonical(file)


@given(files(), st.integers(1, 10**9))
@settings(max_examples=examples(20), deadline=None)
def test_the_numbers_of_the_instances_do_not_count(file: ExchangeFile, shift: int) -> None:
    names = {one.number: one.number + shift for one in file.instances}
    moved = tuple(
        Instance(names[one.number], tuple(renamed(r, names) for r in one.records)) for one in file.instances
    )
    assert write_exchange(replace(file, instances=moved)) == write_exchange(file)


@pytest.mark.parametrize(
    ("number", "text"),
    [
        (0.0, "0."),
        (-0.0, "0."),
        (1.0, "1."),
        (0.1, "0.1"),
        (1e-5, "1.E-5"),
        (2.5e-3, "0.0025"),
        (2.1e7, "21000000."),
        (1e300, "1.E300"),
        (-1.25e-8, "-1.25E-8"),
    ],
)
def test_real_numbers_have_the_fewest_digits_and_a_point(number: float, text: str) -> None:
    file = ExchangeFile(HEADER, (Instance(1, (Record("A", (number,)),)),))
    assert f"#1=A({text});" in write_exchange(file)


@pytest.mark.parametrize("number", [inf, -inf, nan])
def test_numbers_that_are_not_finite_cannot_be_written(number: float) -> None:
    with pytest.raises(ValueError, match="finite"):
        write_exchange(ExchangeFile(HEADER, (Instance(1, (Record("A", (number,)),)),)))


def test_an_unknown_entity_is_written_as_it_was_read() -> None:
    """The form of the lines is that of the canonical text; entities of others keep all their parameters."""
    line = "#1=!MY_COOLING_JACKET('\\X2\\00E9\\X0\\',#2,(.A.,(1,2.5)),T(\"0F\"),$,*);"
    text = write_exchange(ExchangeFile(HEADER, ())).replace("DATA;\n", f"DATA;\n{line}\n#2=(A()B(3));\n")
    file, findings = read_exchange(SourceText("a.stp", text))
    assert findings == ()
    assert write_exchange(file) == text


def test_instances_are_numbered_depth_first_from_those_that_nobody_refers_to() -> None:
    rows = [(10, ()), (20, (10,)), (30, (40, 20)), (40, (10,)), (50, (60,)), (60, (50,))]
    file = ExchangeFile(
        HEADER, tuple(Instance(n, (Record(f"E{n}", tuple(map(Reference, refs))),)) for n, refs in rows)
    )
    order = [instance.keyword for instance in canonical(file).instances]
    assert order == ["E30", "E40", "E10", "E20", "E50", "E60"]
