"""Results within a room: what goes when there is none, and when nobody has asked for long."""

from ropsim.simulation.testing import KeptResults


def test_what_is_put_is_found_and_counted() -> None:
    kept: KeptResults[str] = KeptResults(10)
    kept.put("a", "one", 4)
    kept.put("a", "two", 6)
    assert (kept.get("a"), kept.get("b"), kept.used) == ("two", None, 6)


def test_room_is_made_by_what_neither_this_run_nor_the_one_before_has_asked_for() -> None:
    kept: KeptResults[str] = KeptResults(10)
    for run, key in enumerate("abc"):
        kept.begin()
        kept.put(key, key, 3)
        assert kept.used == 3 * (run + 1)
    kept.put("d", "d", 4)
    assert [kept.get(key) for key in "abcd"] == [None, "b", "c", "d"]
    kept.put("e", "e", 4)
    assert (kept.get("e"), kept.used) == (None, 10)


def test_what_is_larger_than_the_room_is_not_kept() -> None:
    kept: KeptResults[str] = KeptResults(10)
    kept.put("a", "a", 11)
    assert (kept.get("a"), kept.used) == (None, 0)


def test_what_four_runs_have_not_asked_for_goes() -> None:
    kept: KeptResults[str] = KeptResults(10)
    kept.put("a", "a", 1)
    kept.put("b", "b", 1)
    for _ in range(4):
        kept.begin()
        kept.get("b")
    assert (kept.get("a"), kept.used) == ("a", 2)
    for _ in range(5):
        kept.begin()
        kept.get("b")
    assert (kept.get("a"), kept.get("b"), kept.used) == (None, "b", 1)
