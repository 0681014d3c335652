"""What is said to names that no built-in robot has."""

import pytest

from ropsim import robots
from ropsim.robots import UnknownRobotError


@pytest.mark.parametrize(
    ("name", "hint"),
    [
        ("puma650", "did you mean `puma560`?"),
        ("robots/my_arm.stp", "`ropsim.load_robot` reads files"),
        ("robots\\my_arm", "`ropsim.load_robot` reads files"),
    ],
)
def test_a_name_is_answered_with_a_near_one_and_a_path_with_what_reads_it(name: str, hint: str) -> None:
    with pytest.raises(UnknownRobotError) as refused:
        robots.load(name)
    assert refused.value.diagnostic.hint == hint
