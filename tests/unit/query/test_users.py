"""Users of an answer are a set, however it is kept."""

import random

import pytest

from ropsim.query.users import FEW, Key, Users, kept_users, with_user, without_user
from support.examples import examples


@pytest.mark.parametrize("seed", range(examples(30)))
def test_users_are_those_that_came_and_did_not_go(seed: int) -> None:
    rng = random.Random(seed)
    users: Users = ()
    there: set[Key] = set()
    for _ in range(200):
        key: Key = (rng.randrange(2 * FEW), "asked")
        chosen = rng.random()
        if chosen < 0.55:
            users = with_user(users, key)
            there.add(key)
        elif chosen < 0.95:
            users = without_user(users, key)
            there.discard(key)
        else:
            kept = {one for one in there if rng.random() < 0.7}
            users = kept_users(users, kept)
            there &= kept
        assert set(users) == there
        assert len(users) == len(there)


def test_few_users_are_a_tuple_that_nobody_changes() -> None:
    one = with_user((), ("a",))
    assert with_user(one, ("b",)) == (("a",), ("b",))
    assert without_user(one, ("a",)) == ()
    assert one == (("a",),)
