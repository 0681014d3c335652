"""Docstrings and comments are plain technical English: few words of a private dialect per 1,000 words."""

from pathlib import Path

import pytest
from tools import plain_english

MARKERS = plain_english.markers()
PACKAGES = {path.name: path for path in plain_english.packages()}


def _share(package: str) -> float:
    return plain_english.total(package, plain_english.counts(PACKAGES[package], MARKERS)).share


@pytest.mark.parametrize("package", sorted(PACKAGES))
def test_the_prose_of_a_package_is_plain(package: str) -> None:
    assert _share(package) <= plain_english.LIMIT, f"python tools/plain_english.py --words {package}"


def test_markers_are_counted_in_docstrings_and_comments_and_nowhere_else(tmp_path: Path) -> None:
    path = tmp_path / "one.py"
    text = '"""Return what is told."""\n\nVALUE = "what"\n"""Asked for."""\n\n# whoever wants it\n'
    path.write_text(text, "utf-8")
    found = plain_english.count(path, MARKERS)
    assert (found.words, found.markers) == (10, 5)


def test_a_marker_word_in_its_technical_sense_does_not_count() -> None:
    assert MARKERS.found("A what-if study.") == []
    assert [word for _, word in MARKERS.found("See what a study says.")] == ["what"]
