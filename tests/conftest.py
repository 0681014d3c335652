"""The order of the suite: fast tests first, whole programs last; the fixtures that several folders share."""

from pathlib import Path

import pytest
from hypothesis import HealthCheck, settings

ORDER = ("architecture", "unit", "packaging", "golden", "reference", "spec", "property", "e2e")
HERE = Path(__file__).parent

pytest_plugins = ("support.browser",)

# Both look at the clock, and the cores are shared.
settings.register_profile("suite", deadline=None, suppress_health_check=[HealthCheck.too_slow])
settings.load_profile("suite")


def pytest_collection_modifyitems(config: pytest.Config, items: list[pytest.Item]) -> None:
    """Sort by folder, tests with a browser behind all others; inside a folder the order stays.

    From the first of them on, playwright keeps an event loop in the main thread, where others could not start
    their own. For the same reason the two kinds of one module are two groups where workers run side by side;
    otherwise a module stays together, because its tests share a server.
    """
    items.sort(key=lambda item: (_in_browser(item), _folder(item)))
    if config.pluginmanager.hasplugin("xdist"):
        for item in items:
            kind = "browser " if _in_browser(item) else ""
            item.add_marker(pytest.mark.xdist_group(f"{kind}{item.path.relative_to(HERE)}"))


def _in_browser(item: pytest.Item) -> bool:
    return isinstance(item, pytest.Function) and "browser" in item.fixturenames


def _folder(item: pytest.Item) -> int:
    return ORDER.index(item.path.relative_to(HERE).parts[0])
