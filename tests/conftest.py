"""The order of the suite: fast tests first, whole programs last."""

from pathlib import Path

import pytest

ORDER = ("architecture", "unit", "golden", "reference", "spec", "property", "e2e")
HERE = Path(__file__).parent


def pytest_collection_modifyitems(items: list[pytest.Item]) -> None:
    """Sort by folder; inside a folder the order stays."""
    items.sort(key=lambda item: ORDER.index(item.path.relative_to(HERE).parts[0]))
