"""What a file says of coordinates: which follow others, which are external, the DH table behind them."""

import numpy as np

from ropsim.model import Coupling, DhRow, JointType
from ropsim.nirox.read_mechanism import Mechanism
from ropsim.nirox.seen import Seen


def read_couplings(seen: Seen, mechanism: Mechanism) -> tuple[Coupling, ...]:
    """Return the coordinates that follow others; raises `ImpossibleError` where one is not there."""
    first = np.concatenate([[0], np.cumsum([one.type.freedoms for one in mechanism.moved])]).tolist()

    def coordinate(told: int, pair: int, place: int) -> int:
        number = mechanism.pairs.get(pair)
        if number is None or not 1 <= place <= mechanism.moved[number].type.freedoms:
            raise seen.impossible(told, f"{seen.called(pair)} has no coordinate {place} in this mechanism")
        return int(first[number]) + place - 1

    found = []
    for number, told in enumerate(seen.extent("joint_coupling")):
        seen.take(told, "coupling", number)
        places = zip(seen.refs(told, "followed"), seen.integers(told, "coordinates"), strict=True)
        others = [coordinate(told, pair, place) for pair, place in places]
        terms = tuple(zip(others, seen.reals(told, "factors"), strict=True))
        dependent = coordinate(told, seen.ref(told, "pair"), seen.integer(told, "coordinate"))
        found.append(Coupling(dependent, terms, seen.real(told, "constant_term")))
    return tuple(found)


def read_dh_table(seen: Seen, mechanism: Mechanism) -> tuple[DhRow, ...]:
    """Return the rows of the DH table; raises `ImpossibleError` where one has no joint that can have it."""
    rows = []
    for told in seen.extent("denavit_hartenberg_row"):
        number = mechanism.pairs.get(seen.ref(told, "pair"))
        type_ = mechanism.moved[number].type if number is not None else JointType.FIXED
        if number is None or type_ not in (JointType.REVOLUTE, JointType.PRISMATIC):
            raise seen.impossible(told, "a row of the table is of a pair that turns or slides")
        seen.take(told, "dh", number)
        a, alpha, d, theta = (seen.real(told, one) for one in ("a", "alpha", "d", "theta"))
        rows.append(DhRow(a, alpha, d, theta, type_))
    return tuple(rows)


def read_external(seen: Seen, pairs: list[int]) -> tuple[int, ...]:
    """Return the numbers of the external axes; raises `ImpossibleError` where one is no axis.

    Args:
        seen: the file.
        pairs: of the axes.
    """
    found: list[int] = []
    for told in seen.extent("external_axis"):
        pair = seen.ref(told, "pair")
        if pair not in pairs:
            raise seen.impossible(told, "an external axis is one of the axes of the arm")
        found.append(pairs.index(pair))
        seen.take(told, "external", found[-1])
    return tuple(found)
