"""Rooms of the cache folder: entries are whole, the user's own, under their own names, and not too many."""

import contextlib
import multiprocessing
import os
import random
import socket
import sys
from collections.abc import Iterator
from pathlib import Path

import pytest

from ropsim.core import KeptFiles, kept_findings
from ropsim.core.disk import kept_files

NAME = "ab12-translated"
OTHER = "ab13-translated"
ENTRY = bytes(range(256)) * 20
LARGEST = 16_000

posix = pytest.mark.skipif(not hasattr(os, "geteuid"), reason="no owners of files")
as_root = pytest.mark.skipif(
    not hasattr(os, "geteuid") or os.geteuid() != 0, reason="only root can give files to others"
)
STRANGER = 12_345


def kept_in(folder: Path, most: int = 1_000_000) -> KeptFiles:
    return KeptFiles("room", most, LARGEST, lambda: folder)


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    return tmp_path / "cache"


@pytest.fixture
def kept(folder: Path) -> Iterator[KeptFiles]:
    """Return a room with one entry; nothing is said before."""
    kept_files._findings.clear()
    made = kept_in(folder)
    made.keep(NAME, ENTRY)
    yield made
    kept_files._findings.clear()


def codes() -> list[str]:
    """Return what has been said since the last time."""
    found = [one.code for one in kept_findings()]
    kept_files._findings.clear()
    return found


def test_an_entry_comes_back_as_it_was_given(kept: KeptFiles) -> None:
    assert kept.find(NAME) == ENTRY
    assert kept.find(OTHER) is None
    kept.keep(NAME, b"")
    assert kept.find(NAME) == b""
    assert codes() == []


@posix
def test_others_can_look_into_neither_folder_nor_file(kept: KeptFiles, folder: Path) -> None:
    del kept
    found = (folder, folder / "room", folder / "room" / NAME)
    assert [path.stat().st_mode & 0o777 for path in found] == [0o700, 0o700, 0o600]


@posix
def test_a_room_that_others_could_look_into_is_closed_to_them(kept: KeptFiles, folder: Path) -> None:
    (folder / "room").chmod(0o755)
    kept.keep(OTHER, ENTRY)
    assert (folder / "room").stat().st_mode & 0o777 == 0o700


def test_an_entry_under_the_name_of_another_is_none(kept: KeptFiles, folder: Path) -> None:
    (folder / "room" / NAME).rename(folder / "room" / OTHER)
    assert kept.find(OTHER) is None
    (folder / "room").rename(folder / "elsewhere")
    assert KeptFiles("elsewhere", 1_000_000, LARGEST, lambda: folder).find(NAME) is None


@posix
def test_entries_are_found_where_groups_may_write_to_what_is_made(folder: Path) -> None:
    before = os.umask(0o002)
    try:
        kept_in(folder).keep(NAME, ENTRY)
    finally:
        os.umask(before)
    assert kept_in(folder).find(NAME) == ENTRY


def test_a_folder_that_is_gone_has_no_entries_and_takes_new_ones(kept: KeptFiles, folder: Path) -> None:
    (folder / "room" / NAME).unlink()
    (folder / "room").rmdir()
    assert kept.find(NAME) is None
    kept.keep(NAME, ENTRY)
    assert kept.find(NAME) == ENTRY


def test_a_damaged_entry_is_none(kept: KeptFiles, folder: Path) -> None:
    path = folder / "room" / NAME
    content = path.read_bytes()
    chosen = random.Random(1)
    for _ in range(300):
        damaged = bytearray(content)
        damaged[chosen.randrange(len(damaged))] ^= 1 << chosen.randrange(8)
        path.write_bytes(damaged[: chosen.choice([len(damaged), chosen.randrange(len(damaged))])])
        assert kept.find(NAME) is None
    path.write_bytes(content)
    assert kept.find(NAME) == ENTRY


def test_an_entry_that_is_too_large_is_neither_kept_nor_read(kept: KeptFiles, folder: Path) -> None:
    kept.keep(OTHER, bytes(LARGEST + 1))
    assert kept.find(OTHER) is None
    roomy = KeptFiles("room", 1_000_000, 2 * LARGEST, lambda: folder)
    roomy.keep(OTHER, bytes(LARGEST + 1))
    assert roomy.find(OTHER) is not None
    assert kept.find(OTHER) is None


@posix
def test_a_file_that_others_may_have_written_is_none(kept: KeptFiles, folder: Path, tmp_path: Path) -> None:
    path = folder / "room" / NAME
    for others in (0o020, 0o002):
        path.chmod(0o600 | others)
        assert kept.find(NAME) is None
    path.chmod(0o600)
    assert kept.find(NAME) == ENTRY
    moved = path.rename(tmp_path / "moved")
    path.symlink_to(moved)
    assert kept.find(NAME) is None
    kept.keep(NAME, ENTRY)
    assert kept.find(NAME) == ENTRY
    assert not path.is_symlink()


@posix
@pytest.mark.parametrize("kind", ["folder", "pipe", "socket"])
def test_what_is_no_file_is_no_entry_and_nobody_waits(kept: KeptFiles, folder: Path, kind: str) -> None:
    path = folder / "room" / OTHER
    if kind == "folder":
        path.mkdir()
    elif kind == "pipe":
        os.mkfifo(path)
    else:
        with contextlib.chdir(path.parent), socket.socket(socket.AF_UNIX) as one:  # their names are short
            one.bind(OTHER)
    assert kept.find(OTHER) is None
    kept.keep(OTHER, ENTRY)
    assert kept.find(OTHER) == (None if kind == "folder" else ENTRY)


@posix
@pytest.mark.parametrize("level", ["", "room"])
@pytest.mark.parametrize("others", [0o020, 0o002])
def test_a_folder_that_others_can_write_to_is_not_used(
    kept: KeptFiles, folder: Path, level: str, others: int
) -> None:
    (folder / level).chmod(0o700 | others)
    assert kept.find(NAME) is None
    assert codes() == ["X918"]
    kept.keep(OTHER, ENTRY)
    assert codes() == ["X918"]
    assert [one.name for one in (folder / "room").iterdir()] == [NAME]


@posix
@pytest.mark.parametrize("level", ["", "room"])
def test_a_folder_that_is_a_link_is_not_used(
    kept: KeptFiles, folder: Path, tmp_path: Path, level: str
) -> None:
    real = (folder / level).rename(tmp_path / "real")
    (folder / level).symlink_to(real)
    assert kept.find(NAME) is None
    assert codes() == ["X918"]
    kept.keep(OTHER, ENTRY)
    assert codes() == ["X918"]


@as_root
@pytest.mark.parametrize("level", ["", "room", f"room/{NAME}"])
def test_what_belongs_to_another_user_is_not_used(kept: KeptFiles, folder: Path, level: str) -> None:
    os.chown(folder / level, STRANGER, STRANGER)
    assert kept.find(NAME) is None
    assert (codes() == ["X918"]) is (level != f"room/{NAME}")


@posix
def test_whose_a_folder_is_decides_and_not_who_asks(
    kept: KeptFiles, folder: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(os, "geteuid", lambda: os.getuid() + 1)
    assert kept.find(NAME) is None
    kept.keep(OTHER, ENTRY)
    assert codes() == ["X918"]
    assert [one.name for one in (folder / "room").iterdir()] == [NAME]


@as_root
def test_root_makes_no_folder_among_those_of_another_user(tmp_path: Path) -> None:
    home = tmp_path / "home"
    home.mkdir()
    os.chown(home, STRANGER, STRANGER)
    kept = kept_in(home / ".cache" / "ropsim")
    kept.keep(NAME, ENTRY)
    assert codes() == ["X918"]
    assert list(home.iterdir()) == []
    assert kept.find(NAME) is None


def test_a_folder_that_cannot_be_made_is_said_and_work_goes_on(tmp_path: Path) -> None:
    def homeless() -> Path:
        raise OSError(2, "the user has no home folder")

    kept = KeptFiles("room", 1_000_000, LARGEST, homeless)
    kept.keep(NAME, ENTRY)
    assert kept.find(NAME) is None
    with kept.turn(7):
        pass
    (said,) = kept_findings()
    assert (said.code, said.message) == ("X919", "compiled code cannot be kept: the user has no home folder")
    kept_files._findings.clear()
    del tmp_path


@pytest.mark.skipif(not sys.platform.startswith("linux"), reason="the usual folder is that of XDG")
@pytest.mark.parametrize("path", ["rel", "./rel", "~/rel"])
def test_a_relative_path_of_the_cache_is_said_and_the_usual_folder_used(
    path: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path / "usual"))
    monkeypatch.setenv("ROPSIM_CACHE_DIR", path)
    kept_files._findings.clear()
    kept = KeptFiles("room", 1_000_000, LARGEST)
    kept.keep(NAME, ENTRY)
    assert kept.find(NAME) == ENTRY
    (said,) = kept_findings()
    assert (said.code, said.message) == (
        "X921",
        f"`ROPSIM_CACHE_DIR` is `{path}`, a relative path: it is not used",
    )
    assert [one.name for one in tmp_path.iterdir()] == ["usual"]
    monkeypatch.setenv("ROPSIM_CACHE_DIR", "")
    kept_files._findings.clear()
    assert kept.find(NAME) == ENTRY
    assert kept_findings() == ()


@pytest.mark.skipif(not sys.platform.startswith("linux"), reason="a disk that is always full")
def test_a_disk_that_is_full_leaves_no_rest(
    kept: KeptFiles, folder: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def full(_handle: int, *_anything: object) -> None:
        raise OSError(28, "No space left on device")

    monkeypatch.setattr("ropsim.core.disk.handles.os.fdopen", full)
    kept.keep(OTHER, ENTRY)
    monkeypatch.undo()
    assert codes() == ["X919"]
    assert [one.name for one in (folder / "room").iterdir()] == [NAME]
    assert kept.find(NAME) == ENTRY


def test_what_was_not_used_for_longest_makes_place(folder: Path) -> None:
    kept = kept_in(folder, most=10_000)
    for number in range(8):
        kept.keep(f"k{number}", bytes(1000))
        os.utime(folder / "room" / f"k{number}", ns=(number, number))
    with kept.turn(3):
        pass
    assert kept.find("k0") == bytes(1000)  # which is used now
    kept.keep("large", bytes(3000))
    assert sum(path.stat().st_size for path in (folder / "room").iterdir()) <= 10_000
    assert kept.find("k1") is kept.find("k2") is None
    assert kept.find("k0") is not None
    assert kept.find("large") is not None
    assert [one.name for one in (folder / "room").glob("turn-*")] == ["turn-3"]


def written_and_read(folder: Path, letter: bytes) -> int:
    kept = kept_in(folder, most=60_000)
    wrong = 0
    for number in range(60):
        kept.keep(f"k{number % 7}", letter * 5000)
        found = kept.find(f"k{(number + 3) % 7}")
        wrong += found not in (None, b"a" * 5000, b"b" * 5000)
    return wrong


def test_two_processes_share_a_folder(folder: Path) -> None:
    with multiprocessing.get_context("spawn").Pool(2) as pool:
        wrong = pool.starmap(written_and_read, [(folder, b"a"), (folder, b"b")])
    assert wrong == [0, 0]
    assert not [path for path in (folder / "room").iterdir() if path.name.startswith(".")]


def test_an_entry_of_another_room_is_none(kept: KeptFiles, folder: Path) -> None:
    other = KeptFiles("hall", 1_000_000, LARGEST, lambda: folder)
    other.keep(OTHER, ENTRY)
    (folder / "hall" / NAME).write_bytes((folder / "room" / NAME).read_bytes())
    assert (other.find(OTHER), other.find(NAME), kept.find(NAME)) == (ENTRY, None, ENTRY)


def test_an_entry_as_large_as_one_may_be_is_kept(folder: Path) -> None:
    kept = kept_in(folder)
    kept.keep(NAME, bytes(LARGEST))
    assert kept.find(NAME) == bytes(LARGEST)


def test_a_full_room_keeps_all_and_one_beyond_that_is_left_three_quarters_full(folder: Path) -> None:
    """So that not each new entry looks through all others: of 8 and one more, 3 go."""
    size = 1000
    sealed = size + 32
    kept = kept_in(folder, most=8 * sealed)
    for number in range(8):
        kept.keep(f"k{number}", bytes(size))
        os.utime(folder / "room" / f"k{number}", ns=(number, number))
    assert {path.name for path in (folder / "room").iterdir()} == {f"k{number}" for number in range(8)}
    kept.keep("k8", bytes(size))
    assert {path.name for path in (folder / "room").iterdir()} == {f"k{number}" for number in range(3, 9)}
