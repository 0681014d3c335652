import pytest

from ropsim.core import Category, Severity, SourceText, Span, catalogue, define


def test_a_kind_makes_diagnostics_with_its_code_and_severity() -> None:
    kind = define("Q999", "only-in-this-test", Severity.WARNING, "a test", "Nothing to mend.")
    span = Span.on_line("a.task", 3, 7, 2)
    found = kind.at(span, "found `x`, allowed `y`", hint="write `y`", data={"x": 1})
    assert (found.code, found.slug, found.severity) == ("Q999", "only-in-this-test", Severity.WARNING)
    assert str(found) == "a.task:3:7: warning[Q999] only-in-this-test: found `x`, allowed `y`"
    assert catalogue()["Q999"] is kind


def test_findings_have_the_category_of_their_kind() -> None:
    plain = define("Q995", "plain-test", Severity.ERROR, "a test", "Nothing to mend.")
    ended = define("Q996", "ended-test", Severity.ERROR, "a test", "Nothing to mend.", Category.UNFINISHED)
    assert (plain.at(None, "x").category, ended.at(None, "x").category) == (
        Category.OTHER,
        Category.UNFINISHED,
    )


def test_a_code_cannot_be_used_twice() -> None:
    define("Q998", "first-use", Severity.ERROR, "one", "One.")
    with pytest.raises(ValueError, match="Q998"):
        define("Q998", "second-use", Severity.ERROR, "two", "Two.")
    with pytest.raises(ValueError, match="first-use"):
        define("Q997", "first-use", Severity.ERROR, "two", "Two.")


def test_source_lines_count_from_one_with_any_line_end() -> None:
    text = SourceText("a", "one\r\ntwo\rthree\n")
    assert (text.line(1), text.line(2), text.line(3), text.line(4), text.line(9)) == (
        "one",
        "two",
        "three",
        "",
        "",
    )


def test_joined_spans_reach_from_the_first_start_to_the_last_end() -> None:
    joined = Span.on_line("a", 2, 5, 3).to(Span.on_line("a", 4, 1, 6))
    assert joined == Span("a", 2, 5, 4, 7)
