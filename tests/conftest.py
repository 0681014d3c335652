"""The order of the suite: fast tests first, whole programs last; the fixtures that several folders share."""

from pathlib import Path

import pytest

ORDER = ("architecture", "unit", "packaging", "golden", "reference", "spec", "property", "e2e")
HERE = Path(__file__).parent

pytest_plugins = ("support.browser",)


def pytest_collection_modifyitems(items: list[pytest.Item]) -> None:
    """Sort by folder, tests with a browser behind all others; inside a folder the order stays.

    From the first of them on, playwright keeps an event loop in the main thread, where others could not start
    their own.
    """
    items.sort(key=lambda item: ("browser" in _fixtures(item), _folder(item)))


def _fixtures(item: pytest.Item) -> list[str]:
    return item.fixturenames if isinstance(item, pytest.Function) else []


def _folder(item: pytest.Item) -> int:
    return ORDER.index(item.path.relative_to(HERE).parts[0])
