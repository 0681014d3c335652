import io

import pytest

from ropsim.cli.testing import Progress
from ropsim.codegen.testing import begin_compiling


class Clock:
    """A clock that is set by hand."""

    def __init__(self) -> None:
        self.time = 100.0

    def __call__(self) -> float:
        return self.time


class Terminal(io.StringIO):
    encoding = "utf-8"

    def isatty(self) -> bool:
        return True


class OldTerminal(Terminal):
    encoding = "ascii"


def tell(stream: io.StringIO, *steps: tuple[float, float, str]) -> str:
    """Return what is written for steps of (seconds since the start, share, text), before leaving."""
    clock = Clock()
    with Progress("simulating", stream, clock) as progress:
        for seconds, share, text in steps:
            clock.time = 100.0 + seconds
            progress(share, text)
        return stream.getvalue()


@pytest.mark.parametrize("stream", [io.StringIO(), Terminal()])
def test_short_work_is_silent(stream: io.StringIO) -> None:
    tell(stream, (0.2, 0.5, "a"), (0.9, 1.0, "b"))
    assert stream.getvalue() == ""


def test_terminal_shows_bar_share_text_and_time_left() -> None:
    shown = tell(Terminal(), (10.0, 0.25, "move 54"))
    assert shown == "\r█████░░░░░░░░░░░░░░░  25%  simulating: move 54  (10 s, 30 s left)\x1b[K"


def test_line_is_wiped_at_the_end() -> None:
    stream = Terminal()
    tell(stream, (2.0, 0.5, "x"))
    assert stream.getvalue().endswith("\r\x1b[K")


def test_terminal_without_block_characters_gets_a_plain_bar() -> None:
    assert "##########.........." in tell(OldTerminal(), (2.0, 0.5, "ü"))


def test_line_never_wraps(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("COLUMNS", "40")
    shown = tell(Terminal(), (2.0, 0.5, "x" * 200))
    assert len(shown.removeprefix("\r").removesuffix("\x1b[K")) < 40


def test_log_file_gets_sparse_plain_lines() -> None:
    steps = [(0.5 * k, k / 40.0, "x") for k in range(1, 40)]
    lines = tell(io.StringIO(), *steps).splitlines()
    assert 3 <= len(lines) <= 5
    assert lines[0] == "  5%  simulating: x  (1 s, 19 s left)"


def test_text_cannot_control_the_terminal() -> None:
    assert "\x1b[31m" not in tell(Terminal(), (2.0, 0.5, "\x1b[31m\n"))


@pytest.mark.parametrize(("share", "shown"), [(7.0, "100%"), (-1.0, "0%")])
def test_share_is_clipped(share: float, shown: str) -> None:
    assert shown in tell(Terminal(), (2.0, share, "x"))


def test_work_whose_share_nobody_knows_shows_text_and_time_only() -> None:
    shown = tell(Terminal(), (3.0, float("nan"), "motion 12"))
    assert shown == "\rsimulating: motion 12  (3 s)\x1b[K"


@pytest.mark.parametrize(
    ("stream", "shown"),
    [
        (Terminal(), "\rsimulating: compiling function 2 (once: later runs load it)  (2 s)\x1b[K"),
        (io.StringIO(), "simulating: compiling function 2 (once: later runs load it)  (2 s)\n"),
    ],
)
def test_what_is_compiled_meanwhile_is_counted(stream: io.StringIO, shown: str) -> None:
    clock = Clock()
    with Progress("simulating", stream, clock):
        begin_compiling()
        clock.time += 2.0
        begin_compiling()
        assert stream.getvalue() == shown
    begin_compiling()
    assert stream.getvalue().startswith(shown)
    assert "3" not in stream.getvalue()


def test_time_of_compiling_does_not_count_in_the_time_left() -> None:
    stream, clock = io.StringIO(), Clock()
    with Progress("simulating", stream, clock) as progress:
        for seconds in (1.0, 30.0):
            clock.time = 100.0 + seconds
            begin_compiling()
        clock.time = 161.0
        progress(0.0, "move 1")
        clock.time = 163.0
        progress(0.1, "move 2")
        clock.time = 169.0
        progress(0.3, "move 4")
    assert stream.getvalue().splitlines()[-1] == " 30%  simulating: move 4  (69 s, 21 s left)"
