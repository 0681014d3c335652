"""Budgets of the built pages: what a browser loads at once, what later, what every report carries."""

import gzip
import re
from collections.abc import Iterable
from pathlib import Path

import pytest

import ropsim

STATIC = Path(ropsim.__file__).parent / "static"
AT_ONCE = 400_000
"""Compressed scripts and styles that the first page asks for, in bytes."""
EDITOR = 170_000
"""Compressed scripts that are loaded when an editor opens, in bytes."""
REPLAY = 1_050_000
"""Script and style of the replay, in bytes as they stand in a report."""

pytestmark = pytest.mark.skipif(
    not STATIC.is_dir(), reason="the pages are not built (`make demo` builds them)"
)


def compressed(paths: Iterable[Path]) -> int:
    """Return the total size of files as sent with gzip."""
    return sum(len(gzip.compress(path.read_bytes(), 9)) for path in paths)


def scripts_at_once() -> set[Path]:
    """Return the scripts that index.html names: the entry and what it imports statically."""
    index = (STATIC / "studio" / "index.html").read_text("utf-8")
    return {STATIC / "studio" / name for name in re.findall(r'"/(assets/[^"]+\.js)"', index)}


def scripts_of_the_editor() -> set[Path]:
    """Return the scripts that hold CodeMirror, known by one of its class names."""
    scripts = (STATIC / "studio").rglob("*.js")
    return {path for path in scripts if "cm-widgetBuffer" in path.read_text("utf-8")}


def test_the_first_page_is_within_its_budget() -> None:
    scripts = scripts_at_once()
    assert scripts
    assert compressed(scripts | set((STATIC / "studio").rglob("*.css"))) <= AT_ONCE


def test_the_editor_comes_later_and_is_within_its_budget() -> None:
    scripts = scripts_of_the_editor()
    assert scripts
    assert scripts.isdisjoint(scripts_at_once())
    assert compressed(scripts) <= EDITOR


def test_the_replay_is_within_its_budget() -> None:
    assert sum((STATIC / "replay" / name).stat().st_size for name in ("replay.js", "replay.css")) <= REPLAY


def test_the_pages_carry_the_notices_of_what_they_contain() -> None:
    for folder in ("studio", "replay"):
        assert "## three" in (STATIC / folder / "licenses.md").read_text("utf-8")
    assert "three.js authors" in (STATIC / "replay" / "replay.js").read_text("utf-8")[:4000]
