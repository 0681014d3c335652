"""The schema of controllers, and its files, read like by other readers."""

import pytest
from steputils import p21

from ropsim.blockdiagram import published_controller
from ropsim.blockdiagram.testing import BLOCK_FORMS, BlockForm, control_schema, control_schema_text
from ropsim.part21 import Absent, Enumeration, Reference, Value, read_exchange
from support.express_oracle import seen_by_another_reader, seen_by_ours


def test_another_reader_of_express_sees_the_same_schema() -> None:
    assert seen_by_another_reader(control_schema_text().text) == seen_by_ours(control_schema())


@pytest.mark.parametrize("form", BLOCK_FORMS, ids=lambda form: form.entity)
def test_fields_of_blocks_stand_in_the_order_of_the_schema(form: BlockForm) -> None:
    names = [one.attribute.name for one in control_schema().parameters[form.entity]][3:]
    own = [name for name, _ in form.fields]
    assert [name.replace("matrix_of_gains", "matrix") for name in names] == own


def plain(value: Value) -> object:
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


def test_another_reader_of_exchange_files_sees_the_same_controller() -> None:
    text = published_controller("manutec_r3")
    file, _ = read_exchange(text)
    (data,) = p21.loads(text.text).data
    seen = {
        instance.ref: (instance.entity.name, tuple(instance.entity.params))
        for instance in data.instances.values()
    }
    ours = {
        f"#{instance.number}": (
            instance.records[0].keyword,
            tuple(plain(value) for value in instance.records[0].values),
        )
        for instance in file.instances
    }
    assert seen == ours
