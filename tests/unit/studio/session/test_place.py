"""Where a studio is found again: kept for the user alone, for a week, and never trusted to be whole."""

import json
import stat
import sys
from pathlib import Path

import pytest

from ropsim.studio.testing import LONGEST, Place, keep_place, place_of

SECRET = 32 * "s"
NOW = 1_800_000_000.0  # [s since 1970]


@pytest.fixture
def project(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.setenv("ROPSIM_STATE_HOME", str(tmp_path / "state"))
    return tmp_path / "cell"


def kept_file(project: Path) -> Path:
    """Keep a place and return the file in which it is."""
    keep_place(project, Place(40123, SECRET, NOW))
    (file,) = (project.parent / "state").rglob("*.json")
    return file


def test_a_place_is_found_again(project: Path) -> None:
    place = Place(40123, SECRET, NOW)
    keep_place(project, place)
    assert place_of(project, NOW) == place
    assert place_of(project.parent / "other", NOW).port == 0


@pytest.mark.skipif(sys.platform == "win32", reason="there the folder of the user is closed to others")
def test_only_the_user_can_read_the_secret(project: Path) -> None:
    assert stat.S_IMODE(kept_file(project).stat().st_mode) == 0o600


@pytest.mark.parametrize("age", [LONGEST + 60.0, -60.0])
def test_a_secret_that_is_old_or_from_the_future_is_made_anew(project: Path, age: float) -> None:
    keep_place(project, Place(40123, SECRET, NOW - age))
    assert place_of(project, NOW).secret != SECRET


def is_new(place: Place) -> bool:
    return place.port == 0 and place.secret != SECRET and len(place.secret) >= len(SECRET)


@pytest.mark.parametrize(
    "content", [b"", b"\0" * 40, b"\xff\xfe", b"null", b"[]", b"{}", b'{"port": 40', b"[" * 100_000]
)
def test_a_damaged_file_gives_a_new_place(project: Path, content: bytes) -> None:
    kept_file(project).write_bytes(content)
    assert is_new(place_of(project, NOW))


@pytest.mark.parametrize(
    "changes",
    [
        {"port": float("inf")},
        {"port": float("nan")},
        {"port": 10**400},
        {"port": 65536},
        {"port": -1},
        {"port": True},
        {"port": "40123"},
        {"made": float("nan")},
        {"made": float("-inf")},
        {"made": None},
        {"secret": ""},
        {"secret": "short"},
        {"secret": 40 * "\n"},
        {"secret": f"{SECRET}\n"},
        {"secret": f"{SECRET}; Domain=example"},
        {"secret": 40 * "ä"},
        {"secret": ["s"]},
    ],
)
def test_an_entry_that_cannot_be_right_gives_a_new_place(project: Path, changes: dict[str, object]) -> None:
    file = kept_file(project)
    file.write_text(json.dumps(json.loads(file.read_bytes()) | changes), "utf-8")
    assert is_new(place_of(project, NOW))
