import contextlib
import errno
import shutil
import sys
from collections.abc import Mapping
from contextlib import closing
from pathlib import Path

import pytest

from ropsim.userfiles import Draft, Journal
from ropsim.userfiles.journal import MOST_SLOTS
from ropsim.workbench import new_project
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
        b'{"documents":{"a":{"text":"b","base":""}}}',
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


def made(project: Path) -> Path:
    """Write the files of a project."""
    (project / "programs").mkdir(parents=True)
    (project / "cell.toml").write_text("[cell]\n", "utf-8")
    (project / "programs" / "main.task").write_text("mov home\n", "utf-8")
    return project


def left(project: Path) -> None:
    """Leave texts in the journal, as a session does that is killed."""
    with closing(Journal(project)) as journal:
        journal.write(DRAFTS)


def found(project: Path) -> Mapping[str, Draft]:
    """Return what the next session finds."""
    with closing(Journal(project)) as journal:
        drafts, findings = journal.read()
    assert findings == ()
    return drafts


def test_texts_are_found_where_the_project_was_moved_to(project: Path, tmp_path: Path) -> None:
    left(made(project))
    moved = project.rename(tmp_path / "moved")
    assert found(moved) == DRAFTS
    assert found(moved) == DRAFTS
    moved.rename(project)
    assert found(project) == DRAFTS  # and back


@pytest.mark.parametrize("name", ["cell.toml", "programs/main.task"])
def test_a_file_that_was_changed_meanwhile_hides_no_text(project: Path, tmp_path: Path, name: str) -> None:
    left(made(project))
    moved = project.rename(tmp_path / "moved")
    (moved / name).write_text("other\n", "utf-8")
    assert found(moved) == DRAFTS


def test_texts_follow_a_project_to_another_disk(project: Path, tmp_path: Path) -> None:
    left(made(project))
    moved = Path(shutil.copytree(project, tmp_path / "moved"))
    assert found(moved) == {}  # a copy is another project
    shutil.rmtree(project)
    assert found(moved) == DRAFTS


def test_a_folder_that_goes_under_a_session_is_known_by_the_next_one(project: Path, tmp_path: Path) -> None:
    with closing(Journal(made(project))) as journal:
        journal.write(DRAFTS)
        moved = project.rename(tmp_path / "moved")
        journal.write(DRAFTS)
        assert found(moved) == {}  # the session goes on
    assert found(moved) == DRAFTS


def test_a_new_project_does_not_get_the_texts_of_a_removed_one(project: Path, tmp_path: Path) -> None:
    new_project(project)
    left(project)
    shutil.rmtree(project)
    assert found(new_project(tmp_path / "another")) == {}


def test_damaged_journals_of_others_hide_nothing(project: Path, tmp_path: Path) -> None:
    left(made(project))
    home = tmp_path / "state" / "journal"
    damaged = [home / f"0{number}.json" for number in range(3)]  # before all others in their order
    for place, content in zip(
        damaged, (b"", b"[]", b'{"version":1,"marks":{"a":[1]},"documents":[]}'), strict=True
    ):
        place.write_bytes(content)
    moved = project.rename(tmp_path / "moved")
    assert found(moved) == DRAFTS
    assert all(place.exists() for place in damaged)


LEFT = b'{"version": %d, "documents": {"cell.toml": {"text": "[cell]", "base": "ab"}}}'


def put(journal: Journal, content: bytes) -> Path:
    journal.place.write_bytes(content)
    return journal.place


def test_a_journal_of_this_version_is_read_as_every_release_has_written_it(project: Path) -> None:
    with closing(Journal(project)) as journal:
        put(journal, LEFT % 1)
        assert journal.read() == ({"cell.toml": Draft("[cell]", "ab")}, ())


@pytest.mark.parametrize("version", [0, 2, 9])
def test_a_whole_journal_of_another_version_is_set_aside_as_it_is_and_told(
    project: Path, version: int
) -> None:
    with closing(Journal(project)) as journal:
        place = put(journal, LEFT % version)
        drafts, findings = journal.read()
        assert (drafts, [one.code for one in findings]) == ({}, ["X893"])
        aside = place.with_suffix(".damaged")
        assert str(aside) in findings[0].message
        journal.write(DRAFTS)
        journal.write({})
        assert aside.read_bytes() == LEFT % version


def test_a_journal_of_another_version_does_not_follow_its_project(project: Path, tmp_path: Path) -> None:
    with closing(Journal(made(project))) as journal:
        journal.write(DRAFTS)
        content = journal.place.read_bytes()
        assert content.startswith(b'{"version": 1,')
        place = put(journal, content.replace(b'"version": 1', b'"version": 2', 1))
        other = place.read_bytes()
    moved = project.rename(tmp_path / "moved")
    assert found(moved) == {}
    assert place.read_bytes() == other


@pytest.mark.skipif(sys.platform == "win32", reason="Windows locks files by another call than `flock`")
@pytest.mark.parametrize("number", [errno.ENOLCK, errno.EOPNOTSUPP])
def test_where_there_are_no_locks_texts_of_a_session_that_may_go_on_are_not_taken(
    project: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, number: int
) -> None:
    def refused(*_: object) -> None:
        raise OSError(number, "no locks here")

    import fcntl

    with closing(Journal(made(project))) as first:
        first.write(DRAFTS)
        moved = project.rename(tmp_path / "moved")
        with monkeypatch.context() as system:
            system.setattr(fcntl, "flock", refused)
            with closing(Journal(moved)) as second:
                assert second.read() == ({}, ())
                second.write({"cell.toml": Draft("other", "")})
                second.write({})
        assert first.read() == (DRAFTS, ())
    assert found(moved) == DRAFTS  # where there are locks again, and nobody has it
