"""The order of the suite: fast tests first, whole programs last; the fixtures that several folders share."""

import gc
import os
import sys
from collections.abc import Generator, Iterator
from pathlib import Path

import pytest

from support.examples import register_profiles

ORDER = ("architecture", "unit", "packaging", "golden", "reference", "spec", "property", "e2e")
LONGEST = (
    "test_studio_trouble.py",
    "test_studio_layout.py",
    "test_studio_override.py",
    "test_studio_editor.py",
    "test_studio_typing.py",
    "test_studio_stations.py",
    "test_studio_keys.py",
    "test_studio_jog.py",
    "test_studio_access.py",
    "test_studio_tasks.py",
    "test_studio_picture.py",
)
"""The longest modules with a browser come first among them: one begun last would keep a worker alone."""
QUICK = "not slow"
"""What `make test` selects."""
REST = "slow"
"""What `make test-rest` selects."""
HERE = Path(__file__).parent

pytest_plugins = ("support.browser",)

register_profiles()


@pytest.hookimpl(optionalhook=True)
def pytest_xdist_auto_num_workers(config: pytest.Config) -> int:
    """Return one worker for each core; with slow tests one more, for some wait for a page or a process."""
    cores = len(os.sched_getaffinity(0)) if sys.platform == "linux" else os.cpu_count() or 1
    return cores if config.option.markexpr == QUICK else cores + 1


def pytest_configure(config: pytest.Config) -> None:
    """Let each worker of the whole suite begin to collect elsewhere, for what one compiles the others find.

    Beginning together, each of them would compile every module of tests after a fresh checkout, two thirds of
    the time that it takes to collect them. The order of the tests is that of `pytest_collection_modifyitems`.
    """
    worker = os.environ.get("PYTEST_XDIST_WORKER")
    if worker is None or config.args != ["tests"]:
        return
    folders = [f"tests/{name}" for name in ORDER if name != "unit"]
    folders += [f"tests/unit/{path.name}" for path in (HERE / "unit").iterdir() if path.is_dir()]
    folders = sorted(one for one in folders if not one.endswith("__pycache__"))
    count = int(os.environ["PYTEST_XDIST_WORKER_COUNT"])
    begin = int(worker.removeprefix("gw")) * len(folders) // count
    config.args[:] = folders[begin:] + folders[:begin]


def pytest_ignore_collect(collection_path: Path, config: pytest.Config) -> bool | None:
    """Leave out modules without slow tests where only these are selected: importing all takes its time."""
    only_slow = config.option.markexpr == REST and collection_path.name.startswith("test_")
    return True if only_slow and not _may_be_slow(collection_path) else None


@pytest.hookimpl(wrapper=True)
def pytest_collection() -> Generator[None, object, object]:
    """Take what lasts as long as the suite out of sight of the garbage collector.

    Modules and tests are half a million objects. They would be walked through again and again while they are
    made, a tenth of the time of collecting them, and later: half a second for each call of `gc.collect`, and
    a quarter of the time of tests that make many objects.
    """
    gc.disable()
    try:
        return (yield)
    finally:
        gc.collect()
        gc.freeze()
        gc.enable()


@pytest.hookimpl(tryfirst=True)  # before tests are selected by their marks
def pytest_collection_modifyitems(items: list[pytest.Item]) -> None:
    """Mark walks in a browser as slow, and sort the tests.

    They go by folder and name, modules with a browser behind all others; inside a module the order stays.

    From the first of them on, playwright keeps an event loop in the main thread, where others could not start
    their own. Where workers run side by side a module stays together (`--dist loadfile`): its tests share a
    server and a page.
    """
    for item in items:
        if _in_browser(item) and item.get_closest_marker("smoke") is None:
            item.add_marker("slow")
    slow = {item.path for item in items if item.get_closest_marker("slow")}
    if hidden := [str(path) for path in slow if not _may_be_slow(path)]:
        raise pytest.UsageError(
            f"write pytest.mark.slow where it is used, else {REST!r} does not select it: {hidden}"
        )
    in_browser = {item.path for item in items if _in_browser(item)}
    places = {
        path: (path in in_browser, _folder(path), _rank(path.name), path)
        for path in {item.path for item in items}
    }
    items.sort(key=lambda item: places[item.path])


def _in_browser(item: pytest.Item) -> bool:
    return isinstance(item, pytest.Function) and "browser" in item.fixturenames


def _may_be_slow(module: Path) -> bool:
    """Return whether a module may have slow tests: it names the mark, or walks in a browser."""
    return module.parent == HERE / "e2e" or "pytest.mark.slow" in module.read_text("utf-8")


def _rank(module: str) -> int:
    return LONGEST.index(module) if module in LONGEST else len(LONGEST)


def _folder(module: Path) -> int:
    return ORDER.index(module.relative_to(HERE).parts[0])


@pytest.fixture(autouse=True)
def cache_findings_end_with_a_test() -> Iterator[None]:
    """A process remembers why its cache folder was refused; later commands in it would report that."""
    yield
    if kept_files := sys.modules.get("ropsim.core.disk.kept_files"):
        kept_files._findings.clear()
