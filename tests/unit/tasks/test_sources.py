"""Our own Prolog: nothing is wrong with it, since it is loaded unchecked."""

from importlib.resources import files

import pytest

from ropsim.core import SourceText
from ropsim.prolog import Engine, GoalError
from ropsim.tasks.host import SOURCES


def test_nothing_is_wrong_with_our_own_prolog_and_what_is_wrong_is_told() -> None:
    engine = Engine()
    for name in SOURCES:
        text = files("ropsim.tasks").joinpath("pl", f"{name}.pl").read_text("utf-8")
        assert engine.check(SourceText(f"{name}.pl", text)) == ()
    engine.load_source(SourceText("own.pl", ":- module(own, []).\np(1).\n"))
    assert engine.once("own:p(X)") == {"X": 1}
    with pytest.raises(GoalError, match="P105"):
        engine.load_source(SourceText("bad.pl", ":- module(bad, [missing/1]).\np(1).\n"))
