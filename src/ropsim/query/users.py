"""Which answers are made of something: mostly one or two, sometimes thousands."""

from collections.abc import Container, Hashable

Key = tuple[Hashable, ...]
Users = tuple[Key, ...] | set[Key]
"""A tuple while they are few: most answers have few users, and a set takes the memory of twenty keys."""

FEW = 8


def with_user(users: Users, key: Key) -> Users:
    """Return users and one more; a set is changed."""
    if key in users:
        return users
    if isinstance(users, tuple):
        if len(users) < FEW:
            return (*users, key)
        users = set(users)
    users.add(key)
    return users


def without_user(users: Users, key: Key) -> Users:
    """Return the users without one of them; a set is changed."""
    if isinstance(users, tuple):
        return tuple(one for one in users if one != key)
    users.discard(key)
    return users


def kept_users(users: Users, kept: Container[Key]) -> Users:
    """Return the users that are kept."""
    found = (one for one in users if one in kept)
    return tuple(found) if isinstance(users, tuple) else set(found)
