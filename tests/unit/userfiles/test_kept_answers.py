"""Answers in the cache folder: whole or none, of nobody else, and not too many."""

import multiprocessing
import os
import random
from pathlib import Path

import pytest

from ropsim.userfiles import KeptAnswers

KEY = "ab12-translated"
ANSWER = bytes(range(256)) * 20


@pytest.fixture
def kept(tmp_path: Path) -> KeptAnswers:
    """Return a folder with one answer."""
    made = KeptAnswers(tmp_path / "answers")
    made.keep(KEY, ANSWER)
    return made


def test_an_answer_comes_back_as_it_was_given(kept: KeptAnswers) -> None:
    assert kept.find(KEY) == ANSWER
    assert kept.find("ab13-translated") is None
    kept.keep(KEY, b"")
    assert kept.find(KEY) == b""


def test_an_answer_under_the_name_of_another_one_is_none(kept: KeptAnswers) -> None:
    (kept.folder / KEY).rename(kept.folder / "ab13-translated")
    assert kept.find("ab13-translated") is None


@pytest.mark.skipif(not hasattr(os, "geteuid"), reason="no permissions of files")
def test_an_answer_comes_back_where_groups_may_write_to_what_is_made(tmp_path: Path) -> None:
    before = os.umask(0o002)
    try:
        kept = KeptAnswers(tmp_path / "answers")
        kept.keep(KEY, ANSWER)
    finally:
        os.umask(before)
    assert kept.find(KEY) == ANSWER
    assert (kept.folder / KEY).stat().st_mode & 0o077 == 0


def test_a_folder_that_is_gone_has_no_answers_and_takes_new_ones(kept: KeptAnswers) -> None:
    (kept.folder / KEY).unlink()
    kept.folder.rmdir()
    assert kept.find(KEY) is None
    kept.keep(KEY, ANSWER)
    assert kept.find(KEY) == ANSWER


def test_a_damaged_answer_is_none(kept: KeptAnswers) -> None:
    path = kept.folder / KEY
    content = path.read_bytes()
    chosen = random.Random(1)
    for _ in range(300):
        damaged = bytearray(content)
        damaged[chosen.randrange(len(damaged))] ^= 1 << chosen.randrange(8)
        path.write_bytes(damaged[: chosen.choice([len(damaged), chosen.randrange(len(damaged))])])
        assert kept.find(KEY) is None
    path.write_bytes(content)
    assert kept.find(KEY) == ANSWER


@pytest.mark.skipif(not hasattr(os, "geteuid"), reason="no owners of files")
def test_what_others_may_have_written_is_not_read(kept: KeptAnswers, tmp_path: Path) -> None:
    path = kept.folder / KEY
    for place in (kept.folder, path):
        mode = place.stat().st_mode
        for others in (0o020, 0o002):
            place.chmod(mode | others)
            assert kept.find(KEY) is None
        place.chmod(mode)
    moved = path.rename(tmp_path / "elsewhere")
    path.symlink_to(moved)
    assert kept.find(KEY) is None
    path.unlink()
    path.mkdir()
    assert kept.find(KEY) is None
    path.rmdir()
    moved.rename(path)
    assert kept.find(KEY) == ANSWER
    real = kept.folder.rename(tmp_path / "real")
    kept.folder.symlink_to(real)
    assert kept.find(KEY) is None


@pytest.mark.skipif(not hasattr(os, "geteuid"), reason="no owners of files")
def test_a_folder_of_somebody_else_is_not_used(kept: KeptAnswers, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(os, "geteuid", lambda: os.getuid() + 1)
    assert kept.find(KEY) is None
    kept.keep("other", ANSWER)
    assert sorted(path.name for path in kept.folder.iterdir()) == [KEY]


def test_what_was_not_used_for_longest_makes_room(tmp_path: Path) -> None:
    kept = KeptAnswers(tmp_path, most=10_000)
    for number in range(8):
        kept.keep(f"k{number}", bytes(1000))
        os.utime(tmp_path / f"k{number}", ns=(number, number))
    assert kept.find("k0") == bytes(1000)  # which is used now
    kept.keep("large", bytes(3000))
    assert sum(path.stat().st_size for path in tmp_path.iterdir()) <= 10_000
    assert kept.find("k1") is kept.find("k2") is None
    assert kept.find("k0") is not None
    assert kept.find("large") is not None


def written_and_read(folder: Path, letter: bytes) -> int:
    kept = KeptAnswers(folder, most=60_000)
    wrong = 0
    for number in range(60):
        kept.keep(f"k{number % 7}", letter * 5000)
        found = kept.find(f"k{(number + 3) % 7}")
        wrong += found not in (None, b"a" * 5000, b"b" * 5000)
    return wrong


def test_two_processes_share_a_folder(tmp_path: Path) -> None:
    with multiprocessing.get_context("spawn").Pool(2) as pool:
        wrong = pool.starmap(written_and_read, [(tmp_path, b"a"), (tmp_path, b"b")])
    assert wrong == [0, 0]
    assert not [path for path in tmp_path.iterdir() if path.name.startswith(".")]
