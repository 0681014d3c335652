"""A law in Python that raises: the finding names its class, the time, and the form of such laws."""

import numpy as np
import pytest

from ropsim.controller import LawTraits, step_failed
from ropsim.core import Category
from ropsim.model import InputKind
from ropsim.spatial import Array


class Mine:
    """Reaches beyond its array."""

    traits = LawTraits(InputKind.VOLTAGE, ())

    def step(self, now: object, state: Array, /) -> Array:
        return np.asarray(state[7 if now is None else 8])


def test_a_step_that_raises_is_said_with_class_time_and_form() -> None:
    with pytest.raises(IndexError) as caught:
        Mine().step(None, np.zeros(6))
    found = step_failed(Mine(), caught.value, 0.5).diagnostic
    assert found.code == "C601"
    assert found.message.startswith("law `Mine` fails at t = 0.5 s: IndexError")
    assert "test_failing_step.py" in found.message
    assert found.hint.startswith("`step(now, state)`")
    assert found.category is Category.UNFINISHED
