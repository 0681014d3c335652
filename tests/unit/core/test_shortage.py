"""A lack of memory is a finding; other exceptions are none."""

import errno

import pytest

from ropsim.cli import main as command
from ropsim.core import shortage


@pytest.mark.parametrize(
    "error",
    [
        MemoryError(),
        MemoryError("Unable to allocate 7 TiB"),
        OSError(errno.ENOMEM, "Cannot allocate memory"),
        ImportError("libx.so: failed to map segment from shared object: Cannot allocate memory"),
    ],
)
def test_a_lack_of_memory_is_a_finding(
    error: Exception, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    found = shortage(error)
    assert found is not None
    assert found.code == "X920"

    def lacking(*_anything: object) -> None:
        raise error

    monkeypatch.setattr("ropsim.cli.commands.explain.explain", lacking)
    monkeypatch.setattr("ropsim.cli.terminal.output.Output.text", lacking)
    assert command.main(["explain", "X920"]) == 1
    told = capsys.readouterr().err
    assert "error[X920] out-of-memory" in told
    assert "bug in ropsim" not in told


@pytest.mark.parametrize("error", [OSError(errno.ENOENT, "no"), ImportError("no module"), ValueError("12")])
def test_other_exceptions_are_none(error: Exception) -> None:
    assert shortage(error) is None
