"""Markers of a private dialect are found in docstrings and comments; `make check` limits their share."""

from pathlib import Path

from tools import plain_english

MARKERS = plain_english.markers()


def test_markers_are_counted_in_docstrings_and_comments_and_nowhere_else(tmp_path: Path) -> None:
    path = tmp_path / "one.py"
    text = '"""Return what is told."""\n\nVALUE = "what"\n"""Asked for."""\n\n# whoever wants it\n'
    path.write_text(text, "utf-8")
    found = plain_english.count(path, MARKERS)
    assert (found.words, found.markers) == (10, 5)


def test_a_marker_word_in_its_technical_sense_does_not_count() -> None:
    assert MARKERS.found("A what-if study.") == []
    assert [word for _, word in MARKERS.found("See what a study says.")] == ["what"]
