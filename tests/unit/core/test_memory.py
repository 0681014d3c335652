"""What is kept for good is not looked through for garbage again and again."""

import gc
from collections.abc import Iterator

import pytest

from ropsim.core import keep_from_collection, kept_from_collection
from ropsim.core.memory import MANY


@pytest.fixture
def kept() -> int:
    """Return how many objects are kept from searches before a test: all that there are.

    They stay so. Given back to the searches, the half million objects of tests that wait for their turn
    would cost each `gc.collect` in later modules half a second.
    """
    gc.enable()
    gc.collect()
    gc.freeze()
    return gc.get_freeze_count()


@pytest.fixture(autouse=True)
def _searched_as_before() -> Iterator[None]:
    yield
    gc.enable()


def looked_at() -> int:
    """Return how many objects a search for garbage goes through."""
    return len(gc.get_objects())


def test_much_that_is_made_is_never_looked_at(kept: int) -> None:
    with kept_from_collection():
        made = [[k] for k in range(MANY + 1_000)]
    assert gc.isenabled()
    assert looked_at() < len(made) // 10
    assert gc.get_freeze_count() > kept + MANY  # a few of those kept before may have gone


def test_little_that_is_made_is_looked_at_as_before(kept: int) -> None:
    with kept_from_collection():
        made = [[k] for k in range(1_000)]
    assert looked_at() > len(made)
    assert gc.get_freeze_count() <= kept


def test_where_others_have_switched_the_search_off_it_stays_off() -> None:
    gc.disable()
    with kept_from_collection():
        made = [[k] for k in range(10)]
    assert len(made) == 10
    assert not gc.isenabled()


def test_what_there_is_between_two_jobs_is_not_looked_at_any_more_but_circles_have_gone(kept: int) -> None:
    remembered = [[k] for k in range(1_000)]
    circles: list[list[object]] = [[] for _ in range(1_000)]
    for one in circles:
        one.append(one)
    del circles[:], one
    keep_from_collection()
    assert looked_at() < len(remembered) // 10
    assert abs(gc.get_freeze_count() - kept - len(remembered)) < len(remembered) // 10
