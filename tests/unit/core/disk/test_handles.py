"""A replacement that Windows refuses for a moment is tried again, a limited number of times."""

import errno
from pathlib import Path

import pytest

from ropsim.core import replace_file, retried
from ropsim.core.disk.handles import PAUSES


class HeldError(PermissionError):
    """What Windows raises: such errors carry its own number in `winerror`, on no other system."""

    def __init__(self, winerror: int) -> None:
        super().__init__(errno.EACCES, "the file is in use")
        self.winerror = winerror


class Operation:
    """Fails with the given errors, one after the other, then succeeds; counts its calls."""

    def __init__(self, *errors: OSError) -> None:
        self.errors = list(errors)
        self.calls = 0

    def __call__(self) -> None:
        self.calls += 1
        if self.errors:
            raise self.errors.pop(0)


@pytest.fixture
def pauses(monkeypatch: pytest.MonkeyPatch) -> list[float]:
    """Return the pauses that are made; nobody waits."""
    made: list[float] = []
    monkeypatch.setattr("ropsim.core.disk.handles.sleep", made.append)
    return made


@pytest.mark.parametrize("number", [5, 32])
@pytest.mark.parametrize("failures", range(len(PAUSES) + 1))
def test_an_operation_succeeds_after_as_many_failures(
    pauses: list[float], number: int, failures: int
) -> None:
    operation = Operation(*[HeldError(number)] * failures)
    retried(operation)
    assert operation.calls == failures + 1
    assert pauses == list(PAUSES[:failures])


def test_attempts_are_limited_and_the_error_is_raised(pauses: list[float]) -> None:
    last = HeldError(5)
    operation = Operation(*[HeldError(32)] * len(PAUSES), last, HeldError(32))
    with pytest.raises(HeldError) as raised:
        retried(operation)
    assert raised.value is last
    assert operation.calls == len(PAUSES) + 1
    assert 0.1 < sum(pauses) < 1.0


@pytest.mark.parametrize(
    "error",
    [
        PermissionError(errno.EACCES, "no write permission"),
        HeldError(19),
        FileNotFoundError(errno.ENOENT, "gone"),
        OSError(errno.ENOSPC, "full"),
    ],
    ids=["permission of POSIX", "write-protected disk", "gone", "full"],
)
def test_other_errors_are_raised_at_once(pauses: list[float], error: OSError) -> None:
    operation = Operation(error)
    with pytest.raises(type(error)) as raised:
        retried(operation)
    assert raised.value is error
    assert (operation.calls, pauses) == (1, [])


def test_a_file_is_replaced_when_its_reader_lets_go(
    pauses: list[float], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    place = tmp_path / "report.html"
    place.write_bytes(b"old")
    refusals = [HeldError(32), HeldError(5)]
    replace = Path.replace

    def held(source: Path, target: Path) -> Path:
        if refusals:
            raise refusals.pop(0)
        return replace(source, target)

    monkeypatch.setattr(Path, "replace", held)
    replace_file(place, b"new")
    assert place.read_bytes() == b"new"
    assert pauses == list(PAUSES[:2])
    assert [one.name for one in tmp_path.iterdir()] == ["report.html"]
