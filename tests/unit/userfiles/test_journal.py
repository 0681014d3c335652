import contextlib
import sys
from contextlib import closing
from pathlib import Path

import pytest

from ropsim.userfiles import Draft, Journal
from ropsim.userfiles.journal import MOST_SLOTS
from support.counted_system import counted

DRAFTS = {"programs/main.task": Draft("mov p\n\ud83e", ""), "cell.toml": Draft("", "ab")}


@pytest.fixture
def project(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.setenv("ROPSIM_STATE_HOME", str(tmp_path / "state"))
    folder = tmp_path / "cell"
    folder.mkdir()
    return folder


def test_the_next_session_finds_what_the_last_one_left(project: Path) -> None:
    with closing(Journal(project)) as first:
        first.write(DRAFTS)
    with closing(Journal(project)) as second:
        assert second.read() == (DRAFTS, ())
    assert list(project.iterdir()) == []  # nothing is ever written into the project


def test_without_drafts_there_is_no_journal(project: Path, tmp_path: Path) -> None:
    with closing(Journal(project)) as journal:
        journal.write(DRAFTS)
        journal.write({})
        assert journal.read() == ({}, ())
    assert list((tmp_path / "state" / "journal").glob("*.json")) == []


def test_two_sessions_of_one_project_keep_apart(project: Path) -> None:
    with closing(Journal(project)) as first, closing(Journal(project)) as second:
        first.write(DRAFTS)
        assert second.read() == ({}, ())
        second.write({"cell.toml": Draft("other", "")})
        assert first.read() == (DRAFTS, ())


@pytest.mark.parametrize(
    "content",
    [
        b"",
        b"{",
        b"[]",
        b"\xff",
        b'{"version":9}',
        b'{"version":1,"documents":{"a":{"text":1,"base":""}}}',
        b"[" * 9999,
    ],
)
def test_a_damaged_journal_is_set_aside_and_told(project: Path, tmp_path: Path, content: bytes) -> None:
    journal = Journal(project)
    journal.close()
    journal.write(DRAFTS)
    place = next((tmp_path / "state" / "journal").glob("*.json"))
    place.write_bytes(content)
    drafts, findings = journal.read()
    assert (drafts, [one.code for one in findings]) == ({}, ["X893"])
    assert place.with_suffix(".damaged").read_bytes() == content
    assert journal.read() == ({}, ())
    place.write_bytes(b"other damage")
    journal.read()
    assert place.with_suffix(".damaged").read_bytes() == content  # the first one is not lost by that
    assert place.with_suffix(".damaged-2").read_bytes() == b"other damage"


@pytest.mark.skipif(sys.platform == "win32", reason="a folder is no file there, by another error")
def test_a_journal_that_cannot_be_read_now_stays(project: Path) -> None:
    with closing(Journal(project)) as journal:
        journal.write(DRAFTS)
        with (
            counted(journal.place, lambda _, name: name in {"open", "stat"}),
            pytest.raises(OSError, match="Input/output"),
        ):
            journal.read()
        assert journal.read() == (DRAFTS, ())


def test_what_a_second_session_has_left_is_found_by_the_next_one(project: Path) -> None:
    with closing(Journal(project)), closing(Journal(project)) as second:
        second.write(DRAFTS)
    with closing(Journal(project)) as third:
        assert third.read() == (DRAFTS, ())


def test_when_all_places_are_taken_there_is_no_journal(project: Path) -> None:
    with contextlib.ExitStack() as stack:
        for _ in range(MOST_SLOTS):
            stack.enter_context(closing(Journal(project)))
        with pytest.raises(OSError, match="open 16 times"):
            Journal(project)
