"""The joint controller: the law inside the servo slice, as generated source or as a Python object."""

from sys import float_info
from typing import Protocol

import numpy as np

from ropsim.controller.law_diagnostics import GAIN_COUNT, GainError
from ropsim.dynamics import command_limit
from ropsim.model import GAIN_NAMES, ControllerKind, ControllerModel, Drive
from ropsim.spatial import Array, frozen, record


@record
class CompiledLaw:
    """A joint controller that is compiled into the servo slice.

    `source` is the `def` statement of `law(par, state, ref, meas, out)`, called once per control tick. It may
    use `math`, loops and the shapes of its arguments, which are float64 arrays:

    - `par` (p, n): the parameters, one row each;
    - `state` (s, n): what the law remembers; it changes it in place;
    - `ref` (3, n): reference coordinates, speeds, accelerations;
    - `meas` (2, n): measured coordinates and speeds;
    - `out` (n,): voltages [V], which it sets; positive drives the joint forward, whatever the sign of the
      gear ratio. The amplifier clips them; keeping an integral sound meanwhile (anti-windup) is its own task.

    The output holds until the next tick. Parameters are run-time values: other gains, same code.

    Attributes:
        name: Python identifier.
        source: see above.
        parameter_names: names of the rows of `parameters`, with the symbols that `source` explains.
        parameters: shape (p, n).
        state_names: names of the rows of the state, s of them.
        hold_row: row of the state that equals the output [V] at rest on the reference, such as the integral
            of a PI law; a start at rest sets it so that the arm does not sag. None without such a row.
    """

    name: str
    source: str
    parameter_names: tuple[str, ...]
    parameters: Array
    state_names: tuple[str, ...] = ()
    hold_row: int | None = None

    def __post_init__(self) -> None:
        object.__setattr__(self, "parameters", frozen(self.parameters))


class PythonLaw(Protocol):
    """A joint controller as a Python object, called once per control tick: slower, same plant."""

    def reset(self, q: Array, /) -> None:
        """Forget everything; the arm stands still at `q` [rad | m], shape (n,)."""
        ...

    def step(self, ref: Array, meas: Array, t: float, /) -> Array:
        """Return the voltages that hold until the next tick [V], shape (n,); positive drives a joint forward.

        Args:
            ref: reference coordinates [rad | m], speeds and accelerations, shape (3, n).
            meas: measured coordinates [rad | m] and speeds, shape (2, n).
            t: time of the tick [s].
        """
        ...


CASCADED_P_PI_SOURCE = '''\
def law(par, state, ref, meas, out):
    """Position loop P, speed loop PI, both with feed-forward; see model.CascadedGains."""
    for j in range(out.shape[0]):
        speed_error = par[0, j] * (ref[0, j] - meas[0, j]) + par[3, j] * ref[1, j] - meas[1, j]
        u = par[1, j] * speed_error + state[0, j] + par[4, j] * ref[1, j] + par[5, j] * ref[2, j]
        limit = par[6, j]
        if u > limit:
            u = limit
        elif u < -limit:
            u = -limit
        else:
            state[0, j] += par[2, j] * speed_error * par[7, j]
        out[j] = u
'''


def cascaded_p_pi(model: ControllerModel, drives: tuple[Drive, ...]) -> CompiledLaw:
    """Return the cascaded P-PI law of a controller; see `model.CascadedGains` for the equations.

    Args:
        model: gains and control period.
        drives: their amplifiers say at which output the integral has to stand still.

    Raises:
        GainError: a gain does not have one number per drive.
    """
    n = len(drives)
    gains: list[Array] = [getattr(model.gains, name) for name in GAIN_NAMES]
    for name, values in zip(GAIN_NAMES, gains, strict=True):
        if values.shape != (n,):
            message = f"gain `{name}` has shape `{values.shape}`; allowed is `({n},)`, one number per joint"
            raise GainError(GAIN_COUNT.at(None, message, hint="give one number per joint"))
    limits = [min(command_limit(drive), float_info.max) for drive in drives]
    period = np.full(n, model.rates.control_period)
    return CompiledLaw(
        name="cascaded_p_pi",
        source=CASCADED_P_PI_SOURCE,
        parameter_names=(*GAIN_NAMES, "limit", "period"),
        parameters=np.stack([*gains, np.array(limits), period]),
        state_names=("integral",),
        hold_row=0,
    )


_LAWS = {ControllerKind.CASCADED_P_PI: cascaded_p_pi}


def law_of(model: ControllerModel, drives: tuple[Drive, ...]) -> CompiledLaw:
    """Return the law that a controller model asks for.

    Raises:
        GainError: the gains do not fit the arm.
    """
    return _LAWS[model.kind](model, drives)


EXTERNAL_SOURCE = '''\
def law(par, state, ref, meas, out):
    """Hold what a controller outside has computed for this tick."""
    for j in range(out.shape[0]):
        out[j] = par[0, j]
'''


def external_law(n: int) -> CompiledLaw:
    """Return the law that puts out its only parameter row `u` [V]: the compiled half of a `PythonLaw`."""
    return CompiledLaw("external", EXTERNAL_SOURCE, ("u",), np.zeros((1, n)))
