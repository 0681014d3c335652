"""The fixture of all benchmarks."""

from typing import Any

import pytest
from measuring import Measure


@pytest.fixture
def measure(benchmark: Any) -> Measure:
    return Measure(benchmark)
