"""An edited sequence is put together again from its unchanged items and the changed ones."""

from operator import is_not

from hypothesis import given
from hypothesis import strategies as st

from ropsim.query import NOTHING_UNCHANGED, splice

ITEMS = st.lists(st.integers(0, 3), max_size=8)


@given(ITEMS, ITEMS)
def test_known_values_of_unchanged_items_and_new_ones_are_the_values_of_all(
    before: list[int], now: list[int]
) -> None:
    unchanged = splice(before, now)
    known = [str(one) for one in before]
    assert unchanged.spliced(known, [str(one) for one in unchanged.between(now)]) == [str(one) for one in now]


@given(ITEMS, ITEMS, ITEMS, ITEMS)
def test_no_item_outside_of_the_edit_counts_as_changed(
    above: list[int], gone: list[int], new: list[int], below: list[int]
) -> None:
    unchanged = splice([*above, *gone, *below], [*above, *new, *below])
    assert unchanged.above >= len(above)
    assert unchanged.above + unchanged.below >= len(above) + len(below)
    assert unchanged.above + unchanged.below <= len(above) + min(len(gone), len(new)) + len(below)


def test_items_may_be_compared_as_objects() -> None:
    same, other = [1.0], [1.0]
    unchanged = splice([same, same], [same, other], is_not)
    assert (unchanged.above, unchanged.below) == (1, 0)


def test_where_nothing_is_unchanged_all_values_are_new() -> None:
    assert NOTHING_UNCHANGED.spliced(["old", "old"], ["new"]) == ["new"]
