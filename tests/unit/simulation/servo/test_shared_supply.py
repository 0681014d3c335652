"""Axes at one supply of oil with an accumulator: gas law, an independent integration, energy, findings."""

from dataclasses import replace
from math import exp, sqrt
from pathlib import Path

import numpy as np
import pytest
from scipy.integrate import solve_ivp

import ropsim
from ropsim.codegen import Engine, Tracer, emit, load
from ropsim.core import SourceText
from ropsim.dynamics import arm_numbers, drive_fault, shared_supply_fault, structure_of
from ropsim.dynamics.drives import supply_numbers, trace_supply
from ropsim.model import ATMOSPHERE, Hydraulic, HydraulicSupply, Payload, Rates, RobotModel
from ropsim.nirox import read_nirox, write_nirox
from ropsim.robotfile import read_robot_file, write_robot_file
from ropsim.robots import default_controller
from ropsim.simulation import Servo
from ropsim.simulation.testing import drive_powers, fastest_pole, plant_code
from ropsim.spatial import Array
from support.hydraulic_arm import hydraulic_arm, square
from support.two_link_hydraulic import TASK, two_link_project

PUMP = HydraulicSupply("pump", 4e-3, 90e5, 1.2e-4, 2e-3, 160e5)
"""4 l of gas at 90 bar, 7.2 l/min, 2 l of oil in the line, relief at 160 bar."""
FULL = 140e5


def supplied(supply: HydraulicSupply = PUMP, axes: tuple[int, ...] = (0, 1)) -> RobotModel:
    """Return the two-link arm with some axes at one supply."""
    robot = hydraulic_arm()
    drives = [replace(one, supply=supply) if k in axes else one for k, one in enumerate(robot.drives)]
    return replace(robot, drives=tuple(drives))


def rate_of(robot: RobotModel, pressure: float, taken: float) -> float:
    """Return the rate of the pressure of a supply [Pa/s]."""
    tracer = Tracer()
    p, q = tracer.variables("x", 2)
    rate = trace_supply([tracer.constant(one) for one in supply_numbers(robot.drives)], p, [q])
    code = load("supply", (emit("supply", ("x", "out"), [("out[0]", rate)]),), Engine.PYTHON)
    out = [0.0]
    code([pressure, taken], out)
    return out[0]


def own_rate(supply: HydraulicSupply, full: float, bulk: float, p: float, taken: float) -> float:
    """Return the same, written down anew."""
    given = supply.pump_flow * min(max((full - p) / supply.pump_band, 0.0), 1.0)
    relieved = supply.pump_flow * max(p / supply.relief_pressure - 1.0, 0.0) / 0.1
    gas = 0.0
    if p > supply.precharge:
        ratio = (supply.precharge + ATMOSPHERE) / (p + ATMOSPHERE)
        gas = supply.gas_volume * ratio ** (1.0 / supply.exponent) / (supply.exponent * (p + ATMOSPHERE))
        gas *= min((p - supply.precharge) / 1e5, 1.0)
    return (given - relieved - taken) / (supply.line_volume / bulk + gas)


def gas_at(supply: HydraulicSupply, pressure: float) -> float:
    """Return the volume of the gas at a pressure of the oil above the precharge [m³]."""
    share = (supply.precharge + ATMOSPHERE) / (pressure + ATMOSPHERE)
    return float(supply.gas_volume * share ** (1.0 / supply.exponent))


@pytest.mark.parametrize("exponent", [1.0, 1.25, 1.4])
def test_a_steady_flow_lets_the_gas_grow_by_its_polytropic_law(exponent: float) -> None:
    """(p + p_air)·V^n stays, V grows by what flows out, where neither pump nor line give way."""
    supply = replace(PUMP, pump_flow=1e-15, line_volume=1e-12, exponent=exponent)
    robot, flow, begin = supplied(supply), 2e-4, 139e5
    found = solve_ivp(lambda _, p: [rate_of(robot, float(p[0]), flow)], (0.0, 2.0), [begin], rtol=1e-10)
    volume = gas_at(supply, begin)
    grown = volume + flow * 2.0
    expected = (begin + ATMOSPHERE) * (volume / grown) ** exponent - ATMOSPHERE
    assert expected > supply.precharge + 1e5
    assert found.y[0, -1] == pytest.approx(expected, rel=1e-7)
    assert gas_at(supply, expected) == pytest.approx(grown, rel=1e-12)


def test_the_pump_fills_the_line_as_a_first_order_lag_within_its_band() -> None:
    """Of an empty accumulator: V_l/β·p' = Q_p·(p_s - p)/Δp."""
    supply = replace(PUMP, precharge=139.9e5, gas_volume=1e-15)
    robot = supplied(supply)
    motor = robot.drives[0].motor
    assert isinstance(motor, Hydraulic)
    lag = supply.line_volume / motor.bulk_modulus * supply.pump_band / supply.pump_flow
    begin = FULL - 0.9 * supply.pump_band
    found = solve_ivp(lambda _, p: [rate_of(robot, float(p[0]), 0.0)], (0.0, lag), [begin], rtol=1e-10)
    assert found.y[0, -1] == pytest.approx(FULL - 0.9 * supply.pump_band * exp(-1.0), rel=1e-9)
    assert fastest_pole(robot) >= 1.0 / lag


@pytest.mark.parametrize("pressure", [1e5, 80e5, 90.5e5, 120e5, 139.8e5, 141e5, 165e5])
def test_the_rate_is_that_of_the_equation(pressure: float) -> None:
    for taken in (-1e-4, 0.0, 3e-4):
        expected = own_rate(PUMP, FULL, 1.2e9, pressure, taken)
        assert rate_of(supplied(), pressure, taken) == pytest.approx(expected, rel=1e-9, abs=1e-3)


def flows(robot: RobotModel, x: Array, pressure: float) -> float:
    """Return what both valves take [m³/s], by the formula of an edge: no overlap and no null flow."""
    taken = 0.0
    for axis, drive in enumerate(robot.drives):
        motor = drive.motor
        assert isinstance(motor, Hydraulic)
        a, b, opening = x[4 + axis], x[6 + axis], x[8 + axis]
        fall = pressure - (a if opening > 0.0 else b)
        edge = motor.rated_flow * sqrt(2.0 / motor.rated_pressure_drop)
        taken += edge * abs(opening) * fall / (fall**2 + 1e10) ** 0.25
    return taken


def test_the_whole_arm_follows_an_independent_integration() -> None:
    """Drives as at constant supplies, whose pressure is told anew each time; the gas is written anew."""
    robot, constant = supplied(), hydraulic_arm()
    functions = plant_code(structure_of(constant))
    (source,) = (one for one in functions.functions if one.name == "derivative")
    derivative = load("derivative", (source,), Engine.PYTHON)
    servo = Servo.build(robot, default_controller(robot, Rates(1000)))
    start = servo.initial_state(robot.home)
    places, u = servo.layout, np.array([0.03, -0.02])

    def at(pressure: float) -> Array:
        drives = [
            replace(one, motor=replace(one.motor, supply_pressure=pressure))
            for one in constant.drives
            if isinstance(one.motor, Hydraulic)
        ]
        return functions.constants(arm_numbers(replace(constant, drives=tuple(drives))))

    def rates(_: float, y: Array) -> Array:
        x, dx = y[:-1].copy(), np.empty(len(y) - 1)
        derivative(x, u, at(float(y[-1])), dx)
        return np.append(dx, own_rate(PUMP, FULL, 1.2e9, float(y[-1]), flows(robot, x, float(y[-1]))))

    whole = plant_code(structure_of(robot))
    (source,) = (one for one in whole.functions if one.name == "derivative")
    ours, numbers = load("ours", (source,), Engine.PYTHON), whole.constants(arm_numbers(robot))
    begin = start.values[: places.integrated]
    assert begin[places.supplies] == FULL

    def own(_: float, y: Array) -> Array:
        dx = np.empty(len(y))
        ours(y.copy(), u, numbers, dx)
        return dx

    options = {"rtol": 1e-9, "atol": 1e-9, "method": "LSODA"}
    found, expected = (solve_ivp(one, (0.0, 0.3), begin, **options) for one in (own, rates))
    assert expected.y[-1, -1] < 0.98 * FULL
    np.testing.assert_allclose(found.y[:, -1], expected.y[:, -1], rtol=2e-6, atol=1e-7)


def drawn(robot: RobotModel) -> dict[str, Array]:
    """Return the log of a square, with the power of the drives, at every tick."""
    model, wanted = default_controller(robot, Rates(1000)), square("far low")
    servo = Servo.build(robot, model)
    start = servo.initial_state(wanted.reference.q[0])
    recorder = servo.recorder(start)
    servo.run(start, wanted.reference, Payload(10.0), recorder)
    log = recorder.channels()
    return {**log, **drive_powers(robot, log)}


def test_a_supply_falls_further_when_more_axes_move_from_it() -> None:
    both, one = drawn(supplied()), drawn(supplied(axes=(1,)))
    assert both["supply_pressure"].shape[1] == 2
    assert one["supply_pressure"].shape[1] == 1
    np.testing.assert_array_equal(both["supply_pressure"][:, 0], both["supply_pressure"][:, 1])
    fallen = [FULL - log["supply_pressure"].min() for log in (both, one)]
    assert fallen[0] > 1.5 * fallen[1] > 1e5


def test_energy_of_drives_is_work_of_pump_and_gas() -> None:
    """∫ΣP = ∫p·Q_pump - ∫C(p)·p·dp; drives take it at the pressure that the supply has."""
    robot, log = supplied(), drawn(supplied())
    pressure = log["supply_pressure"][:, 0]
    given = PUMP.pump_flow * np.clip((FULL - pressure) / PUMP.pump_band, 0.0, 1.0)
    fine = np.linspace(pressure[0], pressure[-1], 20_001)
    ratio = (PUMP.precharge + ATMOSPHERE) / (fine + ATMOSPHERE)
    volume = PUMP.gas_volume * ratio ** (1.0 / PUMP.exponent)
    capacity = PUMP.line_volume / 1.2e9 + volume / (PUMP.exponent * (fine + ATMOSPHERE))
    stored = np.trapezoid(capacity * fine, fine)
    taken = np.trapezoid(log["power"].sum(axis=1), dx=1e-3)
    assert pressure.min() > PUMP.precharge + 1e5
    assert taken == pytest.approx(np.trapezoid(pressure * given, dx=1e-3) - stored, rel=2e-4)
    assert len(robot.drives) == 2


def test_a_supply_that_is_not_used_up_moves_the_arm_as_a_constant_one() -> None:
    """With much gas and a strong pump; the standard controller holds what is left."""
    strong = replace(PUMP, gas_volume=4.0, pump_flow=5e-3)
    apart = np.abs(drawn(supplied(strong))["q"] - drawn(hydraulic_arm())["q"]).max()
    assert 0.0 < apart < 2e-4


_NUMBERS = tuple(HydraulicSupply.__dataclass_fields__)[1:]


@pytest.mark.parametrize(
    ("change", "name"),
    [
        ({"precharge": 150e5}, "`precharge`"),
        ({"relief_pressure": 139e5}, "`relief_pressure`"),
        ({"exponent": 0.9}, "`exponent`"),
        ({"gas_volume": 0.0}, "`gas_volume`"),
        ({"pump_band": 2e7}, "`pump_band`"),
    ],
)
def test_impossible_supplies_are_faults(change: dict[str, float], name: str) -> None:
    (key,) = change
    supply = HydraulicSupply("pump", *(change.get(one, float(getattr(PUMP, one))) for one in _NUMBERS))
    assert key in _NUMBERS
    fault = drive_fault(supplied(supply).drives[0])
    assert fault is not None
    assert fault[0] == name
    assert drive_fault(supplied().drives[0]) is None


def test_drives_at_one_supply_have_its_pressure() -> None:
    first, second = supplied().drives
    assert isinstance(second.motor, Hydraulic)
    other = replace(second, motor=replace(second.motor, supply_pressure=130e5))
    assert shared_supply_fault((first, second)) is None
    fault = shared_supply_fault((first, other))
    assert fault is not None
    assert (fault[0], fault[1][0]) == (1, "`supply_pressure`")
    named = replace(second, supply=replace(PUMP, gas_volume=1e-3))
    assert shared_supply_fault((first, named)) is not None


def test_files_keep_a_shared_supply() -> None:
    robot = supplied()
    text = write_robot_file(robot).text
    assert text.count("[[supplies]]") == 1
    again = read_robot_file(SourceText("robots/arm.toml", text))
    assert again.robot is not None, again.findings
    assert [one.supply for one in again.robot.drives] == [PUMP, PUMP]
    neutral = write_nirox(robot)
    assert neutral.text.count("HYDRAULIC_SUPPLY") == neutral.text.count("HYDRAULIC_ACCUMULATOR") == 1
    read = read_nirox(SourceText("arm.stp", neutral.text))
    assert read.robot is not None, read.findings
    assert [one.supply for one in read.robot.drives] == [PUMP, PUMP]


def test_a_file_with_an_impossible_supply_is_refused_where_it_stands() -> None:
    text = write_robot_file(supplied()).text
    line = next(one for one in text.splitlines() if one.startswith("precharge"))
    read = read_robot_file(SourceText("robots/arm.toml", text.replace(line, "precharge = 2e7")))
    assert read.robot is None
    (found,) = read.findings
    assert "`precharge` of the supply `pump`" in found.message
    other = text.replace('supply = "pump"', 'supply = "pimp"')
    missing = read_robot_file(SourceText("robots/arm.toml", other))
    assert missing.robot is None
    assert "did you mean `pump`?" in missing.findings[0].hint


def test_a_run_that_uses_up_an_accumulator_says_so(tmp_path: Path) -> None:
    """S755 once for the supply, on the line where it was worst; the recording has its pressure."""
    folder = two_link_project(tmp_path / "links", "main.task", TASK)
    file = folder / "robots" / "links.toml"
    supply = (
        '[[supplies]]\nname = "small"\ngas_volume = 2e-4\nprecharge = 12e6\npump_flow = 2e-5\n'
        "line_volume = 2e-3\nrelief_pressure = 16e6\n"
    )
    text = file.read_text("utf-8").replace('kind = "cylinder"', 'kind = "cylinder"\nsupply = "small"')
    file.write_text(text + supply, "utf-8")
    recording = ropsim.open(folder).simulate()
    (found,) = [one for one in recording.findings if one.code == "S755"]
    assert found.span is not None
    assert "supply `small` of 2 joints `shoulder`, `elbow`" in found.message
    worst, lowest = found.data["value"], recording.channels["supply_pressure"].values.min()
    assert isinstance(worst, float)
    assert found.data["limit"] == 12e6
    assert worst <= lowest < 12e6
