"""The page of responses: tables, curves over time and frequency, all texts escaped."""

import re
from dataclasses import replace

import numpy as np
import pytest

from ropsim.views import LoopPage, LoopTable, SineCurves, TimeCurves, response_page
from ropsim.views.testing import frequency_ticks

TIME = np.linspace(0.0, 0.4, 401)
HZ = np.geomspace(0.1, 500.0, 200)
HOSTILE = '<script>alert(1)</script>&"'


def page() -> LoopPage:
    """Return a page of one axis: a step with a first-order answer."""
    times = TimeCurves(
        "2", "°", TIME, np.full(401, 2.0), 2.0 * (1.0 - np.exp(-TIME / 0.05)), "N·m", np.exp(-TIME / 0.05)
    )
    answer = 1.0 / (1.0 + 1j * HZ / 10.0)
    sines = SineCurves("2", HZ, 20.0 * np.log10(np.abs(answer)), np.degrees(np.angle(answer)))
    table = LoopTable("Margins.", ("axis", "gain\nmargin"), (("2", "9"),))
    return LoopPage("Arm", "computed torque at 1000 Hz", (table,), (times,), (sines,), ("A note.",))


def test_the_page_has_its_tables_curves_and_notes() -> None:
    text = response_page(page())
    assert text.count("<svg") == 2
    assert text.count("<desc") == 2
    assert text.count("<polyline") == 5  # reference, coordinate, effort, gain, phase
    for word in ("gain<br>margin", "A note.", "computed torque at 1000 Hz", "axis 2", "N·m", "dB"):
        assert word in text
    assert "<script" not in text


def test_curves_over_frequency_have_equal_steps_for_equal_ratios() -> None:
    text = response_page(page())
    svg = text[text.index('<svg class="frequency"') :]
    ticks = {
        float(value): float(x)
        for x, value in re.findall(r'<text class="middle tick" x="([\d.]+)" y="[\d.]+">([\d.]+)</text>', svg)
    }
    assert ticks[10.0] - ticks[1.0] == pytest.approx(ticks[100.0] - ticks[10.0], abs=0.2)
    assert ticks[2.0] - ticks[1.0] == pytest.approx((ticks[10.0] - ticks[1.0]) * np.log10(2.0), abs=0.2)
    assert 'class="limit"' in svg  # -3 dB


def test_ticks_are_one_two_five_within_the_range() -> None:
    assert frequency_ticks(0.1, 12.0) == pytest.approx((0.1, 0.2, 0.5, 1.0, 2.0, 5.0, 10.0))
    assert frequency_ticks(3.0, 4.0) == ()


def test_names_are_escaped() -> None:
    plain = page()
    (times,), (sines,) = plain.times, plain.sines
    hostile = replace(
        plain,
        title=HOSTILE,
        subtitle=HOSTILE,
        notes=(HOSTILE,),
        tables=(LoopTable(HOSTILE, (HOSTILE,), ((HOSTILE,),)),),
        times=(replace(times, name=HOSTILE),),
        sines=(replace(sines, name=HOSTILE),),
    )
    text = response_page(hostile)
    assert "<script" not in text
    assert text.count("&lt;script&gt;") >= 7


def test_a_page_without_answers_has_no_empty_sections() -> None:
    text = response_page(replace(page(), times=(), sines=(), notes=()))
    assert "In time" not in text
    assert "Sines" not in text
    assert "Conditions" not in text
