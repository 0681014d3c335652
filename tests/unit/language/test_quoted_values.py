"""A value that is refused is named as the user wrote it, with its SI number where that says more."""

import pytest

from support.tasks import only

HEAD = "program p\nunits mm, deg, s\n"


@pytest.mark.parametrize(
    ("line", "found"),
    [
        ("wait -5 ms", "found `-5 ms` (-0.005 s)"),
        ("wait -2 s", "found `-2 s`"),
        ("wait until part_ok timeout -2", "found `-2` (-2 s)"),
        ("lin infeed speed -20 mm/s", "found `-20 mm/s` (-0.02 m/s)"),
        ("lin infeed blend -3", "found `-3` (-0.003 m)"),
        ("mov infeed speed 140 %", "`speed` is `140 %`, at most 100 % is allowed"),
        ("const v = -30 mm/s\nlin infeed speed v", "found `v` (-0.03 m/s)"),
        ("circ via infeed to infeed offset (0, 50, 50) angle -20 deg", "found `-20 deg` (-0.349066 rad)"),
        ("lin infeed until part_ok timeout -1 s", "found `-1 s`"),
        ("lin (1e12 * 1e6, 0, 0)", "is `1e12 * 1e6` (1e+15 m), at most"),
    ],
)
def test_the_message_names_the_value_as_it_is_written(line: str, found: str) -> None:
    assert found in only(HEAD + line).message
