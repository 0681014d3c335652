"""Steps along joints from the base to all links of a mechanism, and the joints that are on none."""

from collections.abc import Sequence
from heapq import heappop, heappush

from ropsim.core import frozen_dataclass


@frozen_dataclass
class TreeSteps:
    """The steps to all links.

    Attributes:
        steps: number of a joint, the link that is nearer to the base, and the one that it moves; a link is
            moved before others are moved against it.
        closing: numbers of the joints whose links both have a way already.
        apart: numbers of the joints to which no way leads.
    """

    steps: tuple[tuple[int, int, int], ...]
    closing: tuple[int, ...]
    apart: tuple[int, ...]


def tree_steps(base: int, ends: Sequence[tuple[int, int]]) -> TreeSteps:
    """Return the steps along joints; the first possible joint comes next.

    Args:
        base: the link that stands still.
        ends: the two links of each joint.
    """
    at: dict[int, list[int]] = {}
    for number, pair in enumerate(ends):
        for link in pair:
            at.setdefault(link, []).append(number)
    reached, done, ready = {base}, set[int](), list[int]()
    steps, closing = [], []
    for number in at.get(base, ()):
        heappush(ready, number)
    while ready:
        number = heappop(ready)
        if number in done:
            continue
        done.add(number)
        near, far = ends[number] if ends[number][0] in reached else ends[number][::-1]
        if far in reached:
            closing.append(number)
            continue
        steps.append((number, near, far))
        reached.add(far)
        for other in at[far]:
            if other not in done:
                heappush(ready, other)
    apart = tuple(number for number in range(len(ends)) if number not in done)
    return TreeSteps(tuple(steps), tuple(closing), apart)
