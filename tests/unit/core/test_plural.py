"""A number and its noun."""

from ropsim.core import plural


def test_one_is_one_and_the_others_are_many() -> None:
    assert [plural(count, "error") for count in (0, 1, 2)] == ["0 errors", "1 error", "2 errors"]
