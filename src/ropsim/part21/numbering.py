"""The canonical numbers of instances: depth first, each before unreferenced later ones."""

from dataclasses import replace

from ropsim.part21.exchange_file import ExchangeFile, Instance, Record, references
from ropsim.part21.values import Reference, Typed, Value


def canonical(file: ExchangeFile) -> ExchangeFile:
    """Return the same file with its instances numbered from 1 in their canonical order.

    The traversal starts at each unreferenced instance, in the order of the file, and follows its parameters
    depth first; every visited instance gets the next number. A circle of references is entered at its first
    instance in the file. A file in this order keeps its numbers.

    Args:
        file: without references to nothing.
    """
    known = {instance.number: instance for instance in file.instances}
    referred = {
        other
        for instance in file.instances
        for record in instance.records
        for other in references(record.values)
        if other != instance.number
    }
    order: dict[int, int] = {}
    roots = [instance.number for instance in file.instances if instance.number not in referred]
    for root in (*roots, *known):
        _visit(root, known, order)
    return replace(file, instances=tuple(_renumbered(known[number], order) for number in order), places=None)


def _visit(root: int, known: dict[int, Instance], order: dict[int, int]) -> None:
    """Assign numbers to an instance and to all instances reachable from it, without recursion."""
    waiting = [root]
    while waiting:
        number = waiting.pop()
        if number not in order:
            order[number] = len(order) + 1
            waiting += _others(known[number])


def _others(instance: Instance) -> list[int]:
    """Return the references of an instance, the last one first."""
    found = [number for record in instance.records for number in references(record.values)]
    return list(reversed(found))


def _renumbered(instance: Instance, order: dict[int, int]) -> Instance:
    records = tuple(
        Record(record.keyword, tuple(_turned(value, order) for value in record.values))
        for record in instance.records
    )
    return Instance(order[instance.number], records)


def _turned(value: Value, order: dict[int, int]) -> Value:
    if isinstance(value, Reference):
        return Reference(order[value.number])
    if isinstance(value, tuple):
        return tuple(_turned(one, order) for one in value)
    if isinstance(value, Typed):
        return Typed(value.keyword, _turned(value.value, order))
    return value
