"""Another reader of exchange files, steputils, sees in a written robot what was written, value by value."""

from typing import Any

import pytest
from steputils import p21

from ropsim import robots
from ropsim.core import SourceText
from ropsim.nirox import write_nirox
from ropsim.part21 import Absent, Enumeration, Reference, Value, read_exchange
from support.built_in import WRITTEN


def plain(value: Value) -> Any:
    """Return a parameter as steputils has it."""
    match value:
        case Reference(number):
            return f"#{number}"
        case Enumeration(name):
            return f".{name}."
        case Absent():
            return value.value
        case tuple():
            return tuple(plain(one) for one in value)
        case _:
            return value


@pytest.mark.parametrize("name", WRITTEN)
def test_another_reader_sees_the_same_instances(name: str) -> None:
    text = write_nirox(robots.load(name)).text
    file, _ = read_exchange(SourceText("a.stp", text))
    (data,) = p21.loads(text).data
    seen = {
        instance.ref: [
            (one.name, tuple(one.params)) for one in getattr(instance, "entities", None) or [instance.entity]
        ]
        for instance in data.instances.values()
    }
    ours = {
        f"#{instance.number}": [
            (record.keyword, tuple(plain(value) for value in record.values)) for record in instance.records
        ]
        for instance in file.instances
    }
    assert seen == ours
