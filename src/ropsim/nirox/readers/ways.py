"""The ways from the base to all links of a mechanism, and the joints that are on none."""

from collections.abc import Sequence
from heapq import heappop, heappush

from ropsim.core import frozen_dataclass


@frozen_dataclass
class Ways:
    """The ways to all links.

    Attributes:
        steps: number of a joint, the link that is nearer to the base, and the one that it moves; a link is
            moved before others are moved against it.
        closing: numbers of the joints whose links both have a way already.
        apart: numbers of the joints to which no way leads.
    """

    steps: tuple[tuple[int, int, int], ...]
    closing: tuple[int, ...]
    apart: tuple[int, ...]


def ways(base: int, ends: Sequence[tuple[int, int]]) -> Ways:
    """Return the ways along joints; the first possible one comes next.

    Args:
        base: the link that stands still.
        ends: the two links of each joint.
    """
    at: dict[int, list[int]] = {}
    for place, pair in enumerate(ends):
        for link in pair:
            at.setdefault(link, []).append(place)
    reached, done, ready = {base}, set[int](), list[int]()
    steps, closing = [], []
    for place in at.get(base, ()):
        heappush(ready, place)
    while ready:
        place = heappop(ready)
        if place in done:
            continue
        done.add(place)
        near, far = ends[place] if ends[place][0] in reached else ends[place][::-1]
        if far in reached:
            closing.append(place)
            continue
        steps.append((place, near, far))
        reached.add(far)
        for other in at[far]:
            if other not in done:
                heappush(ready, other)
    apart = tuple(place for place in range(len(ends)) if place not in done)
    return Ways(tuple(steps), tuple(closing), apart)
