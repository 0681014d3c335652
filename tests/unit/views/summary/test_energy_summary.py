"""Energy of the drives in all and by line, and how far each of them is used."""

from dataclasses import replace
from math import inf, isnan, nan, sqrt

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from ropsim.flow import Channel, Fidelity, Recording
from ropsim.model import ThermalDcMotor
from ropsim.spatial import Array
from ropsim.views import Alternative, Comparison, Style, comparison_text, summarize, terminal_report
from ropsim.views.testing import both_energies, comparison_section, drive_section, energy_section
from ropsim.views.words.figures import digits, energy, power
from support.recordings import facts, pick_and_place, station


def recording(powers: list[list[float]], lines: list[float], **channels: list[list[float]]) -> Recording:
    """A run of two joints at 1 Hz; the lines are those of the intervals, the first one of the first row."""
    table = {name: Channel(np.array(rows), "") for name, rows in {"power": powers, **channels}.items()}
    table["line"] = Channel(np.array([0.0, *lines]), "")
    axes = tuple(replace(one, max_current=8.0, lasting_current=2.5) for one in station().axes[:2])
    time = np.arange(len(powers), dtype=np.float64)
    return Recording(time, table, (), (), float(time[-1]), facts(stations=(station(axes=axes),)))


def test_what_one_drive_gives_back_another_one_draws() -> None:
    """Only the sum counts: 5, 5, -2, -2 W, a second each."""
    found = (
        summarize(recording([[10.0, -5.0], [10.0, -5.0], [1.0, -3.0], [1.0, -3.0]], [4, 4, 6]))
        .stations[0]
        .energy
    )
    assert found
    between = 0.5 * 25.0 / 7.0, 0.5 * 4.0 / 7.0  # both sides of the change of sign
    assert found.drawn == pytest.approx(5.0 + between[0])
    assert found.given_back == pytest.approx(between[1] + 2.0)
    assert found.net == pytest.approx(5.0 + 1.5 - 2.0)
    assert found.mean == pytest.approx(4.5 / 3.0)
    assert (found.peak.value, found.least.value, found.least.time) == (5.0, -2.0, 2.0)


def test_lines_sum_to_the_whole_and_the_first_one_draws_most() -> None:
    found = (
        summarize(recording([[1.0, 0.0], [2.0, 1.0], [8.0, 0.0], [0.0, 0.0], [-1.0, 0.0]], [7, 9, 9, 7]))
        .stations[0]
        .energy
    )
    assert found
    assert [one.line for one in found.lines] == [9, 7]
    assert sum(one.drawn for one in found.lines) == pytest.approx(found.drawn)
    assert sum(one.given_back for one in found.lines) == pytest.approx(found.given_back)
    assert sum(found.share(one) for one in found.lines) == pytest.approx(1.0)
    first, second = found.lines
    assert (first.drawn, first.time, first.peak) == pytest.approx((5.5 + 4.0, 2.0, 8.0))
    assert (second.drawn, second.given_back) == pytest.approx((2.0, 0.5))


def test_passes_of_a_line_are_those_of_its_instructions() -> None:
    run = pick_and_place(3)
    watts = Channel(np.ones((len(run.time), 6)), "W", tuple(str(k + 1) for k in range(6)))
    found = summarize(replace(run, channels={**run.channels, "power": watts})).stations[0]
    assert found.energy
    assert found.energy.drawn == pytest.approx(6.0 * (run.time[-1] - run.time[0]))
    times = {one.line: one.passes for one in found.cycle.lines}
    moved = [one for one in found.energy.lines if one.line]
    assert moved
    assert all(one.passes == times[one.line] == 3 for one in moved)


def test_both_energies_are_those_of_a_fine_sum() -> None:
    rng = np.random.default_rng(3)
    coarse, time = rng.normal(size=40), np.cumsum(rng.uniform(0.1, 1.0, 40))
    fine = np.linspace(time[0], time[-1], 400_001)
    values = np.interp(fine, time, coarse)
    drawn, given = both_energies(coarse, time)
    assert drawn.sum() == pytest.approx(np.trapezoid(np.maximum(values, 0.0), fine), rel=1e-6)
    assert given.sum() == pytest.approx(np.trapezoid(np.maximum(-values, 0.0), fine), rel=1e-6)
    assert drawn.sum() - given.sum() == pytest.approx(np.trapezoid(coarse, time))


def test_a_run_without_power_has_no_energy() -> None:
    run = recording([[1.0, 1.0], [1.0, 1.0]], [3])
    channels = {name: one for name, one in run.channels.items() if name != "power"}
    found = summarize(replace(run, channels=channels))
    assert found.stations[0].energy is None
    assert isnan(found.drawn)


def test_a_kinematic_run_has_no_figure_and_says_so() -> None:
    run = pick_and_place(1)
    channels = {name: one for name, one in run.channels.items() if name not in ("tau", "current")}
    kinematic = replace(run, channels=channels, facts=replace(run.facts, fidelity=Fidelity.KINEMATIC))
    summary = summarize(kinematic)
    assert summary.stations[0].energy is None
    assert summary.stations[0].drives == ()
    assert "energy       –, without drives" in terminal_report(summary, Style.PLAIN)
    assert isnan(summary.drawn)


def test_the_use_of_a_drive_is_told_against_the_limits_that_its_model_has() -> None:
    current = [[3.0, 0.0], [-4.0, 0.0], [0.0, 0.0], [0.0, 0.0]]
    ones = [[1.0, nan]] * 4
    run = recording([[36.0, 0.0]] * 4, [3, 3, 3], current=current, tau=current, winding_rise=ones)
    first, second = summarize(run).stations[0].drives
    assert first.current_rms == first.effort_rms == 2.5
    assert (first.current_share, first.lasting_current_share) == (0.5, 1.0)
    assert first.effort.size == 4.0
    assert first.drawn == 36.0 * 3.0
    assert (first.rise.size, isnan(first.rise_share)) == (1.0, True)  # its model has no limit
    assert second.current_rms == 0.0
    assert isnan(second.rise.size)


def test_tables_leave_out_what_no_drive_has() -> None:
    run = recording([[3600.0, 0.0]] * 2, [3], tau=[[4.0, 0.0]] * 2, current=[[1.0, 0.0]] * 2)
    summary = summarize(run)
    text = terminal_report(summary, Style.PLAIN)
    assert "1.00 Wh drawn; 3.60 kW on average" in text
    assert "at most 3.60 kW" in text
    assert "most: line 3 100 %" in text
    assert "lasting" in text
    assert "winding" not in text
    (station_found,) = summary.stations
    page = drive_section(station_found.drives, "")
    assert "lasting" in page
    assert "winding" not in page
    assert "1.00 Wh drawn" in energy_section(station_found.energy, None, "").replace("\u00a0", " ")


def test_a_table_of_many_columns_stays_within_the_terminal() -> None:
    rows = [[1.0, 1.0]] * 4
    run = recording([[36.0, 0.0]] * 4, [3, 3, 3], current=rows, tau=rows, winding_rise=rows)
    (arm,) = run.facts.stations
    axes = tuple(replace(one, name=f"joint {one.name} of this long arm", max_rise=2.0) for one in arm.axes)
    text = terminal_report(
        summarize(replace(run, facts=facts(stations=(replace(arm, axes=axes),)))), Style.PLAIN
    )
    assert "winding" in text
    assert max(map(len, text.splitlines())) <= 80


def test_the_lasting_current_warms_a_winding_to_its_greatest_rise() -> None:
    """Both equations of the model, until they stand."""
    motor = ThermalDcMotor(0.2, 0.2, 1.5, 1e-3, 2e-4, 0.6, 1.4, 18.0, 900.0)
    current = motor.lasting_current(90.0)

    def slope(_: float, rises: Array) -> Array:
        winding, housing = rises
        loss = 1.5 * (1.0 + motor.resistance_drift * winding) * current**2
        passing = winding - housing
        return np.array([(0.6 * loss - passing) / 18.0, (passing * 1.4 / 0.6 - housing) / 900.0])

    end = solve_ivp(slope, (0.0, 1e5), [0.0, 0.0], method="LSODA", rtol=1e-9, atol=1e-9).y[:, -1]
    assert end[0] == pytest.approx(90.0, rel=1e-6)
    assert motor.lasting_current(inf) == inf
    cold = replace(motor, resistance_drift=0.0)
    assert cold.lasting_current(90.0) == pytest.approx(sqrt(90.0 / (2.0 * 1.5)))


@pytest.mark.parametrize(
    ("joules", "text"),
    [
        (3600.0, "1.00 Wh"),
        (5.4e6, "1.50 kWh"),
        (36.0, "0.0100 Wh"),
        (0.0, "0 Wh"),
        (1e-3, "0 Wh"),
        (nan, "–"),
    ],
)
def test_energies_are_written_in_watt_hours(joules: float, text: str) -> None:
    assert energy(joules).replace("\u00a0", " ") == text


@pytest.mark.parametrize(("watts", "text"), [(12.34, "12.3 W"), (-1500.0, "-1.50 kW"), (99960.0, "100 kW")])
def test_powers_are_written_in_watts_and_kilowatts(watts: float, text: str) -> None:
    assert power(watts).replace("\u00a0", " ") == text


def test_numbers_have_three_digits() -> None:
    assert [digits(one) for one in (12345.0, 0.5, -0.012345, 1e-9)] == [
        "12300",
        "0.500",
        "-0.0123",
        "0",
    ]


def test_what_if_says_how_much_more_energy_is_drawn() -> None:
    changed = Alternative("speed=50%", 4.0, True, (), 150.0)
    unknown = Alternative("broken", 4.0, False, (), 150.0)
    compared = Comparison(2.0, (changed, unknown), (), 100.0)
    assert compared.energy_difference(changed) == 50.0
    assert isnan(compared.energy_difference(unknown))
    lines = comparison_text(compared, Style.PLAIN).splitlines()
    assert "energy %" in lines[0]
    assert "+50.0" in lines[2]
    assert "+50.0" in comparison_section(compared)
    without = Comparison(2.0, (replace(changed, energy=nan),))
    assert "energy" not in comparison_text(without, Style.PLAIN)
    assert "energy" not in comparison_section(without)


def test_a_motor_without_losses_is_said_and_one_with_a_winding_is_not() -> None:
    """Of drives that record no current and no pressure only the mechanical power is known."""
    rows = [[1.0, 2.0]] * 3
    found = summarize(recording(rows, [4, 4])).stations[0].energy
    assert found
    assert (found.lossless, found.bound) == (
        ("1", "2"),
        "mechanical power only, without losses of the motors",
    )
    one = summarize(recording(rows, [4, 4], current=[[0.5, nan]] * 3)).stations[0].energy
    assert one
    assert (one.lossless, one.bound) == (("2",), "of joint 2 mechanical power only")
    both = summarize(recording(rows, [4, 4], current=[[0.5, 0.5]] * 3)).stations[0].energy
    assert both
    assert (both.lossless, both.bound) == ((), "")


def test_next_to_nothing_has_no_shares() -> None:
    run = recording([[1e-4, 0.0]] * 3, [4, 4])
    found = summarize(run).stations[0].energy
    assert found
    assert isnan(found.share(found.lines[0]))
    text = terminal_report(summarize(run), Style.PLAIN)
    assert "most: " not in text
    assert "0.00000" not in text
