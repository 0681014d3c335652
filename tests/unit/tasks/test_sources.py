"""Our own Prolog: nothing is wrong with it, since it is loaded unchecked."""

from importlib.resources import files

import pytest

from ropsim.core import SourceText
from ropsim.prolog import Engine, GoalError, Preparation
from ropsim.tasks.testing import SOURCES


def test_nothing_is_wrong_with_our_own_prolog_and_what_is_wrong_is_told() -> None:
    engine = Engine()
    for name in SOURCES:
        text = files("ropsim.tasks").joinpath("pl", f"{name}.pl").read_text("utf-8")
        assert engine.check(SourceText(f"{name}.pl", text)) == ()
    own = Preparation(sources=(SourceText("own.pl", ":- module(own, []).\np(1).\n"),))
    assert Engine(preparation=own).once("own:p(X)") == {"X": 1}
    bad = Engine(
        preparation=Preparation(sources=(SourceText("bad.pl", ":- module(bad, [missing/1]).\np(1).\n"),))
    )
    for _ in range(2):
        with pytest.raises(GoalError, match="P105"):
            bad.once("true")
