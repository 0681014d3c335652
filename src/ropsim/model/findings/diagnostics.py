"""Errors of a robot model and of a cell (codes X850 to X859, X862, X974 to X976)."""

from ropsim.core import Severity, define

REVERSED_LIMITS = define(
    "X850",
    "reversed-joint-limits",
    Severity.ERROR,
    "the lower limit of a joint is not below its upper limit",
    """
A joint can only move between its lower and its upper limit, so the lower one must be the smaller number.
Reversed or equal limits leave no motion: every target would be out of range.

Mend it by exchanging the two numbers. A joint that turns without end gets wide limits such as ±400
turns. Limits are in radians (metres for a prismatic joint) inside the model.
""",
)

NEGATIVE_MASS = define(
    "X851",
    "negative-mass",
    Severity.ERROR,
    "a link has a negative mass",
    """
Masses are at least zero. With a negative mass the mass matrix of the arm can lose positive definiteness;
the simulation would then accelerate against the torque.

Look for a sign or a column that slipped in the table of link data.
""",
)

MASSLESS_LINK = define(
    "X852",
    "massless-link",
    Severity.HINT,
    "a link has no mass",
    """
The link adds no weight. That is right where a published set of parameters leaves a mass out because it
cannot influence the dynamics: the first link of a PUMA only turns about a vertical axis, so only its
moment of inertia about that axis counts. It is a mistake where the link is lifted by another joint.

Nothing needs to be done in the first case; in the second, look up or estimate the mass.
""",
)

ASYMMETRIC_INERTIA = define(
    "X862",
    "inertia-tensor-not-symmetric",
    Severity.ERROR,
    "an inertia tensor is not symmetric",
    """
An inertia tensor is symmetric: Ixy = Iyx and so on. Products of inertia are often given once, and with either
sign: write the same number on both sides of the diagonal. No arm is made until then.
""",
)

NEGATIVE_INERTIA = define(
    "X974",
    "inertia-negative",
    Severity.ERROR,
    "a link with mass has a negative moment of inertia",
    """
A moment of inertia is an integral of squared distances, so no principal moment of a body is below zero. A
negative one is a mistake: a wrong sign of a product of inertia, a column that slipped, or a tensor about
another point than the centre of mass. Two things are allowed (X853): rounding, up to a thousandth of the
largest moment, and effective inertias of links with mass 0, as identification of an arm finds them.

Mend the tensor, or leave it out: an arm without masses can be moved, but not simulated with dynamics.
""",
)

INDEFINITE_INERTIA = define(
    "X853",
    "inertia-not-positive",
    Severity.WARNING,
    "an inertia tensor is not positive definite",
    """
The principal moments of inertia of a body with extent are positive. A zero occurs in published sets
where only one moment matters (a first link that only turns about one axis), a slightly negative value where
the tensor was rounded, any value in effective inertias of links without mass. A point mass (all moments
zero) is allowed.

The simulation runs as long as the mass matrix of the whole arm stays positive definite (rotor inertias
help).
""",
)

TRIANGLE_VIOLATED = define(
    "X854",
    "inertia-triangle-violated",
    Severity.WARNING,
    "the principal moments of a link violate A + B >= C",
    """
For every rigid body the largest principal moment of inertia is at most the sum of the two others,
because each moment is an integral of squared distances. Measured sets violate this now and then: link 3
of Armstrong, Khatib & Burdick's PUMA 560 has (0.066, 0.086, 0.0125) kg·m², and 0.0785 < 0.086.

The equations of motion do not need the inequality and ropsim uses the numbers as they are; other engines
may refuse the model. Check the source; keep the numbers if they are as published.
""",
)

ESTIMATED_PARAMETERS = define(
    "X855",
    "estimated-parameters",
    Severity.HINT,
    "a group of parameters is an estimate",
    """
No published number is known for these parameters; plausible ones were chosen so that the model can run.
Results that depend on them (currents, voltages, cycle times near a limit) are as good as the estimate.

Replace them by data of the real machine where such results matter, and note the source in the model's
`origins`.
""",
)

UNUSABLE_LIMIT = define(
    "X856",
    "limit-not-positive",
    Severity.ERROR,
    "a speed, acceleration, jerk or effort limit is not a positive number",
    """
Motions are planned with the largest speed, acceleration and jerk of each joint, so these must be
positive numbers. Zero would mean a joint that never moves, NaN has no meaning. Only the effort may be
infinite, where it is unknown.

Give the number in rad/s, rad/s², rad/s³ or N·m (m/s, m/s², m/s³ or N for a prismatic joint).
""",
)

HOME_OUT_OF_RANGE = define(
    "X857",
    "home-out-of-range",
    Severity.ERROR,
    "the home position violates a joint limit",
    """
Programs return to the home position, so every coordinate of it must lie within the limits of its joint,
and there must be one coordinate for each joint.

Change the home position or the limit.
""",
)

COUNT_MISMATCH = define(
    "X858",
    "part-count-mismatch",
    Severity.ERROR,
    "a robot has not as many links or drives as joints",
    """
Every joint moves exactly one link and, where drive data exist, is moved by exactly one drive. The lists
run from the base to the tip.

Add the missing entries, or remove the drives altogether for an arm without drive data.
""",
)

NOT_FINITE = define(
    "X859",
    "model-value-not-finite",
    Severity.ERROR,
    "a mass, centre of mass, inertia or placement is not a finite number",
    """
Infinite values and NaN spread through every result without a trace of where they came from; the model
refuses them at the door. Look for a division by zero or an empty cell in the source of the data.
""",
)

UNUSABLE_DRIVE = define(
    "X975",
    "drive-number-impossible",
    Severity.ERROR,
    "a limit of a drive is not positive, its ratio 0, or an inertia or friction has the wrong sign",
    """
The voltage, current, torque or valve current of a drive is clipped to plus and minus its limit, so the limit
is a positive number; that of a current or an effort may be infinite where it is unknown. The inertia of a
rotor and the mass of a piston are 0 or more: a negative one would push the joint the way it accelerates.
Friction resists: its torque is 0 or more for positive speeds, 0 or less for negative ones; it turns round
over a range of speeds that is wider than 0. A gear with the ratio 0 would not move its joint.

Look for a sign or a column that slipped in the data of the drive.
""",
)

OUT_OF_RANGE = define(
    "X976",
    "number-out-of-range",
    Severity.ERROR,
    "a number of a station, its controller, a tool or a cell is outside its allowed range",
    """
Rates, default speeds, times, distances and poses have ranges in which a run is possible: periods are whole
numbers of at least 1, speeds are above 0, times and distances 0 or more, and every number is finite. A number
outside its range would stop the planning, never end a wait, or spread through every result. A cell is
refused as soon as it is made.

The message names the station, tool or cell, the field, the number found and the range. Files are checked
when they are read, in narrower ranges and in their own units; a cell that is made in Python has SI units.
Look for degrees or millimetres in place of radians or metres, a sign, or a division by zero in the source.
""",
)
