"""The canonical numbers of instances: depth first, each before those that nothing before it refers to."""

from dataclasses import replace

from ropsim.part21.exchange_file import ExchangeFile, Instance, Record, references
from ropsim.part21.values import Reference, Typed, Value


def canonical(file: ExchangeFile) -> ExchangeFile:
    """Return the same file with its instances numbered from 1 in their canonical order.

    Instances that nobody refers to are gone through in the order of the file, and from each of them depth
    first along its parameters; whatever is met gets the next number. Of instances that refer to each other in
    a circle the first of the file is met first. What has been brought to this order keeps it.

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
    """Give numbers to an instance and to all that it leads to, without recursion."""
    waiting = [root]
    while waiting:
        number = waiting.pop()
        if number not in order:
            order[number] = len(order) + 1
            waiting += _others(known[number])


def _others(instance: Instance) -> list[int]:
    """Return what an instance refers to, the last one first."""
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
