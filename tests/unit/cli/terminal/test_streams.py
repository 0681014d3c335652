"""Printing goes on, or ends with a reason, whatever becomes of the streams."""

import io
import os
import sys
from pathlib import Path

import pytest

from ropsim.cli.testing import OutputLostError, prepare_streams, say


def broken_pipe() -> io.TextIOWrapper:
    """Return a stream whose reader has gone away."""
    reader, writer = os.pipe()
    os.close(reader)
    return os.fdopen(writer, "w")


def test_a_reader_that_goes_away_is_no_error() -> None:
    with broken_pipe() as stream:
        say("one", stream)
        say("two", stream)


def test_a_full_disk_is_an_error_with_its_reason() -> None:
    if not Path("/dev/full").is_char_device():
        pytest.skip("this system has no /dev/full")
    with open("/dev/full", "w") as stream, pytest.raises(OutputLostError, match="No space left"):  # noqa: PTH123
        say("one", stream)


def test_a_character_that_the_stream_does_not_know_is_shown_as_a_question_mark(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    raw = io.BytesIO()
    monkeypatch.setattr(sys, "stdout", io.TextIOWrapper(raw, encoding="ascii"))
    prepare_streams()
    say("0.2° N·m", sys.stdout)
    assert raw.getvalue() == b"0.2? N?m\n"


def test_a_stream_that_was_closed_at_the_start_swallows_everything(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(sys, "stdout", None)
    prepare_streams()
    say("one", sys.stdout)
    assert not sys.stdout.isatty()
    sys.stdout.close()
