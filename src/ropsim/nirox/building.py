"""Instances that are built one after the other, and the further frame of an arm."""

from collections.abc import Iterable
from math import inf

from ropsim.part21 import Absent, Instance, Record, Reference, Value
from ropsim.spatial import Pose, record

Key = tuple[str | int | float, ...]
"""Key of an instance, such as `("pair", 2)`: the third joint; the base is link -1."""

UNSET, DERIVED = Absent.UNSET, Absent.DERIVED


class Building:
    """The instances that a robot becomes."""

    def __init__(self) -> None:
        self._numbers: dict[Key, int] = {}
        self._records: dict[Key, tuple[Record, ...]] = {}

    @property
    def records(self) -> dict[Key, tuple[Record, ...]]:
        """Return the records of all instances by their keys, in the order in which they were made."""
        return self._records

    @property
    def numbers(self) -> dict[Key, int]:
        """Return the numbers of all instances by their keys."""
        return self._numbers

    def add(self, key: Key, keyword: str, *values: Value) -> Reference:
        """Make a simple instance, if there is none under this key yet, and return the reference to it."""
        return self.add_complex(key, (Record(keyword, values),))

    def add_complex(self, key: Key, records: tuple[Record, ...]) -> Reference:
        """Make an instance of several entities, if there is none under this key yet."""
        if key not in self._numbers:
            self._numbers[key] = len(self._numbers) + 1
            self._records[key] = records
        return self.at(key)

    def at(self, key: Key) -> Reference:
        """Return the reference to an instance that has been made."""
        return Reference(self._numbers[key])

    def instances(self) -> tuple[Instance, ...]:
        """Return all instances; canonical numbers begin with the arm, and orientations come last."""
        order = sorted(self._records, key=_rank)
        return tuple(Instance(self._numbers[key], self._records[key]) for key in order)


def _rank(key: Key) -> int:
    first = {"origin": 0, "arm": 1}.get(str(key[0]), 2)
    return 3 if key[-1] == "orientation" else first


def reals(values: Iterable[float]) -> tuple[Value, ...]:
    """Return numbers of a vector as the elements of a list in a file."""
    return tuple(map(float, values))


def bounded(value: float) -> Value:
    """Return a number, or nothing where it stands for no bound at all."""
    return UNSET if value in (inf, -inf) else float(value)


@record
class FurtherFrame:
    """A frame on a link.

    Attributes:
        name: of the frame.
        role: an item of the enumeration `frame_role` in small letters.
        link: number of the link that carries it, from 0; -1 for the base.
        X_LF: its pose in the frame of the joint that moves that link.
    """

    name: str
    role: str
    link: int
    X_LF: Pose
