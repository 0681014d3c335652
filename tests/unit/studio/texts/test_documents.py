import asyncio
import hashlib
import os
import sys
from itertools import count
from pathlib import Path

import pytest

from ropsim.studio.testing import (
    LARGEST,
    Documents,
    ListChange,
    Overwriting,
    PointTables,
    StudioError,
    program_names,
    project_folder,
)
from ropsim.userfiles import Draft
from support.counted_system import counted, number

CELL = b'[cell]\nprogram = "other"\n'


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    (tmp_path / "programs").mkdir()
    (tmp_path / "cell.toml").write_bytes(CELL)
    (tmp_path / "programs" / "main.task").write_bytes(b"one\r\ntwo\r\n")
    (tmp_path / "programs" / "other.task").write_bytes(b"x\n")
    return tmp_path


def opened(folder: Path) -> Documents:
    documents = Documents(folder)
    asyncio.run(documents.look())
    return documents


def save(documents: Documents, name: str, overwriting: Overwriting = Overwriting.REFUSED) -> str:
    """Save a document and return the code of what stood in the way."""
    document, _ = documents.find(name)
    assert document is not None
    finding = asyncio.run(documents.save(document, overwriting))
    return finding.code if finding else ""


def test_documents_are_the_cell_file_and_the_programs(folder: Path) -> None:
    (folder / "programs" / "notes.txt").write_text("no")
    documents = opened(folder)
    assert [one.name for one in documents.all] == ["cell.toml", "programs/main.task", "programs/other.task"]
    assert (documents.programs, documents.program) == (("main", "other"), "other")
    assert documents.unsaved_texts == {}


def test_texts_of_tasks_are_documents_and_no_programs(folder: Path) -> None:
    (folder / "kb").mkdir()
    (folder / "kb" / "main.pl").write_text("at(a, b).\n")
    (folder / "kb" / "manifest.toml").write_text("order = []\n")
    documents = opened(folder)
    assert [one.name for one in documents.all if one.name.startswith("kb")] == ["kb/main.pl"]
    assert documents.programs == ("main", "other")
    made, finding = asyncio.run(documents.create("kb/wave.pl", "at(a, c).\n"))
    assert finding is None
    assert made is not None
    assert made.state(None).language == "prolog"
    assert (folder / "kb" / "wave.pl").read_text() == "at(a, c).\n"
    for name in ("kb/con.pl", "kb/../wave.pl", "kb/wave.task", "programs/wave.pl"):
        assert asyncio.run(documents.create(name, ""))[1] is not None
    documents.edit("kb/wave.pl", "at(a, d).\n", 1)
    assert documents.unsaved_texts == {"kb/wave.pl": "at(a, d).\n"}


def test_robot_files_are_documents_and_no_programs(folder: Path) -> None:
    (folder / "robots").mkdir()
    (folder / "robots" / "main.toml").write_text("one")
    (folder / "robots" / "arm.stl").write_text("no")
    documents = opened(folder)
    assert [one.name for one in documents.all][-1] == "robots/main.toml"
    assert documents.programs == ("main", "other")
    (folder / "robots" / "main.toml").write_text("another")
    changed, _ = asyncio.run(documents.look())
    assert [one.name for one in changed] == ["robots/main.toml"]
    draft = Draft("mine", hashlib.sha256(b"another").hexdigest())
    assert [one.name for one in documents.recover({"robots/main.toml": draft})] == ["robots/main.toml"]
    assert documents.recover({"robots/../../main.toml": draft, "other/main.toml": draft}) == ()


@pytest.mark.parametrize(
    ("table", "program"),
    [("[stations.left]\nprogram = 'other'\n[stations.right]\n", "other"), ("[stations.main]\n", "main")],
)
def test_the_program_of_the_first_station_is_shown_first(folder: Path, table: str, program: str) -> None:
    (folder / "cell.toml").write_text(table)
    assert opened(folder).program == program


def test_code_beside_a_task_of_its_name_keeps_its_ending() -> None:
    names = program_names(["cell.toml", "programs/a.icr", "programs/a.task", "programs/b.icr"])
    assert names == {"a": "programs/a.task", "a.icr": "programs/a.icr", "b": "programs/b.icr"}


def test_an_edit_counts_and_a_save_keeps_the_line_ends(folder: Path) -> None:
    documents = opened(folder)
    documents.edit("programs/main.task", "one\nTWO\n", 3)
    assert documents.unsaved_texts == {"programs/main.task": "one\nTWO\n"}
    assert save(documents, "programs/main.task") == ""
    assert (folder / "programs" / "main.task").read_bytes() == b"one\r\nTWO\r\n"
    assert documents.unsaved_texts == {}


def test_typing_a_text_back_is_no_change(folder: Path) -> None:
    documents = opened(folder)
    documents.edit("programs/main.task", "one\n", 1)
    documents.edit("programs/main.task", "one\ntwo\n", 2)
    assert documents.unsaved_texts == {}


def test_a_byte_order_mark_stays(folder: Path) -> None:
    (folder / "programs" / "main.task").write_bytes(b"\xef\xbb\xbfone\n")
    documents = opened(folder)
    documents.edit("programs/main.task", "two\n", 1)
    save(documents, "programs/main.task")
    assert (folder / "programs" / "main.task").read_bytes() == b"\xef\xbb\xbftwo\n"


def test_a_file_that_changed_since_it_was_read_is_not_written_over(folder: Path) -> None:
    place = folder / "programs" / "main.task"
    documents = opened(folder)
    documents.edit("programs/main.task", "mine\n", 1)
    place.write_bytes(b"theirs\n")
    assert save(documents, "programs/main.task") == "U956"
    assert place.read_bytes() == b"theirs\n"
    assert documents.all[1].conflict
    assert save(documents, "programs/main.task") == "U956"  # also when tried again
    assert save(documents, "programs/main.task", Overwriting.WANTED) == ""
    assert place.read_bytes() == b"mine\n"
    assert not documents.all[1].conflict


def test_reverting_takes_the_text_of_the_file(folder: Path) -> None:
    documents = opened(folder)
    documents.edit("programs/main.task", "mine\n", 1)
    (folder / "programs" / "main.task").write_bytes(b"theirs\n")
    asyncio.run(documents.revert(documents.all[1]))
    state = documents.all[1].state(documents.all[1].text)
    assert (state.text, state.unsaved, state.conflict, state.version) == ("theirs\n", False, False, 0)


def test_a_changed_file_is_read_again_where_nothing_is_unsaved(folder: Path) -> None:
    documents = opened(folder)
    (folder / "programs" / "main.task").write_bytes(b"longer than before\n")
    changed, change = asyncio.run(documents.look())
    assert ([one.text for one in changed], change) == (["longer than before\n"], ListChange.NONE)


def test_files_that_come_and_go_are_noticed(folder: Path) -> None:
    documents = opened(folder)
    (folder / "programs" / "other.task").unlink()
    (folder / "programs" / "new.task").write_bytes(b"n\n")
    _, change = asyncio.run(documents.look())
    assert change is ListChange.SOME
    assert "other" in documents.programs  # held, in case that all of the folder goes
    _, change = asyncio.run(documents.look())
    assert change is ListChange.SOME
    assert documents.programs == ("main", "new")


def test_unsaved_text_outlives_its_file_and_can_be_saved_again(folder: Path) -> None:
    place = folder / "programs" / "main.task"
    documents = opened(folder)
    documents.edit("programs/main.task", "mine\n", 1)
    place.unlink()
    asyncio.run(documents.look())
    assert documents.all[1].conflict
    assert save(documents, "programs/main.task", Overwriting.WANTED) == ""
    assert place.read_bytes() == b"mine\r\n"  # with the line ends that its file had


def test_a_text_that_is_no_utf8_is_shown_and_not_edited(folder: Path) -> None:
    (folder / "programs" / "main.task").write_bytes(b"caf\xe9\n")
    documents = opened(folder)
    assert documents.all[1].text == "caf�\n"
    _, finding = documents.edit("programs/main.task", "café\n", 1)
    assert finding is not None
    assert finding.code == "U958"


def test_a_link_out_of_the_project_is_neither_read_nor_written(
    folder: Path, tmp_path_factory: pytest.TempPathFactory
) -> None:
    outside = tmp_path_factory.mktemp("outside") / "precious.task"
    outside.write_bytes(b"precious\n")
    (folder / "programs" / "link.task").symlink_to(outside)
    documents = opened(folder)
    _, finding = documents.edit("programs/link.task", "gone\n", 1)
    assert finding is not None
    assert finding.code == "U962"
    assert "precious" not in [one.text for one in documents.all]
    assert outside.read_bytes() == b"precious\n"


@pytest.mark.parametrize(
    "name", ["../evil.task", "programs/../../evil.task", "out/x.task", "/etc/passwd", ""]
)
def test_only_documents_of_the_project_are_edited_or_recovered(folder: Path, name: str) -> None:
    documents = opened(folder)
    assert documents.edit(name, "x", 1)[0] is None
    assert documents.recover({name: Draft("x", "")}) == ()


def test_recovered_text_says_so_and_knows_whether_its_file_has_changed(folder: Path) -> None:
    documents = opened(folder)
    same = hashlib.sha256(b"x\n").hexdigest()
    documents.recover(
        {"programs/other.task": Draft("mine\n", same), "programs/main.task": Draft("mine\n", "0" * 64)}
    )
    states = {one.name: (one.recovered, one.conflict, one.unsaved) for one in documents.all}
    assert states["programs/other.task"] == (True, False, True)
    assert states["programs/main.task"] == (True, True, True)


def test_a_draft_that_the_file_has_by_now_is_dropped(folder: Path) -> None:
    documents = opened(folder)
    assert documents.recover({"programs/other.task": Draft("x\n", "")}) == ()
    assert documents.unsaved_texts == {}


def test_the_project_of_a_path_is_found(folder: Path) -> None:
    for path in (folder, folder / "cell.toml", folder / "programs" / "main.task"):
        assert project_folder(path) == folder.resolve()


@pytest.mark.parametrize("name", ["nowhere", "empty", "x" * 5000])
def test_where_no_project_is_the_finding_says_what_to_do(tmp_path: Path, name: str) -> None:
    (tmp_path / "empty").mkdir()
    with pytest.raises(StudioError) as refused:
        project_folder(tmp_path / name)
    assert refused.value.diagnostic.code == "U950"
    assert "ropsim new" in refused.value.diagnostic.hint


@pytest.mark.skipif(sys.platform == "win32", reason="Windows has no such files")
def test_a_pipe_in_place_of_a_program_holds_nothing_up(folder: Path) -> None:
    documents = opened(folder)
    documents.edit("programs/main.task", "new\n", 1)
    (folder / "programs" / "main.task").unlink()
    os.mkfifo(folder / "programs" / "main.task")
    changed, _ = asyncio.run(documents.look())
    assert [(one.name, one.conflict) for one in changed] == [("programs/main.task", True)]
    assert save(documents, "programs/main.task") == "U956"


@pytest.mark.skipif(sys.platform == "win32", reason="links need rights there")
def test_links_that_go_round_are_refused_in_words(folder: Path) -> None:
    documents = opened(folder)
    documents.edit("programs/main.task", "new\n", 1)
    (folder / "programs" / "main.task").unlink()
    (folder / "programs" / "main.task").symlink_to("main.task")
    asyncio.run(documents.look())
    assert save(documents, "programs/main.task", Overwriting.WANTED) == "U957"
    assert documents.unsaved_texts == {"programs/main.task": "new\n"}


def test_a_text_counts_in_bytes_as_readers_count_it(folder: Path) -> None:
    documents = opened(folder)
    taken, finding = documents.edit("programs/main.task", "\u20ac" * (LARGEST // 2), 1)
    assert (taken, finding.code if finding else "") == (None, "U958")
    assert documents.unsaved_texts == {}


def test_a_file_that_its_line_ends_would_make_too_long_is_not_written(
    folder: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    documents = opened(folder)
    monkeypatch.setattr("ropsim.studio.texts.documents.LARGEST", 12)
    documents.edit("programs/main.task", "one\n1\n2\n3\n4\n", 1)
    assert save(documents, "programs/main.task") == "U957"
    assert (folder / "programs" / "main.task").read_bytes() == b"one\r\ntwo\r\n"


def create(documents: Documents, name: str, text: str = "program new\n") -> str:
    """Make a program and return the code of what stood in the way."""
    document, finding = asyncio.run(documents.create(name, text))
    assert (document is None) == (finding is not None)
    return finding.code if finding else ""


def test_a_new_program_is_a_file_and_a_document(folder: Path) -> None:
    documents = opened(folder)
    assert create(documents, "programs/place boxes.task") == ""
    assert (folder / "programs" / "place boxes.task").read_bytes() == b"program new\n"
    assert "place boxes" in documents.programs
    assert documents.unsaved_texts == {}


def test_a_new_program_is_never_written_over_a_file(folder: Path) -> None:
    documents = opened(folder)
    (folder / "programs" / "late.task").write_bytes(b"from elsewhere\n")
    for name in ("programs/main.task", "programs/late.task"):
        before = (folder / name).read_bytes()
        assert create(documents, name) == "U957"
        assert (folder / name).read_bytes() == before


def test_points_go_with_a_new_program_but_never_over_another_list(folder: Path) -> None:
    documents = opened(folder)
    table = folder / "points" / "a.csv"
    assert asyncio.run(documents.create("programs/a.task", "program a\n", "one\n"))[1] is None
    assert table.read_bytes() == b"one\n"
    (folder / "programs" / "a.task").unlink()
    for _ in range(3):  # it comes, is missed, and is let go
        asyncio.run(documents.look())
    finding = asyncio.run(documents.create("programs/a.task", "program a\n", "other\n"))[1]
    assert finding is not None
    assert "points/a.csv" in finding.message
    assert table.read_bytes() == b"one\n"
    assert not (folder / "programs" / "a.task").exists()
    assert asyncio.run(documents.create("programs/a.task", "program a\n", "one\n"))[1] is None
    assert asyncio.run(documents.keep_points("programs/a.task", "other\n", Overwriting.WANTED)) is None
    assert table.read_bytes() == b"other\n"
    for name in ("kb/a.pl", "programs/../a.task", "cell.toml"):
        assert asyncio.run(documents.keep_points(name, "x\n", Overwriting.WANTED)) is not None


@pytest.mark.parametrize(
    "name",
    [
        "programs/../evil.task",
        "programs/a/b.task",
        "../evil.task",
        "/tmp/evil.task",
        "cell.toml",
        "programs/evil.py",
        "programs/.task",
        "programs/a\\b.task",
        "programs/c:evil.task",
        "programs/new\nline.task",
        "programs/con.task",
        "programs/LPT1 .icr",
        "",
    ],
)
def test_a_new_program_stays_in_its_folder_and_has_a_name_on_any_system(folder: Path, name: str) -> None:
    before = sorted(folder.rglob("*"))
    assert create(opened(folder), name) == "U957"
    assert sorted(folder.rglob("*")) == before


@pytest.mark.skipif(sys.platform == "win32", reason="links need rights there")
def test_a_new_program_follows_no_link_out_of_the_project(
    folder: Path, tmp_path_factory: pytest.TempPathFactory
) -> None:
    elsewhere = tmp_path_factory.mktemp("elsewhere")
    for path in (folder / "programs").iterdir():
        path.unlink()
    (folder / "programs").rmdir()
    (folder / "programs").symlink_to(elsewhere)
    assert create(opened(folder), "programs/new.task") == "U962"
    assert list(elsewhere.iterdir()) == []


def test_a_removed_project_folder_takes_no_text_with_it(folder: Path) -> None:
    documents = opened(folder)
    documents.edit("programs/main.task", "typed\n", 1)
    away = folder.with_name("away")
    folder.rename(away)
    changed, change = asyncio.run(documents.look())
    assert (documents.gone, change) == (True, ListChange.NONE)
    assert {one.name for one in changed} == {"cell.toml", "programs/main.task", "programs/other.task"}
    assert documents.unsaved_texts["programs/main.task"] == "typed\n"
    assert documents.drafts.keys() == {one.name for one in changed}  # the journal holds all of them
    assert asyncio.run(documents.look()) == ((), ListChange.NONE)
    away.rename(folder)
    asyncio.run(documents.look())
    assert (documents.gone, documents.unsaved_texts) == (False, {"programs/main.task": "typed\n"})


def test_a_removed_project_folder_is_made_anew_by_saving(folder: Path) -> None:
    documents = opened(folder)
    folder.rename(folder.with_name("away"))
    asyncio.run(documents.look())
    assert save(documents, "cell.toml") == ""
    assert save(documents, "programs/other.task") == ""
    assert (folder / "cell.toml").read_bytes() == CELL
    assert (folder / "programs" / "other.task").read_bytes() == b"x\n"
    assert "cell.toml" not in documents.drafts


def test_a_conflict_outlives_the_studio(folder: Path) -> None:
    documents = opened(folder)
    documents.edit("programs/main.task", "mine\n", 1)
    (folder / "programs" / "main.task").write_bytes(b"theirs\n")
    asyncio.run(documents.look())
    again = opened(folder)
    again.recover(documents.drafts)
    assert save(again, "programs/main.task") == "U956"
    assert (folder / "programs" / "main.task").read_bytes() == b"theirs\n"
    assert save(again, "programs/main.task", Overwriting.WANTED) == ""
    assert (folder / "programs" / "main.task").read_bytes() == b"mine\n"


def test_a_file_that_comes_back_to_what_was_worked_on_is_in_no_conflict(folder: Path) -> None:
    documents = opened(folder)
    documents.edit("programs/main.task", "mine\n", 1)
    for content, conflict in ((b"theirs\n", True), (b"one\r\ntwo\r\n", False)):
        (folder / "programs" / "main.task").write_bytes(content)
        asyncio.run(documents.look())
        assert documents.all[1].conflict is conflict
    assert save(documents, "programs/main.task") == ""


def test_an_edit_on_a_text_that_the_file_had_before_is_in_conflict(folder: Path) -> None:
    """It was on its way from the page while the file was read again."""
    documents = opened(folder)
    base = documents.all[1].base
    (folder / "programs" / "main.task").write_bytes(b"theirs\n")
    asyncio.run(documents.look())
    documents.edit("programs/main.task", "mine\n", 1, base)
    assert save(documents, "programs/main.task") == "U956"


def test_an_edit_that_was_sent_before_the_page_heard_of_a_save_is_in_no_conflict(folder: Path) -> None:
    documents = opened(folder)
    base = documents.all[1].base
    documents.edit("programs/main.task", "mine\n", 1, base)
    assert save(documents, "programs/main.task") == ""
    documents.edit("programs/main.task", "mine too\n", 2, base)
    assert not documents.all[1].conflict
    assert save(documents, "programs/main.task") == ""


def test_what_is_overwritten_is_what_the_user_was_shown(folder: Path) -> None:
    place = folder / "programs" / "main.task"
    documents = opened(folder)
    documents.edit("programs/main.task", "mine\n", 1)
    place.write_bytes(b"theirs\n")
    assert save(documents, "programs/main.task") == "U956"
    place.write_bytes(b"theirs again\n")
    assert save(documents, "programs/main.task", Overwriting.WANTED) == "U956"
    assert place.read_bytes() == b"theirs again\n"
    assert save(documents, "programs/main.task", Overwriting.WANTED) == ""


def test_a_project_folder_that_goes_between_two_questions_takes_no_text_with_it(folder: Path) -> None:
    """At every call that a look makes of the system."""
    away = folder.with_name(f"{folder.name}-away")

    def leave(_: str) -> None:
        folder.rename(away)

    for at in count(1):
        documents = opened(folder)
        texts = {one.name: one.text for one in documents.all}
        os.utime(folder / "cell.toml", ns=(at, at))  # so that a file is read, too
        with counted(folder, number(at), leave) as counting:
            asyncio.run(documents.look())
        if not counting.acted:
            assert at > 12
            break
        asyncio.run(documents.look())
        assert documents.gone
        assert {one.name: one.text for one in documents.all} == texts
        assert documents.drafts.keys() == texts.keys()
        away.rename(folder)


def test_an_unmounted_project_takes_no_text_with_it(folder: Path) -> None:
    """Its folder stays, and is empty."""
    documents = opened(folder)
    texts = {one.name: one.text for one in documents.all}
    folder.rename(folder.with_name(f"{folder.name}-away"))
    folder.mkdir()
    for _ in range(3):
        asyncio.run(documents.look())
    assert documents.drafts.keys() == texts.keys()


def test_a_text_without_a_folder_is_not_given_up(folder: Path) -> None:
    documents = opened(folder)
    folder.rename(folder.with_name(f"{folder.name}-away"))
    asyncio.run(documents.look())
    finding = asyncio.run(documents.revert(documents.all[1]))
    assert finding is not None
    assert documents.all[1].text == "one\ntwo\n"


@pytest.mark.skipif(sys.platform == "win32" or os.geteuid() == 0, reason="nothing is closed to this user")
def test_a_file_that_may_not_be_read_is_not_written_over(folder: Path) -> None:
    place = folder / "programs" / "main.task"
    documents = opened(folder)
    documents.edit("programs/main.task", "mine\n", 1)
    place.chmod(0)
    assert save(documents, "programs/main.task", Overwriting.WANTED) == "U957"
    place.chmod(0o600)
    assert place.read_bytes() == b"one\r\ntwo\r\n"


def test_names_of_points_are_those_of_the_tables_as_they_are_now(folder: Path) -> None:
    tables = PointTables(folder)
    assert not asyncio.run(tables.look())
    place = folder / "points"
    place.mkdir(exist_ok=True)
    (place / "a.csv").write_text("name,x,y,z\n,mm,mm,mm\np1,1,2,3\n\nrack 2,4,5,6\n", "utf-8")
    (place / "b.csv").write_bytes(b"name,x,y,z\n,mm,mm,mm\n\xff,1,2,3\np1,1,2,3\n")
    (place / "notes.txt").write_text("name\n\np9\n", "utf-8")
    assert asyncio.run(tables.look())
    assert list(tables.names) == ["p1", "rack 2", "\ufffd"]
    assert not asyncio.run(tables.look())
    (place / "a.csv").unlink()
    (place / "c.csv").symlink_to(Path(__file__))
    assert asyncio.run(tables.look())
    assert list(tables.names) == ["p1", "\ufffd"]


def test_edits_are_in_no_conflict_with_saves_that_overtake_them_one_after_the_other(folder: Path) -> None:
    """The page hears of none of three saves, and all that it writes stands on the text from before them."""
    documents = opened(folder)
    base = documents.all[1].base
    for version in range(1, 4):
        documents.edit("programs/main.task", f"mine {version}\n", version, base)
        assert not documents.all[1].conflict
        assert save(documents, "programs/main.task") == ""


def test_a_file_that_has_gone_is_written_anew_where_that_is_wanted(folder: Path) -> None:
    documents = opened(folder)
    documents.edit("programs/main.task", "mine\n", 1)
    (folder / "programs" / "main.task").unlink()
    assert save(documents, "programs/main.task", Overwriting.WANTED) == ""
    assert (folder / "programs" / "main.task").read_bytes() == b"mine\r\n"  # as it had them last
