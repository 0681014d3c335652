import re
from dataclasses import replace

from ropsim.core import Diagnostic, Label, Severity, SourceText, Span, TextEdit
from ropsim.views import Style, diagnostic_text, diagnostics_text
from support.golden import GOLDEN, check_golden

SOURCE = SourceText(
    "palletize.task",
    "\n" * 13
    + "  mov slot(i, j)\n\tmove 日本 x\u202e yy\x1b[31m\n"
    + "a" * 500
    + "BAD"
    + "c" * 500
    + "\nbegin\n  x\n  y\nend\n"
    + "z\n" * 20,
)
SOURCES = {SOURCE.name: SOURCE}


def error(span: Span | None, message: str = "wrong", label: str = "here") -> Diagnostic:
    return Diagnostic("N201", "unknown-name", Severity.ERROR, message, span, label)


def mark_of(text: str) -> tuple[str, str]:
    """The first quoted line and the marks under it, without the gutter."""
    lines = text.splitlines()
    k = next(k for k, line in enumerate(lines) if set(line.split("|")[-1]) & set("^") and "|" in line)
    return lines[k - 1].split("| ", 1)[1], lines[k].split("| ", 1)[1]


def test_layout_is_that_of_rustc() -> None:
    finding = Diagnostic(
        "M502",
        "joint-out-of-range",
        Severity.ERROR,
        "command pose needs joint `3` at 171.4°, the limit is 135.0°",
        SOURCE.span(14, 3, 14),
        "reached for i = 5, j = 6 (t = 41.20 s)",
        (),
        ("two of the four postures reach the position, neither within limits",),
        "lower `pallet` by 0.12 m, or allow posture `elbow-down`",
    )
    assert diagnostic_text(finding, SOURCES, Style.PLAIN) == (
        "error[M502] joint-out-of-range: command pose needs joint `3` at 171.4°, the limit is 135.0°\n"
        "  --> palletize.task:14:3\n"
        "14 |   mov slot(i, j)\n"
        "   |   ^^^^^^^^^^^^^^ reached for i = 5, j = 6 (t = 41.20 s)\n"
        "   = note: two of the four postures reach the position, neither within limits\n"
        "   = hint: lower `pallet` by 0.12 m, or allow posture `elbow-down`"
    )


def test_everything_at_once_looks_as_in_the_golden_file() -> None:
    findings = [
        error(SOURCE.span(14, 7, 4)),
        error(SOURCE.span(14, 7, 4)),
        Diagnostic(
            "T301",
            "unit-mismatch",
            Severity.WARNING,
            "wide and hidden\x07 characters",
            SOURCE.span(15, 10),
            "here",
            (Label(SOURCE.span(15, 2, 4), "first"), Label(SOURCE.span(17, 1, 5), "opened here")),
            fix=TextEdit(SOURCE.span(15, 10), "y"),
        ),
        error(SOURCE.span(16, 501, 3), "in a long line"),
        error(Span(SOURCE.name, 17, 3, 20, 4), "over several lines"),
        error(Span(SOURCE.name, 17, 1, 38, 1), "over many lines"),
        error(Span("other.task", 3, 1, 3, 2), "without its source"),
        Diagnostic("S701", "no-place", Severity.HINT, "without a place", None),
    ]
    check_golden(GOLDEN / "views" / "diagnostics.txt", diagnostics_text(findings, SOURCES, Style.PLAIN))


def test_marks_stand_under_what_they_mark_after_tabs_and_wide_characters() -> None:
    quoted, marks = mark_of(diagnostic_text(error(SOURCE.span(15, 10)), SOURCES, Style.PLAIN))
    assert quoted.startswith("    move 日本 x")
    columns_before_x = len("    move ") + 2 * len("日本") + 1
    assert marks.index("^") == columns_before_x


def test_control_and_direction_characters_are_made_visible() -> None:
    text = diagnostic_text(error(SOURCE.span(15, 2)), SOURCES, Style.PLAIN)
    assert "\x1b" not in text
    assert "␛[31m" in text
    assert "<U+202E>" in text


def test_hostile_message_cannot_colour_the_terminal_or_fake_lines() -> None:
    text = diagnostic_text(error(None, "a\x1b[2Jb\nerror[X]: fake"), {}, Style.PLAIN)
    assert text == "error[N201] unknown-name: a␛[2Jb␊error[X]: fake"


def test_long_lines_are_cut_around_the_mark() -> None:
    quoted, marks = mark_of(diagnostic_text(error(SOURCE.span(16, 501, 3)), SOURCES, Style.PLAIN))
    at = marks.index("^")
    assert len(quoted) <= 100
    assert quoted[at : at + 3] == "BAD"
    assert quoted.startswith("…")
    assert quoted.endswith("…")


def test_line_of_megabytes_is_quoted_in_part() -> None:
    source = SourceText("big.task", "x" * 3_000_000)
    text = diagnostic_text(error(source.span(1, 2_000_000)), {"big.task": source}, Style.PLAIN)
    assert len(text) < 500


def test_span_beyond_the_text_is_clipped() -> None:
    text = diagnostic_text(error(Span(SOURCE.name, 999, 10**9, 999, 10**9 + 2)), SOURCES, Style.PLAIN)
    assert len(text) < 200
    assert "^ here" in text


def test_many_lines_show_only_the_ends() -> None:
    text = diagnostic_text(error(Span(SOURCE.name, 17, 1, 38, 1)), SOURCES, Style.PLAIN)
    assert "\n...\n" in text
    assert len(text.splitlines()) < 20


def test_repeats_are_told_once_with_their_passes() -> None:
    findings = [
        Diagnostic("M502", "x", Severity.ERROR, f"{k}", SOURCE.span(14), data={"pass": k}) for k in (2, 3, 5)
    ]
    text = diagnostics_text(findings, SOURCES, Style.PLAIN)
    assert text.count("error[M502]") == 1
    assert "found 3 times here (passes 2-3, 5)" in text
    assert text.endswith("\n\n3 errors\n")


def test_no_diagnostics_are_no_text() -> None:
    assert diagnostics_text((), {}, Style.PLAIN) == ""


def test_colour_changes_nothing_but_colour() -> None:
    finding = error(SOURCE.span(14, 7, 4))
    coloured = diagnostics_text([finding], SOURCES, Style.COLOR)
    assert coloured != diagnostics_text([finding], SOURCES, Style.PLAIN)
    assert re.sub(r"\x1b\[[0-9;]*m", "", coloured) == diagnostics_text([finding], SOURCES, Style.PLAIN)


def test_a_span_of_a_whole_line_marks_the_text_between_its_blanks() -> None:
    text = diagnostic_text(error(Span.whole_line(SOURCE.name, 14)), SOURCES, Style.PLAIN)
    assert mark_of(text) == ("  mov slot(i, j)", "  ^^^^^^^^^^^^^^ here")


def test_of_many_further_places_the_first_ones_are_shown() -> None:
    further = tuple(Label(SOURCE.span(line, 1, 1), "here, too") for line in range(20, 41))
    text = diagnostic_text(replace(error(SOURCE.span(14, 3, 3)), secondary=further), SOURCES, Style.PLAIN)
    assert text.count("here, too") == 20
    assert "= note: 1 further place is not shown" in text
