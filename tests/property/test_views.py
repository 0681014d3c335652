"""Views bear with any text and any samples."""

import re

import numpy as np
from hypothesis import given, settings
from hypothesis import strategies as st

from ropsim.core import Diagnostic, Severity, SourceText, Span
from ropsim.views import Style, diagnostics_text
from ropsim.views.testing import clean, fit, min_max, nice_ticks, width
from support.examples import examples

TEXT = st.text(alphabet=st.characters(), max_size=200)
PLACES = st.builds(
    Span, st.just("a"), st.integers(1, 9), st.integers(1, 250), st.integers(1, 9), st.integers(1, 250)
)
GUTTER_AND_WORDS = 130
"""Longest quoted line: 100 columns and the gutter, or marks with a label of at most 15 characters."""


@settings(max_examples=examples(200), derandomize=True)
@given(source=TEXT, span=PLACES)
def test_any_place_in_any_text_can_be_shown(source: str, span: Span) -> None:
    finding = Diagnostic("L101", "x", Severity.ERROR, "message", span, "label")
    text = diagnostics_text([finding], {"a": SourceText("a", source)}, Style.PLAIN)
    quoted = text.split("\n\n")[0].split("\n")[2:]
    assert any("^" in line for line in quoted)
    assert all(width(line) <= GUTTER_AND_WORDS for line in quoted)
    assert not re.search("[\x00-\x09\x0b-\x1f\x7f-\x9f]", text)


@settings(max_examples=examples(200), derandomize=True)
@given(text=TEXT, columns=st.integers(1, 40))
def test_fitted_text_fits(text: str, columns: int) -> None:
    fitted = fit(clean(text), columns)
    assert width(fitted) <= columns
    assert fitted == clean(text) or fitted.endswith("…")


@settings(max_examples=examples(100), derandomize=True)
@given(
    values=st.lists(st.floats(-1e6, 1e6) | st.just(float("nan")), min_size=1, max_size=600),
    points=st.integers(4, 60),
)
def test_decimation_keeps_the_extremes(values: list[float], points: int) -> None:
    samples = np.array(values)
    kept = np.concatenate([np.empty(0, dtype=np.intp), *min_max(samples, points)])
    known = samples[np.isfinite(samples)]
    if known.size:
        assert samples[kept].max() == known.max()
        assert samples[kept].min() == known.min()
    else:
        assert kept.size == 0


@settings(max_examples=examples(100), derandomize=True)
@given(low=st.floats(-1e9, 1e9), extent=st.floats(1e-3, 1e9), count=st.integers(2, 12))
def test_ticks_are_few_and_inside(low: float, extent: float, count: int) -> None:
    ticks = nice_ticks(low, low + extent, count)
    room = 1e-6 * max(abs(low), extent)
    assert len(ticks) <= count + 1
    assert all(low - room <= tick <= low + extent + room for tick in ticks)
