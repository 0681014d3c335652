"""The browser of the figures of the studio: that of the tests, but as fast as users have it."""

from collections.abc import Iterator
from typing import TYPE_CHECKING

import pytest

from support.browser import FLAGS, launched, open_page

if TYPE_CHECKING:
    from playwright.sync_api import Browser

__all__ = ["browser", "open_page"]


@pytest.fixture(scope="session")
def browser() -> Iterator["Browser"]:
    """Return the system's Chromium, drawing with software GL."""
    yield from launched(FLAGS)
