"""The table of the kinds of blocks: checks, wiring and the manual follow it."""

import re
from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest

from ropsim import blockdiagram as b
from ropsim.blockdiagram.testing import (
    BLOCK_FORMS,
    FORM_OF,
    BlockForm,
    FieldKind,
    Trait,
    faults_of,
    tustin_filter,
)
from ropsim.core import frozen_dataclass

MANUAL = (Path(__file__).parents[3] / "docs" / "reference" / "controller-file.md").read_text("utf-8")
PERIOD = 0.001
SAMPLES = {
    b.Gain: ((2.0,),),
    b.Sum: ((1,),),
    b.TransferFunction: ((1.0,), (1.0, 1.0), b.Method.TUSTIN, PERIOD),
    b.Integrator: ((1.0,), (0.0,), PERIOD),
    b.Saturation: ((-1.0,), (1.0,)),
    b.RateLimiter: ((-1.0,), (1.0,), PERIOD),
    b.DeadBand: ((-1.0,), (1.0,)),
    b.Delay: (1,),
    b.Lookup: ((0.0, 1.0), (0.0, 1.0)),
    b.Notch: (100.0, 0.5, 0.5, PERIOD),
    b.MovingFilter: (2,),
}
"""Fields of blocks that take one input."""
SINGLE = [one for one in BLOCK_FORMS if one.inputs[0] == 1 and Trait.ELEMENTWISE in one.traits]


@frozen_dataclass
class LeadLag(b.Block):
    """A block of a kind that the table does not have."""

    lead: float
    lag: float
    sample_time: float


LEAD_LAG = BlockForm(
    "lead_lag",
    LeadLag,
    tuple((name, FieldKind.REAL) for name in ("lead", "lag", "sample_time")),
    traits=Trait.ELEMENTWISE | Trait.KEEPS_UNITS,
    faults=lambda block: () if block.lag > 0.0 else ("`lag` must be positive",),
    filter=lambda block: tustin_filter((block.lead, 1.0), (block.lag, 1.0), 2.0 / block.sample_time),
)


def around(block: b.Block, taken: b.Signal, given: b.Signal) -> b.Diagram:
    """Return a diagram of one block between a signal of the cell and the output."""
    return b.Diagram("d", PERIOD, (taken, given), (block,), b.OutputKind.EFFORT)


def codes(
    kind: type[Any], fields: tuple[object, ...], size: int = 1, unit: b.Unit = b.Unit.NEWTON
) -> list[str]:
    """Return the codes of the faults of a block with an input of one size and unit, and an output of two."""
    taken = b.Signal("r", size, (unit,), b.Role.EXTERNAL, "signal")
    given = b.Signal("u", 2, (b.Unit.NEWTON,), b.Role.OUTPUT)
    return [one.kind.code for one in faults_of(around(kind("one", ("r",), "u", *fields), taken, given))]


def test_every_kind_of_block_with_one_input_has_a_sample() -> None:
    assert {one.block for one in SINGLE} == set(SAMPLES)


@pytest.mark.parametrize("form", SINGLE, ids=lambda form: form.entity)
def test_an_elementwise_block_takes_as_many_elements_as_it_gives(form: BlockForm) -> None:
    assert codes(form.block, SAMPLES[form.block], size=2, unit=b.Unit.NEWTON) == []
    assert codes(form.block, SAMPLES[form.block], size=3) == ["C621"]


@pytest.mark.parametrize("form", SINGLE, ids=lambda form: form.entity)
def test_a_block_that_keeps_units_does_not_turn_metres_into_newtons(form: BlockForm) -> None:
    found = codes(form.block, SAMPLES[form.block], size=2, unit=b.Unit.METRE)
    assert found == (["C623"] if Trait.KEEPS_UNITS in form.traits else [])


def test_a_new_form_alone_brings_the_checks(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(FORM_OF, LeadLag, LEAD_LAG)
    assert codes(LeadLag, (0.1, 0.01, PERIOD), size=2) == []
    assert codes(LeadLag, (0.1, 0.01, PERIOD), size=3) == ["C621"]
    assert codes(LeadLag, (0.1, 0.01, PERIOD), size=2, unit=b.Unit.METRE) == ["C623"]
    assert codes(LeadLag, (0.1, 0.0, PERIOD), size=2) == ["C625"]
    assert codes(LeadLag, (0.1, 0.01, 2.0 * PERIOD), size=2) == ["C625"]
    block = LeadLag("one", ("r",), "u", 0.1, 0.01, PERIOD)
    found = b.filter_of(block)
    assert found is not None
    assert found.steady_gain == pytest.approx(1.0)
    assert found.b[0] == pytest.approx((0.1 + PERIOD / 2.0) / (0.01 + PERIOD / 2.0))
    assert b.passes_at_once(block)
    assert not b.passes_at_once(replace(block, lead=-PERIOD / 2.0))


def test_the_manual_has_a_row_for_every_kind_of_block() -> None:
    table = MANUAL.split("\n## Blocks\n")[1].split("\n## ")[0]
    assert re.findall(r"^\| `(\w+)` \|", table, re.MULTILINE) == [one.entity.upper() for one in BLOCK_FORMS]
