"""Errors of a servo simulation."""

from ropsim.core import Category, RopsimError, Severity, define

NO_DRIVES = define(
    "S700",
    "model-without-drives",
    Severity.ERROR,
    "the arm has no drive data, so its servo loop cannot be simulated",
    """
The servo simulation computes motor currents from voltages and joint torques from currents. It needs motor,
gear, friction and amplifier of every joint; the model of this arm has none.

Run without dynamics (`ropsim run PATH --kinematic`), take an arm with drive data such as `puma560`, or give
the missing data in the model; where nothing is published, give an estimate and mark it `estimated`.
""",
)

STIFF_CONTACT = define(
    "S775",
    "contact-too-stiff",
    Severity.WARNING,
    "a meant contact is too stiff for the control rate",
    """
The force of a contact is held over a control tick T, as the output of the joint controller is. It is that of
the pose half a tick ahead, so that stiffness k and damping c act on a mass m as a damper of c + k·T/2. Such a
held damper brings the mass to rest while c + k·T/2 < 2·m/T, and throws it back harder than it came beyond.

Stiffness and damping are those of a pair of convex shapes, and a tool or what it is pressed on may consist of
several: the condition is n·(c + k·T/2) < 2·m/T for n pairs at once. Counted are all shapes of the tool, each
with all shapes that it can touch at once as they stand at the start, and 1.4 for a shape that a face can
cover as a whole. This is an upper bound: where fewer touch, the warning may come too early. Draw what is
pressed as one shape, or divide `stiffness` and `damping` by the number that carries.

The mass is what the tool centre point resists to a force in its lightest direction, with rotors and gears, at
the start and in the rest position. Lower `stiffness` or `damping` of the contact, or raise `control_hz`.
""",
)

DIVERGED = define(
    "S701",
    "state-not-finite",
    Severity.ERROR,
    "the simulated state has become NaN or grows beyond all bounds",
    """
The run ends there. The recording has all until the last tick at which each number was finite and below 1e12
in SI units; its time is no cycle time, and limits of the station are not judged.

Either reference, payload or gains hold NaN, or the integration step is too long for the fastest motion of the
plant: a fixed-step Runge-Kutta integration is stable while step times fastest eigenvalue stays below about
2.8. Very light links without motor inertia, very small inductances and very high gains make fast plants.

The message names the first control tick at whose end a number was not so, and of these numbers
the one from which the others follow: what the joint controller put out, what it remembers,
the reference, the drive, the arm.

Where friction d stops an inertia J within a fraction of an integration step dt, the message names the axis
and d/J·dt: most often the file of the robot has no rotor inertias, which are the greater part of what a
geared axis moves. `ropsim robot estimate` adds them (S705).

Otherwise raise `plant_steps` in the controller's rates, or look for a gain, a mass or an inductance that is
off by a power of ten.
""",
    Category.UNFINISHED,
)

CAME_APART = define(
    "S706",
    "closed-chain-came-apart",
    Severity.ERROR,
    "a closed chain of the simulated arm has come apart",
    """
The run ends there, as with a state that is not finite (S701).

After each step of the integration positions and speeds are put back on the closed chains, to 1e-9 m or rad.
Where that fails the chain moves too fast for the step, or it is torn to where its links do not reach.

Raise `plant_steps` under `[controller]`; look for a body of a chain with next to no inertia, for a reference
beyond the reach of the chain, or for drives that are much too strong.
""",
    Category.UNFINISHED,
)

PASSED_DEAD_CENTRE = define(
    "S709",
    "closed-chain-passed-dead-centre",
    Severity.ERROR,
    "a closed chain of the simulated arm has gone through a dead centre into another assembly",
    """
The run ends there, as with a state that is not finite (S701). The message names the chain, the axis that it
held, and the joint that went over.

In a dead centre a closed chain locks: an axis cannot move on, and a joint without a motor moves while the
axes stand. What moves there by its own speed goes on to the other side, where the chain is put together
another way: crank and coupler are bent to the other hand.
From then on the same coordinates of the axes mean another place of the tool, so positions, collisions and
limits that follow would be wrong. A real arm leaves its references there.

A planned move does not come to a dead centre (M556, M557). The arm does if it overshoots next to one, sags
under its load, or is driven by the wrong joint: a slider does not turn a crank through its dead centre.

A chain that passes such a pose and stays as it was put together is no finding. Parallelograms are simulated
as couplings, and stay parallelograms when they are stretched and open again.

Keep references off the dead centre by more than the arm overshoots, make another joint of the chain the
axis, or limit the joint that went over.
""",
    Category.UNFINISHED,
)

STEEP_FRICTION = define(
    "S705",
    "friction-too-steep",
    Severity.WARNING,
    "friction stops an axis within less than an integration step",
    """
Viscous friction, and dry friction that sets in over a small speed, brake an axis at the rate d/J: d is the
slope of the friction over the speed of the joint, J the inertia that the axis moves. A fixed-step Runge-Kutta
integration of fourth order is stable while the product of that rate and its step stays below 2.785. Beyond
that the axis chatters about rest: settling times and lags are those of the chatter, or the state grows
without bound (S701).

Bristles of LuGre friction hold a joint at rest as on a spring of stiffness k: then √(k/J)·dt is the product
that is told, and the bristles are too stiff for the step.

Real geared axes do not do that, for their rotors are most of J: a rotor counts with the square of the gear
ratio. Files in URDF have no place for rotors.

**How to mend it.** `ropsim robot estimate FILE robots/NEW.stp` adds rotors and gears by stated rules, marked
as estimated; `ropsim new --robot FILE` does so by itself. Or raise `plant_steps` under `[controller]`, or
correct the friction.
""",
)

LONG_STEP = define(
    "S710",
    "integration-step-too-long",
    Severity.WARNING,
    "the integration step is too long for the fastest pole of drives and arm",
    """
Drives and arm are integrated in fixed Runge-Kutta steps of fourth order, which are stable while the product
of the step and the fastest pole stays below 2.785. Where no steps are stated, there are as many in a control
tick as the fastest pole needs, but at most 100: beyond that a pole is one of an error in the data more often
than of a machine. The state then grows without bound (S701), or rattles about where it should be.

A stiff gear with next to no inertia on one of its sides makes such a pole, and so do a small chamber of stiff
oil, a winding with next to no inductance, and `plant_steps` that are stated and too few.

**How to mend it.** Leave `plant_steps` out, or state as many as the hint says; else correct the stiffness or
the inertia: a spring that is ten times as stiff as the structure around it is as good as rigid.
""",
)

BAD_REFERENCE = define(
    "S702",
    "reference-shape-mismatch",
    Severity.ERROR,
    "an array given to the servo does not fit the arm",
    """
A `JointReference` holds three arrays of the same shape (ticks, n), a start position has n numbers, a joint
controller returns n voltages, and gains have n numbers each, where n is the number of joints. All numbers
must be finite.
""",
)

BAD_OPTIONS = define(
    "S703",
    "option-out-of-range",
    Severity.ERROR,
    "an option of the simulation is outside its range",
    """
Control rate, plant steps, slice length, record decimation, rows per second and most rows are whole numbers of
at least 1. The recording rate is the control rate divided by the decimation: 1000 Hz with a decimation of 4
makes 250 rows per second. Longest times of a run and of a wait, times of overrides and of an end by
hand are seconds from 0 on; an override is a share from 0 to 1.
""",
)


BAD_DRIVE = define(
    "S704",
    "drive-not-physical",
    Severity.ERROR,
    "a constant of a drive has a value that no drive can have",
    """
A DC motor needs a positive inductance, resistance and torque constant, a gear ratio other than zero (a
negative one turns the joint against the motor), and an amplifier with a positive voltage.

Look at the drive of the joint named in the message; units are V, A, ohm, H and N·m/A.
""",
)


class DriveDataError(RopsimError):
    """A constant of a drive is impossible."""


class NoDrivesError(RopsimError):
    """The arm has no drives."""


class DivergedError(RopsimError):
    """The state is no longer finite."""


class ServoArrayError(RopsimError):
    """An array does not fit the arm."""


class OptionError(RopsimError):
    """An option is outside its range."""
