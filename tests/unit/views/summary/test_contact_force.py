"""The greatest force of a contact: with its time and line, in summary, terminal, report and result."""

import numpy as np
import pytest

from ropsim.flow import Recording
from ropsim.simulation import Fidelity, RunOptions, run
from ropsim.views import Style, html_report, result_figures, summarize, terminal_report
from support.compiled import code_of
from support.pressed import contact, pressed_cell


def pressed(low: float) -> Recording:
    """Return a run whose third line ends at a height [mm]; the block is touched below 10 mm."""
    cell = pressed_cell(contact(1e5))
    lines = ("mov joints(0, 15)", f"mov joints(0, {low})", "wait 0.2 s", "mov joints(0, 30)")
    return run(cell, {"robot": code_of(cell, *lines)}, RunOptions(Fidelity.KINEMATIC))


def test_the_greatest_contact_force_has_its_time_and_line() -> None:
    recording = pressed(9.0)
    force = np.linalg.norm(recording.rows("contact_wrench")[:, :3], axis=1)
    row = int(np.argmax(force))
    summary = summarize(recording)
    (peak,) = (one.contact for one in summary.stations if one.contact)
    assert (peak.value, peak.time) == (force[row], recording.time[row])
    assert peak.value == pytest.approx(100.0, rel=0.01)
    assert peak.line == int(recording.at("line", float(recording.time[row]))) > 0
    result = result_figures(summary).contact_force
    assert result is not None
    assert (result.max, result.station, result.line, result.time) == (
        peak.value,
        "robot",
        peak.line,
        peak.time,
    )
    assert f"contact      at most {peak.value:.3g} N at {peak.time:.2f} s" in terminal_report(
        summary, Style.PLAIN
    )
    page = html_report(recording, summary, {})
    assert "contact force, max" in page
    assert "contact force" in page.partition("Gripper, payload and signals")[2]


def test_without_a_touch_nothing_is_said() -> None:
    recording = pressed(12.0)
    summary = summarize(recording)
    assert summary.stations[0].contact is None
    assert result_figures(summary).contact_force is None
    assert "contact  " not in terminal_report(summary, Style.PLAIN)
