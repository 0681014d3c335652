import contextlib
import os
import stat
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from itertools import count
from pathlib import Path
from threading import Thread
from typing import Any

import pytest

from ropsim.core import (
    LongFileError,
    NoOrdinaryFileError,
    create_inside,
    read_bytes,
    read_own_bytes,
    replace_file,
    replace_private_file,
)
from support.counted_system import counted, number


def test_a_file_is_replaced_as_a_whole(tmp_path: Path) -> None:
    path = tmp_path / "new" / "a.txt"
    replace_file(path, b"one")
    replace_file(path, b"two")
    assert path.read_bytes() == b"two"
    assert [entry.name for entry in path.parent.iterdir()] == ["a.txt"]


def test_a_failed_write_leaves_the_old_file_and_no_rest(tmp_path: Path) -> None:
    path = tmp_path / "a.txt"
    replace_file(path, b"old")
    with pytest.raises(TypeError):
        replace_file(path, "text is no bytes")  # type: ignore[arg-type]  # the fault that is tested
    assert path.read_bytes() == b"old"
    assert [entry.name for entry in tmp_path.iterdir()] == ["a.txt"]


def test_a_link_stays_a_link_and_its_target_is_replaced(tmp_path: Path) -> None:
    target, link = tmp_path / "runs" / "a.txt", tmp_path / "latest.txt"
    link.symlink_to(target)
    replace_file(link, b"one")
    replace_file(link, b"two")
    assert link.is_symlink()
    assert target.read_bytes() == b"two"


def test_a_replaced_file_keeps_its_permissions(tmp_path: Path) -> None:
    path = tmp_path / "a.txt"
    path.write_bytes(b"one")
    path.chmod(0o640)
    replace_file(path, b"two")
    assert stat.S_IMODE(path.stat().st_mode) == 0o640


def test_a_pipe_is_written_to_and_stays_a_pipe(tmp_path: Path) -> None:
    path = tmp_path / "pipe"
    os.mkfifo(path)
    got: list[bytes] = []
    reader = Thread(target=lambda: got.append(path.read_bytes()))
    reader.start()
    replace_file(path, b"one")
    reader.join(10.0)
    assert got == [b"one"]
    assert path.is_fifo()
    assert [entry.name for entry in tmp_path.iterdir()] == ["pipe"]


def test_a_name_of_the_greatest_length_can_be_written(tmp_path: Path) -> None:
    path = tmp_path / ("a" * 255)
    replace_file(path, b"one")
    assert path.read_bytes() == b"one"


def test_a_file_is_read_up_to_its_bound(tmp_path: Path) -> None:
    path = tmp_path / "a.txt"
    path.write_bytes(bytes(100))
    assert read_bytes(path, 100) == bytes(100)
    with pytest.raises(LongFileError, match="has more than 99 bytes"):
        read_bytes(path, 99)


@pytest.mark.skipif(not Path("/proc/self/status").exists(), reason="files that do not tell their size")
def test_a_file_that_does_not_tell_its_size_has_the_same_bound() -> None:
    path = Path("/proc/self/status")
    assert path.stat().st_size == 0
    assert b"VmSize" in read_bytes(path)
    with pytest.raises(LongFileError):
        read_bytes(path, 100)


@pytest.mark.parametrize("place", ["/dev/zero", "/dev/null", "pipe", "folder"])
def test_what_is_no_ordinary_file_is_refused_and_nobody_waits(tmp_path: Path, place: str) -> None:
    os.mkfifo(tmp_path / "pipe")
    (tmp_path / "folder").mkdir()
    (tmp_path / "link").symlink_to(tmp_path / place)
    for path in (tmp_path / place, tmp_path / "link"):
        with pytest.raises((NoOrdinaryFileError, IsADirectoryError)):
            read_bytes(path)


def test_a_file_that_others_could_have_written_is_not_the_own(tmp_path: Path) -> None:
    path, link = tmp_path / "file", tmp_path / "link"
    path.write_bytes(b"x")
    link.symlink_to(path)
    path.chmod(0o600)
    assert read_own_bytes(path) == read_own_bytes(link) == b"x"
    for others in (0o020, 0o002):
        path.chmod(0o600 | others)
        with pytest.raises(PermissionError, match="others can have written it"):
            read_own_bytes(path)


@pytest.mark.parametrize("replace", [replace_file, replace_private_file])
def test_a_new_file_is_whole_or_not_there_at_whatever_call_the_system_fails(
    tmp_path: Path, replace: Callable[[Path, bytes], None]
) -> None:
    place = tmp_path / "new"
    for at in count(1):
        with counted(tmp_path, number(at)) as counting, contextlib.suppress(OSError):
            replace(place, b"content")
        assert not place.exists() or place.read_bytes() == b"content"
        if not counting.acted:
            assert at > 4
            return
        place.unlink(missing_ok=True)


@pytest.mark.skipif(not hasattr(os, "geteuid"), reason="files without permissions")
def test_threads_write_files_with_their_permissions_and_the_mask_stays(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """All threads share the mask: a change for a moment opens the new files of the others to all."""
    mask = os.umask(0o027)
    wrong: list[str] = []

    def changed(_: int) -> int:
        raise AssertionError("the mask is changed")

    def check(place: Path, permissions: int) -> None:
        if (found := stat.S_IMODE(place.stat().st_mode)) != permissions:
            wrong.append(f"{place.name}: {found:o} instead of {permissions:o}")

    def write_files(thread: int) -> None:
        kept = tmp_path / f"kept-{thread}"
        kept.write_bytes(b"old")
        kept.chmod(0o604)
        for turn in range(25):
            new, mine = tmp_path / f"new-{thread}-{turn}", tmp_path / f"mine-{thread}-{turn}"
            inside = f"inside-{thread}-{turn}"
            replace_file(new, b"new")
            replace_file(kept, b"kept")
            replace_private_file(mine, b"mine")
            create_inside(tmp_path, inside, b"inside")
            for place, permissions in ((new, 0o640), (kept, 0o604), (mine, 0o600)):
                check(place, permissions)
            check(tmp_path / inside, 0o640)

    try:
        with monkeypatch.context() as patched, ThreadPoolExecutor(8) as pool:
            patched.setattr(os, "umask", changed)
            list(pool.map(write_files, range(8)))
    finally:
        os.umask(mask)
    assert wrong == []


@pytest.mark.skipif(not hasattr(os, "geteuid"), reason="files without permissions")
def test_nobody_else_can_open_a_file_before_it_has_its_permissions(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    place = tmp_path / "a.txt"
    place.write_bytes(b"old")
    place.chmod(0o600)
    seen: list[int] = []

    def noted(handle: int) -> None:
        seen.append(stat.S_IMODE(os.fstat(handle).st_mode))

    monkeypatch.setattr(os, "fsync", noted)
    made = os.open

    def opened(*arguments: Any, **options: Any) -> int:
        handle = made(*arguments, **options)
        noted(handle)
        return handle

    monkeypatch.setattr(os, "open", opened)
    replace_file(place, b"new")
    replace_private_file(tmp_path / "b.txt", b"new")
    assert set(seen) == {0o600}
