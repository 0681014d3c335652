"""The browser of the tests, for the figures of the studio."""

from support.browser import browser, open_page

__all__ = ["browser", "open_page"]
