"""Terms as canonical text: what is written is read again as the same term, and what is no term is refused."""

import math
from fractions import Fraction

import pytest
from hypothesis import given
from hypothesis import strategies as st

from ropsim.prolog import Atom, Engine, Struct, Term, UnreadableError, Var, read_term, write_term
from support.characters import ANY

NAMES = st.text(st.characters(exclude_categories=["Cs"], exclude_characters="\0"), max_size=8)
SIMPLE = st.one_of(
    NAMES.map(Atom),
    NAMES,
    st.integers(-(10**30), 10**30),
    st.floats(allow_nan=False),
    st.fractions(),
    st.from_regex(r"[A-Z_][A-Za-z0-9_]*", fullmatch=True, alphabet=ANY).map(Var),
)
TERMS = st.recursive(
    SIMPLE,
    lambda inner: st.one_of(
        st.lists(inner, max_size=4).map(tuple),
        st.builds(Struct, NAMES, st.lists(inner, max_size=3).map(tuple)),
        st.builds(lambda head, tail: Struct("[|]", (head, tail)), inner, SIMPLE),
    ),
    max_leaves=12,
)


def plain(term: Term) -> Term:
    """Return a term whose whole rationals are integers, as Prolog has them."""
    match term:
        case Fraction(denominator=1):
            return int(term)
        case Struct(name, arguments):
            return Struct(name, tuple(map(plain, arguments)))
        case tuple():
            return tuple(map(plain, term))
        case _:
            return term


@given(TERMS)
def test_what_is_written_is_read_again(term: Term) -> None:
    assert read_term(write_term(term)) == plain(term)


def test_prolog_reads_what_is_written_and_writes_what_is_read() -> None:
    engine = Engine()
    terms: list[Term] = [
        *(
            Atom(name)
            for name in ("a", "A b", "[]", "{}", "it's", "\\", "", "é→É", "\n\t", "-", ":-", "|", "0x", "!")
        ),
        *("", 'say "x"', "a\\b", "\x01", "日本"),
        *(0, -1, 10**40, 1.5, -0.0, 1e300, 5e-324, math.inf, -math.inf, Fraction(-1, 3)),
        (),
        ((), ((),)),
        Struct("-", (1,)),
        Struct("-", (-1,)),
        Struct("{}", (Atom("a"),)),
        Struct("now", ()),
        Struct(":-", (Atom("dynamic"), Struct(",", (Atom("-"), Atom(";"))))),
        Struct("[|]", (1, Struct("[|]", (2, Atom("end"))))),
    ]
    for term in terms:
        answer = engine.once(f"X = {write_term(term)}")
        assert answer is not None
        assert (answer["X"], math.copysign(1.0, answer["X"]) if isinstance(answer["X"], float) else 1.0) == (
            term,
            math.copysign(1.0, term) if isinstance(term, float) else 1.0,
        )


def test_variables_of_an_answer_are_the_same_where_prolog_has_the_same() -> None:
    answer = Engine().once("X = f(A, B, A), B = C")
    assert answer is not None
    assert answer["X"] == Struct("f", (answer["A"], answer["B"], answer["A"]))
    assert answer["B"] == answer["C"] != answer["A"]


@pytest.mark.parametrize(
    "text",
    [
        "",
        "f(",
        "f(a",
        "f(a,)",
        "[a",
        "[a|b|c]",
        "[a|]",
        "[|a]",
        "(a,b)",
        "(a",
        "a b",
        "'a",
        '"a',
        "f)a",
        "a:-b",
        ",",
        "_{a:1}",
    ],
)
def test_what_is_no_canonical_term_is_refused(text: str) -> None:
    with pytest.raises(UnreadableError):
        read_term(text)


@given(st.text("ab(),[]|'\"\\ 1.x_-", max_size=30))
def test_any_text_is_read_or_refused(text: str) -> None:
    try:
        read_term(text)
    except UnreadableError as error:
        assert str(error)  # noqa: PT017 - most texts are refused, not all


@pytest.mark.parametrize("text", ["f(" * 20_000 + "a" + ")" * 20_000, "[" * 20_000 + "]" * 20_000])
def test_depth_does_not_matter(text: str) -> None:
    assert len(write_term(read_term(text))) == len(text)
    with pytest.raises(UnreadableError):
        read_term(text[:-1])


def test_a_number_of_too_many_digits_is_refused_at_once() -> None:
    with pytest.raises(UnreadableError, match="1000000 digits; at most 4300"):
        read_term("9" * 1_000_000)


@pytest.mark.parametrize("value", [True, None, [1]])
def test_values_that_are_no_terms_are_not_written(value: object) -> None:
    with pytest.raises(TypeError):
        write_term(value)  # type: ignore[arg-type] # on purpose
    with pytest.raises(ValueError, match="no name of a variable"):
        write_term(Var("a b"))
