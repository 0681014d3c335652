"""Lines to statements: a result depends on the characters of its line only."""

import pytest

from ropsim.core import SourceText
from ropsim.language import nodes
from ropsim.language.testing import (
    Assign,
    Broken,
    Call,
    ContractClause,
    Motion,
    TaskHeader,
    logical_lines,
    parse_line,
)
from support.tasks import codes


def test_the_same_characters_give_the_same_node() -> None:
    assert parse_line("mov part above 50 mm") == parse_line("mov part above 50 mm")


def test_positions_are_offsets_in_the_line() -> None:
    statement, fault = parse_line("  mov part speed 30 %  # slowly")
    assert fault is None
    assert isinstance(statement, Motion)
    assert (statement.start, statement.end) == (2, 21)
    assert (statement.target.start, statement.target.end) == (6, 10)


@pytest.mark.parametrize("line", ["open.", "open .", "open # x", "open // x", "OPEN"])
def test_final_period_comment_and_case_change_nothing(line: str) -> None:
    statement, fault = parse_line(line)
    assert fault is None
    assert type(statement).__name__ == "Gripper"


def test_units_belong_to_numbers_only() -> None:
    statement, _ = parse_line("m = s * 5 m")
    assert isinstance(statement, Assign)
    assert isinstance(statement.value, nodes.Binary)
    assert isinstance(statement.value.left, nodes.Name)
    assert isinstance(statement.value.right, nodes.Number)
    assert statement.value.right.unit == "m"


def test_one_member_in_parentheses_is_grouping() -> None:
    statement, _ = parse_line("Pick (infeed)")
    assert isinstance(statement, Call)
    assert isinstance(statement.arguments[0].value, nodes.Name)


def test_p_before_a_parenthesis_is_only_a_marker() -> None:
    statement, _ = parse_line("Palletize p (13,5,8), (6,3,2), 0.1, 6.")
    assert isinstance(statement, Call)
    assert [type(a.value).__name__ for a in statement.arguments] == ["Tuple", "Tuple", "Number", "Number"]


def test_task_names_may_be_quoted_and_numbered() -> None:
    statement, fault = parse_line('3. Task "Palletize"')
    assert fault is None
    assert isinstance(statement, TaskHeader)
    assert (statement.name.text, statement.parameters) == ("Palletize", None)


def test_contracts_are_not_parsed() -> None:
    statement, fault = parse_line("  Needs “anything” at all")
    assert fault is None
    assert isinstance(statement, ContractClause)


def test_a_broken_line_keeps_its_head_and_name() -> None:
    statement, fault = parse_line("for each slot inn slots")
    assert fault is not None
    assert isinstance(statement, Broken)
    assert (statement.head, statement.name) == ("for", "slot")


@pytest.mark.parametrize(
    ("line", "kind"),
    [
        ("x = " + "(" * 200 + "1" + ")" * 200, "L113"),
        ("x = " + "-" * 500 + "1", "L113"),
        ("x = " + "+".join("1" * 400), "L113"),
        ("x" * 5000, "L114"),
        ("x = 1" + "0" * 100, "L104"),
        ('print "', "L103"),
        ("mov \x00", "L102"),
    ],
)
def test_absurd_lines_have_a_finding(line: str, kind: str) -> None:
    _, fault = parse_line(line)
    assert fault is not None
    assert fault.kind.code == kind


def test_lines_are_joined_after_a_parenthesis_but_not_into_a_statement() -> None:
    lines = [(x.number, x.text) for x in logical_lines(SourceText("t", "a (1,\n2)\nb (3\nmov x\nc \\\nd"))]
    assert lines == [(1, "a (1,\n2)"), (3, "b (3"), (4, "mov x"), (5, "c  \nd")]


@pytest.mark.parametrize("middle", ["elseif(n > 3)", "ELSEIF(n > 3)", "else# note", "else// note", "else"])
def test_the_middle_of_an_if_is_known_without_a_blank_behind_it(middle: str) -> None:
    text = f"program p\nn = 4\nif(n > 5)\n  print 1\n{middle}\n  print 2\nendif\n"
    assert codes(text) == []


@pytest.mark.parametrize(
    ("line", "meant"),
    [
        ("lin a at 3 befor end do set glue on", "before"),
        ("lin a at 3 after strat do set glue on", "start"),
        ("lin a stor b", "store"),
        ("lin a blnd 5", "blend"),
        ("lin a unitl go", "until"),
        ("lin a until go timeot 3", "timeout"),
        ("lin a speed 30 accc 20", "acc"),
        ("wait until go timeot 3", "timeout"),
        ("set speeed 20", "speed"),
    ],
)
def test_a_misspelt_word_inside_a_statement_is_answered_with_the_nearest(line: str, meant: str) -> None:
    _, fault = parse_line(line)
    assert fault is not None
    assert fault.hint.startswith(f"did you mean `{meant}")


def test_what_is_near_to_no_word_gets_none() -> None:
    _, fault = parse_line("lin a qqqqq 5")
    assert fault is not None
    assert fault.hint == ""


def test_words_of_a_posture_stand_in_parentheses() -> None:
    _, fault = parse_line("lin (1, 2, 3; down, config left up)")
    assert fault is not None
    assert (fault.hint, fault.message) == (
        "write the words of a posture in parentheses: `config (left, up)`",
        "expected `(`, found `left`",
    )


@pytest.mark.parametrize(
    ("text", "count"),
    [
        ("(" + '"\\' * 100_000 + "\n" + "1,\n" * 19 + "mov home\n", 3),
        ("(" + '"\\"' * 100_000 + "\nmov home\n", 3),
        ("(\nend" + " " * 300_000 + "." + " " * 300_000 + "x\n", 2),
    ],
    ids=["quotes", "closed", "blanks"],
)
def test_joining_lines_reads_nothing_twice(text: str, count: int) -> None:
    """Where a repetition gives back what it has read, each of these takes minutes to hours."""
    assert sum(1 for _ in logical_lines(SourceText("x.task", text))) == count
