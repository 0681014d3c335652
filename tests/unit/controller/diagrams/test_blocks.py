"""Blocks as code: each does what its definition says, against scipy or a recursion written out here."""

import numpy as np
import pytest
from scipy import signal

from ropsim.blockdiagram import (
    AntiWindup,
    DeadBand,
    Delay,
    Diagram,
    Gain,
    Integrator,
    Link,
    Lookup,
    Method,
    MovingFilter,
    Notch,
    Pid,
    Product,
    RateLimiter,
    Role,
    Saturation,
    Signal,
    StateSpace,
    Sum,
    Switch,
    TransferFunction,
    Unit,
)
from ropsim.controller import diagram_law, in_python, law_arrays
from support.diagrams import PERIOD, answers, of_block, outputs, slide

ROUNDING = 1e-12
RNG = np.random.default_rng(7)
NOISE = np.concatenate(([0.0], RNG.uniform(-1.0, 1.0, 60)))
"""It begins at 0, so that filters start at rest."""
R, Y = ("r",), "y"


def test_gain_saturation_dead_band_and_table_are_functions_of_the_present_input() -> None:
    u = np.linspace(-2.0, 2.0, 41)
    assert answers(Gain("g", R, Y, (2.5,)), u) == pytest.approx(2.5 * u)
    assert answers(Saturation("s", R, Y, (-0.5,), (1.0,)), u) == pytest.approx(np.clip(u, -0.5, 1.0))
    band = np.where(u > 0.5, u - 0.5, np.where(u < -1.0, u + 1.0, 0.0))
    assert answers(DeadBand("d", R, Y, (-1.0,), (0.5,)), u) == pytest.approx(band, abs=ROUNDING)
    points, values = (-1.0, 0.0, 0.5, 1.5), (3.0, -1.0, 2.0, 2.5)
    assert answers(Lookup("t", R, Y, points, values), u) == pytest.approx(np.interp(u, points, values))


def test_sum_product_and_switch_take_several_inputs() -> None:
    r, m = NOISE, NOISE[::-1].copy()
    assert answers(Sum("s", ("r", "m"), Y, (1, -1)), r, m) == pytest.approx(r - m)
    assert answers(Product("p", ("r", "m"), Y), r, m) == pytest.approx(r * m)
    chosen = np.where(r >= 0.2, m, r)
    assert answers(Switch("w", ("r", "m", "r"), Y, 0.2), r, m) == pytest.approx(chosen)


@pytest.mark.parametrize("method", list(Method))
def test_transfer_functions_are_those_of_scipy(method: Method) -> None:
    numerator, denominator = (3.0, 40.0), (1.0, 30.0, 900.0)
    b, a = np.array(numerator), np.array(denominator)
    if method is Method.DISCRETE:
        numerator, denominator = (0.2, -0.1), (1.0, -1.2, 0.5)
        b, a = np.array(numerator), np.array(denominator)
    elif method is Method.TUSTIN:
        b, a, _ = signal.cont2discrete((numerator, denominator), PERIOD, "bilinear")
    else:
        b, a, _ = signal.cont2discrete((numerator, denominator), PERIOD, "zoh")
    b, a = np.ravel(b), np.ravel(a)
    expected = signal.lfilter(np.concatenate((np.zeros(len(a) - len(b)), b)), a, NOISE)
    block = TransferFunction("f", R, Y, numerator, denominator, method, PERIOD)
    assert answers(block, NOISE) == pytest.approx(expected, abs=1e-9)


def test_a_state_space_is_that_of_scipy() -> None:
    A, B = np.array([[0.9, 0.1], [-0.2, 0.8]]), np.array([[0.5, 0.1], [1.0, -0.3]])
    C, D = np.array([[1.0, 2.0]]), np.array([[0.3, 0.0]])
    system = signal.dlti(A, B, C, D, dt=PERIOD)
    m = NOISE[::-1].copy()
    _, y, _ = signal.dlsim(system, np.column_stack((NOISE, m)), x0=[0.4, -0.2])
    rows = [tuple(map(tuple, one.tolist())) for one in (A, B, C, D)]
    block = StateSpace("x", ("r", "m"), Y, rows[0], rows[1], rows[2], rows[3], (0.4, -0.2), PERIOD)
    assert answers(block, NOISE, m) == pytest.approx(np.ravel(y), abs=ROUNDING)


def test_an_integrator_adds_up_a_tick_late_from_its_initial_output() -> None:
    block = Integrator("i", R, Y, (3.0,), (0.5,), PERIOD)
    expected = 0.5 + 3.0 * PERIOD * np.concatenate(([0.0], np.cumsum(NOISE)[:-1]))
    assert answers(block, NOISE) == pytest.approx(expected, abs=ROUNDING)


@pytest.mark.parametrize("ticks", [1, 2, 7])
def test_a_delay_and_a_moving_mean_start_as_if_the_first_input_had_been_there_for_ever(ticks: int) -> None:
    u = NOISE + 1.0
    filled = np.concatenate((np.full(ticks, u[0]), u))
    assert answers(Delay("d", R, Y, ticks), u) == pytest.approx(filled[: len(u)])
    means = [filled[k + 1 : k + 1 + ticks].mean() for k in range(len(u))]
    assert answers(MovingFilter("m", R, Y, ticks), u) == pytest.approx(means)


def test_a_rate_limiter_rises_and_falls_no_faster_than_it_may() -> None:
    u = np.array([0.0, 1.0, 1.0, 1.0, -1.0, -1.0, 0.0])
    expected = [0.0, 0.4, 0.8, 1.0, 0.7, 0.4, 0.1]
    block = RateLimiter("l", R, Y, (-300.0,), (400.0,), PERIOD)
    assert answers(block, u) == pytest.approx(expected)


def test_filters_start_in_the_steady_state_of_their_first_input() -> None:
    constant = np.full(50, 0.7)
    for block, gain in (
        (TransferFunction("f", R, Y, (2.0,), (0.1, 1.0), Method.TUSTIN, PERIOD), 2.0),
        (TransferFunction("f", R, Y, (2.0,), (0.1, 1.0), Method.ZERO_ORDER_HOLD, PERIOD), 2.0),
        (Notch("n", R, Y, 300.0, 0.5, 0.1, PERIOD), 1.0),
        (StateSpace("x", R, Y, ((0.5,),), ((1.0,),), ((1.0,),), ((0.0,),), (), PERIOD), 2.0),
        (RateLimiter("l", R, Y, (-1.0,), (1.0,), PERIOD), 1.0),
    ):
        assert answers(block, constant) == pytest.approx(gain * constant, rel=1e-9)


def test_a_notch_takes_out_its_frequency_and_leaves_slow_signals() -> None:
    w, depth = 300.0, 0.05
    time = PERIOD * np.arange(4000)
    for frequency, gain in ((w, depth), (0.05 * w, 1.0)):
        y = answers(Notch("n", R, Y, w, 0.5, depth, PERIOD), np.sin(frequency * time))
        assert np.abs(y[2000:]).max() == pytest.approx(gain, rel=0.02)


def pid(anti_windup: AntiWindup, limits: tuple[float, ...] = (1.5,)) -> Pid:
    lower = tuple(-one for one in limits)
    tracking = (0.02,) if anti_windup is AntiWindup.BACK_CALCULATION else ()
    return Pid(
        *("c", ("r", "m"), Y, (2.0,), (400.0,), (0.002,), (0.005,), (0.6,), (0.3,)),
        *(lower, limits, anti_windup, tracking, PERIOD),
    )


@pytest.mark.parametrize("anti_windup", list(AntiWindup))
def test_a_pid_block_is_its_equations(anti_windup: AntiWindup) -> None:
    r, m = NOISE + 0.3, NOISE[::-1].copy()
    block = pid(anti_windup)
    integral = derivative = 0.0
    before, expected = 0.3 * r[0] - m[0], []
    for k in range(len(r)):
        v = 0.3 * r[k] - m[k]
        derivative = (0.005 * derivative + 0.002 * (v - before)) / (0.005 + PERIOD)
        before, e = v, r[k] - m[k]
        asked = 2.0 * (0.6 * r[k] - m[k]) + integral + derivative
        y = min(max(asked, -1.5), 1.5)
        expected.append(y)
        driving = (asked > 1.5 and e > 0.0) or (asked < -1.5 and e < 0.0)
        if anti_windup is not AntiWindup.CLAMPING or not driving:
            integral += 400.0 * PERIOD * e
        if anti_windup is AntiWindup.BACK_CALCULATION:
            integral += PERIOD / 0.02 * (y - asked)
    assert np.abs(expected).max() == 1.5
    assert answers(block, r, m) == pytest.approx(expected, abs=ROUNDING)


def test_the_integral_that_holds_the_arm_makes_the_first_output_that_of_the_start() -> None:
    signals = (
        Signal("r", 1, (Unit.METRE,), Role.REFERENCE_COORDINATE),
        Signal("m", 1, (Unit.METRE,), Role.COORDINATE),
        Signal("v", 1, (Unit.OTHER,)),
        Signal("w", 1, (Unit.OTHER,)),
        Signal("y", 1, (Unit.OTHER,), Role.OUTPUT),
    )
    loop = Pid(
        *("loop", ("r", "m"), "v", (2.0,), (30.0,), (0.0,), (0.0,), (1.0,), (1.0,)),
        *((), (), AntiWindup.NONE, (), PERIOD),
    )
    blocks = (loop, Delay("late", ("v",), "w", 3), Gain("sense", ("w",), "y", (-4.0,)))
    law = diagram_law(Diagram("held", PERIOD, signals, blocks, holding="loop"), slide())
    assert law.traits.hold_row == 1
    function, arrays = in_python(law), law_arrays(law, 1)
    arrays["ref"][0, 0] = arrays["meas"][0, 0] = 0.4
    arrays["state"][1, 0] = 7.5
    made = []
    for _ in range(20):
        function(arrays)
        made.append(arrays["out"][0])
    assert made == pytest.approx([7.5] * 20)


def test_other_numbers_have_the_same_code() -> None:
    def law(kp: float, ki: float) -> str:
        block = Pid(
            *("c", ("r", "m"), Y, (kp,), (ki,), (0.0,), (0.0,), (1.0,), (1.0,)),
            *((), (), AntiWindup.NONE, (), PERIOD),
        )
        return diagram_law(of_block(block), slide()).source

    assert law(1.0, 1.0) == law(2.0, 3.0)


def test_links_take_elements_of_one_signal_to_another() -> None:
    signals = (
        Signal("r", 1, (Unit.METRE,), Role.REFERENCE_COORDINATE),
        Signal("m", 1, (Unit.METRE,), Role.COORDINATE),
        Signal("both", 2, (Unit.METRE,)),
        Signal("turned", 2, (Unit.METRE,)),
        Signal("y", 1, (Unit.METRE,), Role.OUTPUT),
    )
    links = (Link("r", 0, "both", 1, 1), Link("m", 0, "both", 0, 1), Link("turned", 1, "y", 0, 1))
    block = Gain("g", ("both",), "turned", (10.0, 100.0))
    law = diagram_law(Diagram("linked", PERIOD, signals, (block,), links=links), slide())
    assert outputs(law, [1.0, 2.0], [5.0, 6.0]) == pytest.approx([100.0, 200.0])
