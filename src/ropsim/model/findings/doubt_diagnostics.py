"""Doubts about numbers of an arm that are usually slips (codes X863 to X869, X917 and X926)."""

from ropsim.core import Kind, Severity, define

PLACEHOLDER_MASSES = define(
    "X863",
    "placeholder-masses",
    Severity.WARNING,
    "all links have the same mass or inertia",
    """
No arm has links of one mass. Such numbers, most often 1 kg or a unit tensor, stand in robot files because a
tool wanted a number and nobody had one. Torques, currents and settling times that are computed with them mean
nothing.

Look the masses up, or leave them out: a robot file with the mass of the whole arm gets estimates by a stated
rule, and one without any mass runs without dynamics and says so.
""",
)

UNLIKELY_MASS = define(
    "X864",
    "unlikely-mass",
    Severity.WARNING,
    "the arm is heavier than arms of its size are",
    """
The moving links of arms that are sold have 1 to 40 kg for each cubic metre of the cube over their length,
all distances from joint to joint and all strokes added up; this one has more than 50. Masses are in
kilograms, whatever `[units]` of a file says: most often these are in grams, or belong to a larger arm.
""",
)

UNLIKELY_INERTIA = define(
    "X865",
    "unlikely-inertia",
    Severity.WARNING,
    "the mass of a link is far outside of it",
    """
A centre of mass lies within the link, and the radius of gyration, the root of moment of inertia over mass,
is smaller than the link. Here one of them is longer than the whole arm. Inertias are in kg·m²: numbers in
kg·mm² or g·cm² are a million and ten million times too large. Centres of mass are in the unit of length of
the file.
""",
)

COPIED_LIMITS = define(
    "X866",
    "copied-limits",
    Severity.HINT,
    "all joints have the same limits, efforts or rotors",
    """
There are arms whose joints are all alike, but in most files that say so the first row was copied to the
others, or one number such as 100 or 1000 stands for an unknown effort. Ranges decide which postures a pose
has, speeds and accelerations decide cycle times, efforts and rotors decide what an axis can carry and how
fast it settles.

Compare them with the data sheet of the robot.
""",
)

DOUBLED_AXIS = define(
    "X867",
    "doubled-axis",
    Severity.WARNING,
    "two joints one after the other move about the same axis",
    """
The second joint can do nothing that the first one cannot, so the arm has an axis less than its table has
rows. Most often `alpha` or `a` of the row between them is missing, or a table of the modified form was
given as one of the standard form. A passive joint at the end of an arm, of a gripper for instance, does not
belong into the table.
""",
)

JOINT_WITHOUT_RANGE = define(
    "X868",
    "joint-without-range",
    Severity.WARNING,
    "a joint can hardly move",
    """
The range of the joint is less than 10 mm or 0.6°. It stands still for every purpose, yet inverse kinematics
and programs count it as an axis. Often such rows stand for a fixed flange: give that as the mechanical
interface. Or the limits are in another unit than the file says.
""",
)

UNLIKELY_SIZE = define(
    "X869",
    "unlikely-size",
    Severity.WARNING,
    "the arm is smaller or larger than arms are",
    """
All lengths of the table, and the strokes of sliding joints, add up to less than 50 mm or more than 50 m.
The reach of an arm is at most this sum. Most often the lengths are in metres and the file says nothing of
units, so they were taken for millimetres:

```toml
units = { length = "m" }
```
""",
)

UNLIKELY_DRIVE = define(
    "X917",
    "unlikely-drive",
    Severity.WARNING,
    "a number of a drive is beyond what motors, cylinders and valves have",
    """
The model has SI units: pressures and bulk moduli in Pa, flows in m³/s, areas in m², volumes in m³, inertias
in kg·m², inductances in H. Data sheets give bar, l/min, mm², cm³, kg·cm² and mH. A drive with such a number
is ten to a million times too strong, too fast or too sluggish. The hint names the unit in which the number
would be a usual one.

| data sheet | in SI units |
|---|---|
| 160 bar | `16e6` Pa |
| 24 l/min | `4e-4` m³/s |
| 7854 mm² | `7.854e-3` m² |
| 400 cm³ | `4e-4` m³ |
| 2 kg·cm² | `2e-4` kg·m² |
| 1.5 mH | `1.5e-3` H |
""",
)

LIGHT_ARM = define(
    "X926",
    "arm-too-light",
    Severity.WARNING,
    "the links of an arm together weigh less than its rated payload",
    """
Arms weigh more than they carry: industrial ones three to ten times as much, the lightest cobots nearly
twice as much. Where the links together have less than four fifths of the rated payload, masses are in tonnes
or missing, or the payload is that of another arm.

```toml
payload = 6
mass = { total = 0.03 }     # wrong: kilograms
mass = { total = 30 }       # right
```
""",
)

DOUBTS: tuple[Kind, ...] = (
    PLACEHOLDER_MASSES,
    UNLIKELY_MASS,
    UNLIKELY_INERTIA,
    COPIED_LIMITS,
    DOUBLED_AXIS,
    JOINT_WITHOUT_RANGE,
    UNLIKELY_SIZE,
    UNLIKELY_DRIVE,
    LIGHT_ARM,
)
"""All doubts; no built-in arm gives rise to one."""
