"""Files inside of a folder: no link leads out, a save is whole or nothing, a new file replaces none."""

import os
import stat
import sys
from itertools import count
from pathlib import Path

import pytest

from ropsim.core import (
    LeadsOutError,
    create_inside,
    place_inside,
    read_inside,
    replace_inside,
    stated_inside,
)
from support.counted_system import counted, number

pytestmark = pytest.mark.skipif(sys.platform == "win32", reason="links need rights there")
NAME = "programs/main.task"


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    folder = tmp_path / "cell"
    (folder / "programs").mkdir(parents=True)
    (folder / NAME).write_bytes(b"old")
    (tmp_path / "out").mkdir()
    (tmp_path / "out" / "main.task").write_bytes(b"secret")
    return folder


def test_links_that_stay_inside_are_followed_and_stay_links(folder: Path) -> None:
    (folder / "shared").mkdir()
    (folder / "shared" / "one.task").write_bytes(b"one")
    for name, target in (
        ("programs/a.task", "../shared/one.task"),
        ("programs/b.task", folder / "shared/one.task"),
    ):
        (folder / name).symlink_to(target)
        assert read_inside(folder, name, 10) == b"one"
    replace_inside(folder, "programs/a.task", b"two")
    assert (folder / "programs" / "a.task").is_symlink()
    assert (folder / "shared" / "one.task").read_bytes() == b"two"


def test_a_folder_that_is_reached_by_a_link_is_as_good_as_itself(folder: Path, tmp_path: Path) -> None:
    link = tmp_path / "link"
    link.symlink_to(folder, target_is_directory=True)
    replace_inside(link, NAME, b"new")
    assert read_inside(link, NAME, 10) == (folder / NAME).read_bytes() == b"new"


@pytest.mark.parametrize("kind", ["file", "folder", "chain", "dangling"])
def test_links_that_lead_out_are_refused_for_reading_and_for_writing(folder: Path, kind: str) -> None:
    out, name = folder.parent / "out", "programs/link.task"
    match kind:
        case "file":
            (folder / name).symlink_to(out / "main.task")
        case "folder":
            (folder / "more").symlink_to(out, target_is_directory=True)
            name = "more/main.task"
        case "chain":
            (folder / "step").symlink_to("../out")
            (folder / name).symlink_to("../step/main.task")
        case _:
            (folder / name).symlink_to(out / "new.task")
    before = {one.name: one.read_bytes() for one in out.iterdir()}
    for act in (
        lambda: read_inside(folder, name, 10),
        lambda: replace_inside(folder, name, b"x"),
        lambda: create_inside(folder, name, b"x"),
        lambda: place_inside(folder, name),
    ):
        with pytest.raises(LeadsOutError, match="link that leads out"):
            act()
    assert {one.name: one.read_bytes() for one in out.iterdir()} == before


@pytest.mark.parametrize(
    "path", ["/etc/passwd", "../out/main.task", "a\\..\\..\\b", "C:\\x", "programs/../../out/x"]
)
def test_a_written_path_is_one_on_every_system(folder: Path, path: str) -> None:
    with pytest.raises(LeadsOutError, match="leads out of the project folder"):
        stated_inside(folder, path)


def test_a_link_that_is_swapped_in_at_any_time_leads_nowhere(folder: Path) -> None:
    """The folder of the file becomes a link out of the project, before each call of the system."""
    out = folder.parent / "out"
    before = {one.name: one.read_bytes() for one in out.iterdir()}

    def swap(_: str) -> None:
        (folder / "programs").rename(folder / "was")
        (folder / "programs").symlink_to(out, target_is_directory=True)

    for at in count(1):
        with counted(folder, number(at), swap) as counting:
            try:
                replace_inside(folder, NAME, b"new")
            except OSError:
                assert (folder / "was" / "main.task").read_bytes() == b"old"
        assert {one.name: one.read_bytes() for one in out.iterdir()} == before
        if not counting.acted:
            break
        (folder / "programs").unlink()
        (folder / "was").rename(folder / "programs")
        (folder / NAME).write_bytes(b"old")
    assert at > 6


def test_a_save_that_fails_at_any_call_leaves_the_old_file_or_the_new_one(folder: Path) -> None:
    (folder / NAME).chmod(0o640)
    for at in count(1):
        failed = False
        with counted(folder, number(at)) as counting:
            try:
                replace_inside(folder, NAME, b"new")
            except OSError:
                failed = True
        assert (folder / NAME).read_bytes() == (b"old" if failed else b"new")
        assert stat.S_IMODE((folder / NAME).stat().st_mode) == 0o640
        if counting.acted and counting.names[at - 1] != "unlink":
            assert [one.name for one in (folder / "programs").iterdir()] == ["main.task"]
        if not counting.acted:
            break
        (folder / NAME).write_bytes(b"old")
        for one in (folder / "programs").glob(".ropsim-*"):
            one.unlink()
    assert at > 8


def test_what_forbids_a_replacement_at_the_last_moment_leaves_no_trace(folder: Path) -> None:
    def forbid() -> None:
        raise PermissionError("changed")

    with pytest.raises(PermissionError, match="changed"):
        replace_inside(folder, NAME, b"new", forbid)
    assert [(one.name, one.read_bytes()) for one in (folder / "programs").iterdir()] == [
        ("main.task", b"old")
    ]


def test_a_new_file_is_never_one_that_is_there(folder: Path) -> None:
    """Also where it comes while the new one is written, and on a disk without hard links."""
    with pytest.raises(FileExistsError):
        create_inside(folder, NAME, b"new")
    place = folder / "programs" / "b.task"

    def come(_: str) -> None:
        place.write_bytes(b"theirs")

    with counted(folder, lambda _, name: name == "link", come), pytest.raises(FileExistsError):
        create_inside(folder, "programs/b.task", b"mine")
    assert place.read_bytes() == b"theirs"
    create_inside(folder, "points/c.csv", b"mine")
    assert (folder / "points" / "c.csv").read_bytes() == b"mine"


def test_what_is_no_ordinary_file_is_neither_read_nor_written(folder: Path) -> None:
    os.mkfifo(folder / "programs" / "pipe.task")
    (folder / "programs" / "folder.task").mkdir()
    for name in ("programs/pipe.task", "programs/folder.task"):
        with pytest.raises(OSError, match="no ordinary file"):
            read_inside(folder, name, 10)
        with pytest.raises(OSError, match=r"Invalid argument|Is a directory"):
            replace_inside(folder, name, b"x")
