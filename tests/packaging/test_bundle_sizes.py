"""Budgets of the built pages: what a browser loads at once, what later, what every report carries."""

import pytest

from support.bundle import (
    STATIC,
    compressed,
    of_the_replay,
    scripts_at_once,
    scripts_of_the_editor,
    styles_at_once,
)

AT_ONCE = 400_000
"""Compressed scripts and styles that the first page asks for, in bytes."""
EDITOR = 170_000
"""Compressed scripts that are loaded when an editor opens, in bytes."""
REPLAY = 1_050_000
"""Script and style of the replay, in bytes as they stand in a report."""

pytestmark = pytest.mark.skipif(
    not STATIC.is_dir(), reason="the pages are not built (`make demo` builds them)"
)


def test_the_first_page_is_within_its_budget() -> None:
    scripts, styles = scripts_at_once(), styles_at_once()
    assert scripts
    assert styles
    assert compressed(scripts | styles) <= AT_ONCE


def test_the_editor_comes_later_and_is_within_its_budget() -> None:
    scripts = scripts_of_the_editor()
    assert scripts
    assert scripts.isdisjoint(scripts_at_once())
    assert compressed(scripts) <= EDITOR


def test_the_replay_is_within_its_budget() -> None:
    assert sum(path.stat().st_size for path in of_the_replay()) <= REPLAY


def test_the_pages_carry_the_notices_of_what_they_contain() -> None:
    for folder in ("studio", "replay"):
        assert "## three" in (STATIC / folder / "licenses.md").read_text("utf-8")
    assert "three.js authors" in (STATIC / "replay" / "replay.js").read_text("utf-8")[:4000]
