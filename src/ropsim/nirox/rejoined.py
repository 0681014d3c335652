"""The instances of a robot, joined with the other data of its file."""

from ropsim.nirox.building import Building
from ropsim.nirox.further_data import FurtherData
from ropsim.part21 import Instance, Record, Reference, Typed, Value, references


def rejoined(building: Building, further: FurtherData) -> tuple[tuple[Instance, ...], tuple[Instance, ...]]:
    """Return all instances to be written, and the kept ones whose references are lost.

    Args:
        building: the instances of the robot.
        further: other data of its file; its instances have the numbers of that file.
    """
    joining = _Joining(building, further)
    own = tuple(joining.own(instance) for instance in building.instances())
    return (*own, *joining.kept()), joining.lost()


class _Joining:
    def __init__(self, building: Building, further: FurtherData) -> None:
        self._building = building
        self._further = further
        self._keys = {number: key for key, number in building.numbers.items()}
        wanted = {number: None for number in further.numbers}
        for others in further.further.values():
            wanted.update(dict.fromkeys(others))
        for _, number in further.replaced.values():
            wanted.update(dict.fromkeys(self._others(number)))
        self._bad: set[int] = set()
        self._copied = self._closed(list(wanted))
        order = [one for one in further.instances if one in self._copied and one not in self._bad]
        first = len(building.numbers) + 1
        self._numbers = {number: first + place for place, number in enumerate(order)}

    def own(self, instance: Instance) -> Instance:
        """Return an instance of the robot with its other data from the file."""
        key, data = self._keys[instance.number], self._further
        if key in data.replaced:
            written, number = data.replaced[key]
            original = data.instances[number]
            if _plain(written) == _plain(instance.records[0].values) and self._can_be(number):
                return Instance(instance.number, tuple(map(self._mapped, original.records)))
        if len(instance.records) > 1:
            return instance
        record = instance.records[0]
        values = list(record.values)
        changes = {
            place: data.changes[key, place] for place in range(len(values)) if (key, place) in data.changes
        }
        if all(values[place] == ours for place, (ours, _) in changes.items()):
            for place, (_, theirs) in changes.items():
                values[place] = theirs
        for place, value in enumerate(values):
            more = [one for one in data.further.get((key, place), ()) if one in self._numbers]
            if more and isinstance(value, tuple):
                values[place] = (*value, *(Reference(self._numbers[one]) for one in more))
        return Instance(instance.number, (Record(record.keyword, tuple(values)),))

    def kept(self) -> tuple[Instance, ...]:
        """Return the kept instances, with new numbers."""
        return tuple(
            Instance(number, tuple(map(self._mapped, self._further.instances[original].records)))
            for original, number in self._numbers.items()
        )

    def lost(self) -> tuple[Instance, ...]:
        """Return the kept instances that refer to instances the robot no longer has."""
        return tuple(self._further.instances[one] for one in self._further.numbers if one in self._bad)

    def _others(self, number: int) -> list[int]:
        """Return the references of an instance of the file that the robot does not write itself."""
        found = []
        for record in self._further.instances[number].records:
            found += [one for one in references(record.values) if not self._is_own(one)]
        return found

    def _is_own(self, number: int) -> bool:
        return self._further.keys.get(number) in self._building.numbers

    def _can_be(self, number: int) -> bool:
        return all(one in self._numbers for one in self._others(number))

    def _closed(self, waiting: list[int]) -> set[int]:
        """Return the instances with all that they refer to; instances with lost references are excluded."""
        found: set[int] = set()
        users: dict[int, list[int]] = {}
        while waiting:
            number = waiting.pop()
            if number in found:
                continue
            found.add(number)
            if number in self._further.keys and number not in self._further.numbers:
                self._bad.add(number)
            for other in self._others(number):
                users.setdefault(other, []).append(number)
                waiting.append(other)
        spreading = list(self._bad)
        while spreading:
            for user in users.get(spreading.pop(), ()):
                if user not in self._bad:
                    self._bad.add(user)
                    spreading.append(user)
        return found

    def _mapped(self, record: Record) -> Record:
        return Record(record.keyword, tuple(map(self._turned, record.values)))

    def _turned(self, value: Value) -> Value:
        if isinstance(value, Reference):
            key = self._further.keys.get(value.number)
            own = self._building.numbers.get(key) if key is not None else None
            return Reference(own if own is not None else self._numbers[value.number])
        if isinstance(value, tuple):
            return tuple(map(self._turned, value))
        return Typed(value.keyword, self._turned(value.value)) if isinstance(value, Typed) else value


def _plain(values: tuple[Value, ...]) -> tuple[Value, ...]:
    """Return parameters without references, whose numbers say nothing."""
    return tuple(one for one in values if not isinstance(one, Reference))
