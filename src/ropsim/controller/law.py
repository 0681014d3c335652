"""The joint controller: the law inside the servo slice, as generated source or as a Python object."""

from dataclasses import dataclass, field
from typing import Protocol

from ropsim.codegen import SourceFunction
from ropsim.controller.law_model import LawModel
from ropsim.core import frozen_dataclass
from ropsim.model import InputKind, Payload
from ropsim.spatial import Array, frozen, record


@frozen_dataclass
class LawTraits:
    """Properties that a law declares.

    Attributes:
        u_kind: kind of its output; None for a law that drives each drive with its own kind of input.
        state_names: names of the rows that it remembers.
        hold_row: of them, the row that equals the output at rest on the reference, such as the integral of a
            PI law; a start at rest sets it so that the arm does not sag. None without one.
        aux: names of signals of the cell that it reads at every control tick.
        delay: control ticks between a measurement and the moment when the output made of it acts.
        sensed: names of states of the drives that it reads, such as `pressure_a`, `opening`, `current`,
            `motor_coordinate`: those that `ropsim.dynamics.DriveChain.states` of a drive has.
        sensed_axes: numbers of the axes whose drives must have all of these; None for all axes.
        chain_row: first of the rows in which it remembers the coordinates of closed chains, one behind the
            other; a start sets them. None without.
    """

    u_kind: InputKind | None = None
    state_names: tuple[str, ...] = ()
    hold_row: int | None = None
    aux: tuple[str, ...] = ()
    delay: int = 0
    sensed: tuple[str, ...] = ()
    sensed_axes: tuple[int, ...] | None = None
    chain_row: int | None = None


@record
class CompiledLaw:
    """A joint controller that is compiled into the servo slice.

    `source` is the `def` statement of `law`, called at every control tick with the values at that instant. It
    has those of the following arguments that it needs, in any order, and may use `math`, loops and the shapes
    of these float64 arrays:

    - `par` (p, n): the parameters, one row each;
    - `state` (s, n): state of the law; changed in place;
    - `ref` (3, n): reference coordinates, speeds, accelerations at that instant;
    - `meas` (3, n): coordinates of the joints and speeds measured at that instant, and the torques of the
      drives at the joints; speeds are motor speeds over the gear ratio, which differ from joint speeds with
      elastic gears;
    - `sensed` (r, n): the states of the drives that `traits.sensed` names, in the sense of the motor, 0 where
      a drive does not have one;
    - `drive` (d, n) and `model` (m,): numbers of the arm as the law believes it to be, and functions that
      take them: see `LawModel`;
    - `work` (w, n): room for rows that `work_names` names; what is in it is not kept;
    - `load` (10,): tool and grasped part in the mechanical interface frame: mass m [kg], m·c [kg·m] (3), and
      inertia about the origin of that frame as xx, yy, zz, xy, xz, yz [kg·m²];
    - `aux` (a,): values of the signals that `traits.aux` names;
    - `out` (n,): input of the amplifiers, set by the law, in V for DC motors; positive drives the joint
      forward, for any sign of the gear ratio. The amplifier clips it; keeping an integral sound meanwhile
      (anti-windup) is the task of the law.

    A row may be written by its name: `par[kp, j]`, `state[integral, j]`, `sensed[pressure_a, j]`,
    `work[tau]`; names that loops count keep their values. Seven arguments with other names are par, state,
    ref, meas, load, aux, out.

    The output holds until that of the next tick. Parameters are run-time values: other gains, same code. An
    index beyond an array ends the run with a finding.

    Attributes:
        name: Python identifier.
        source: see above.
        parameter_names: names of the rows of `parameters`, with the symbols that `source` explains.
        parameters: shape (p, n).
        traits: declared properties.
        functions: generated functions that `source` calls.
        model: the arm as the law believes it to be; None for a law that does not ask.
        work_names: names of the rows of `work`.
    """

    name: str
    source: str
    parameter_names: tuple[str, ...]
    parameters: Array
    traits: LawTraits = field(default_factory=LawTraits)
    functions: tuple[SourceFunction, ...] = ()
    model: LawModel | None = None
    work_names: tuple[str, ...] = ()

    def __post_init__(self) -> None:
        object.__setattr__(self, "parameters", frozen(self.parameters))


@dataclass(frozen=True, slots=True, eq=False)
class LawInput:
    """Input of a law in Python at a control tick: reference, measurement and signals of one instant.

    Attributes:
        time: of that instant [s].
        ref: reference coordinates [rad | m], speeds and accelerations, shape (3, n).
        meas: measured coordinates of the joints [rad | m], speeds of the motors over their gear ratios, and
            torques of the drives at the joints [N·m | N], shape (3, n).
        payload: tool and grasped part.
        aux: values of the signals that the traits name, shape (a,).
        sensed: states of the drives that the traits name, in the sense of the motor, shape (r, n).
        model: the arm, as a law may know it.
    """

    time: float
    ref: Array
    meas: Array
    payload: Payload
    aux: Array
    sensed: Array
    model: LawModel


class PythonLaw(Protocol):
    """A joint controller as a Python object, called once per control tick: slower, same plant."""

    @property
    def traits(self) -> LawTraits:
        """Return the declared properties of the law."""
        ...

    def step(self, now: LawInput, state: Array, /) -> Array:
        """Return the input of the amplifiers until the next tick, (n,); positive drives a joint forward.

        Args:
            now: reference, measurement and more.
            state: state of the law, shape (s, n); changed in place, and the only state.
        """
        ...


EXTERNAL_SOURCE = '''\
def law(par, state, ref, meas, load, aux, out):
    """Hold what a controller outside has computed for this tick."""
    for j in range(out.shape[0]):
        out[j] = par[0, j]
'''


def compiled_half(law: CompiledLaw | PythonLaw, zeros: Array) -> CompiledLaw:
    """Return the law itself, or of one in Python the compiled law that holds its output.

    Args:
        law: the law.
        zeros: n zeros.
    """
    if isinstance(law, CompiledLaw):
        return law
    return CompiledLaw("external", EXTERNAL_SOURCE, ("u",), zeros[None, :], law.traits)
