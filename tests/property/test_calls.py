"""Laws of calls: a list of arguments means the same whether the result of the task is kept or dropped."""

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from ropsim import icr
from ropsim.language import Compiled
from support.examples import examples
from support.tasks import compiled

HEAD = """program p
units mm, deg, s
task T(x: num, n: bool = false, q: int = 2) -> num
  print x, n, q
  return x
endp
n = false
b = true
i = 4
k = 0.5
"""
"""Variables of which one has the name of a parameter."""
TAIL = "\nprint n, b, i, k"
"""Reads all of them, so that no hint of the compiler tells which were not."""
EXAMPLES = settings(max_examples=examples(300), derandomize=True)
WHOLE = st.sampled_from(["i", "3", "4", "i + 1", "-i", "2 * (i + 3)", "i mod 3"])
LEAVES = st.one_of(
    st.sampled_from(["n", "b", "true", "false", "b is on", "n is not true"]),
    st.tuples(WHOLE, st.sampled_from(["=", "==", "<", "<>"]), WHOLE).map(" ".join),
)


def _composed(inner: st.SearchStrategy[str]) -> st.SearchStrategy[str]:
    binary = st.tuples(inner, st.sampled_from(["or", "and"]), inner).map(" ".join)
    return st.one_of(binary, inner.map("not {}".format), inner.map("({})".format))


TRUTHS = st.recursive(LEAVES, _composed, max_leaves=4)
GIVING = st.sampled_from([" = ", " := ", "=", " == "])


def _named(name: str, values: st.SearchStrategy[str]) -> st.SearchStrategy[str]:
    return st.one_of(values, st.tuples(st.just(name), GIVING, values).map("".join))


RIGHT = st.tuples(_named("x", WHOLE), _named("n", TRUTHS), _named("q", WHOLE)).map(list)
"""One value for each parameter, in order; with a name where a comparison is none."""
WRONG = st.lists(
    st.one_of(
        *(_named(name, st.one_of(WHOLE, TRUTHS)) for name in ("x", "n", "q", "b", "r", "N")),
        st.sampled_from(["7 mm", "not", "x =", "= 3", "x = = 3", "", "b = b = b"]),
    ),
    max_size=4,
)
LISTS = st.one_of(RIGHT, WRONG).map(", ".join)
LOCATION = (
    HEAD.replace("x: num", "l: loc").replace("print x", "print l").replace("return x", "return l.x / 1 mm")
)
"""The same with a location in the first place."""
PLACES = [
    "300, 0, 100",
    "(300, 0, 100)",
    "(300, 0, 100), b",
    "(300, 0, 100), q = 3",
    "l = (300, 0, 100)",
    "300, 0, 100; rz 5",
    "300, 0, 100, 3, 4",
    "1, 2",
    "infeed",
    "infeed, q = 7, n = not n",
    "infeed; rz 5",
    "infeed, n = false, q = 3",
    "",
]


def told(result: Compiled) -> list[tuple[object, ...]]:
    """Return what is found, and where: the name of the task stands at one place in both texts."""
    return [(one.code, one.message, one.hint, one.span) for one in result.diagnostics]


def assert_alike(head: str, call: str) -> None:
    dropped = compiled(f"{head}    {call}{TAIL}")
    kept = compiled(f"{head}k = {call}{TAIL}")
    assert told(dropped) == told(kept)
    assert (dropped.icr is None) == (kept.icr is None)
    if dropped.icr is not None and kept.icr is not None:
        assert icr.disassemble(dropped.icr).replace("POP", "STORE k") == icr.disassemble(kept.icr)


@EXAMPLES
@given(LISTS)
def test_a_list_of_arguments_means_the_same_whether_the_result_is_kept_or_not(arguments: str) -> None:
    assert_alike(HEAD, f"T({arguments})")


@pytest.mark.parametrize("head", [HEAD, LOCATION])
@pytest.mark.parametrize("blank", ["", " "])
@pytest.mark.parametrize("arguments", PLACES)
def test_a_parenthesis_is_the_same_location_or_list(head: str, blank: str, arguments: str) -> None:
    assert_alike(head, f"T{blank}({arguments})")
