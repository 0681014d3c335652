"""`--prolog`: both Prologs give the same answers, and one that is not there is told."""

import shutil
from pathlib import Path

import pytest

from ropsim.cli.testing import main
from ropsim.prolog.native.program import COMMAND

CALLS = (["grip infeed"], ["grip infeed", "park (400, 0, 700)"], ["grap infeed"])
CELL = Path(__file__).parents[3] / "examples" / "palletizing"


def told(words: list[str], capsys: pytest.CaptureFixture[str]) -> tuple[int, str, str]:
    code = main(words)
    captured = capsys.readouterr()
    return code, captured.out, captured.err


@pytest.mark.skipif(shutil.which(COMMAND) is None, reason=f"no command `{COMMAND}`")
@pytest.mark.parametrize("calls", CALLS, ids=["possible", "two", "misspelt"])
def test_both_prologs_say_the_same_of_calls(calls: list[str], capsys: pytest.CaptureFixture[str]) -> None:
    built_in, native = (
        told(["task", "check", str(CELL), *calls, "--prolog", which], capsys)
        for which in ("built-in", "native")
    )
    assert built_in == native
    assert built_in[0] in {0, 1}


def test_a_prolog_that_is_not_there_is_told(
    capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(shutil, "which", lambda _: None)
    code, out, err = told(["task", "list", str(CELL), "--prolog", "native"], capsys)
    assert (code, out) == (2, "")
    assert "error[P122] no-native-prolog" in err
