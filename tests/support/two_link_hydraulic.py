"""A robot of two links in a vertical plane that hydraulic cylinders move, as files of a project."""

from pathlib import Path

_OIL = """\
dead_volume_a = 4e-5
dead_volume_b = 4e-5
supply_pressure = 14e6
return_pressure = 3e5
bulk_modulus = 1.2e9
rated_pressure_drop = 7e6
rated_input = 0.04
natural_frequency = 628
damping_ratio = 0.8
leakage = 1.5e-12
moving_mass = 3
"""

ROBOT = """\
title = "Two links on cylinders"
convention = "standard"
home = [55, -100]
joints = [
  { name = "shoulder", a = 1000, limits = [5, 100], speed = 60, acceleration = 240, jerk = 2400 },
  { name = "elbow", a = 900, limits = [-145, -45], speed = 70, acceleration = 300, jerk = 3000 },
]
links = [
  { mass = 30, com = [-500, 0, 0], inertia = [0.2, 2.6, 2.6, 0, 0, 0] },
  { mass = 16, com = [-500, 0, 0], inertia = [0.1, 1.1, 1.1, 0, 0, 0] },
]

[base]
position = [0, 0, 900]
rpy = [90, 0, 0]

[[drives]]
kind = "cylinder"
area_a = 1.2566e-3
area_b = 0.7658e-3
stroke = 0.42
retracted_length = 0.665
carrier_pin = [0.175, -0.244, 0]
link_pin = [-0.20, -0.06, 0]
rated_flow = 3.2e-4
OIL
viscous = 1500

[[drives]]
kind = "cylinder"
area_a = 0.8042e-3
area_b = 0.4901e-3
stroke = 0.38
retracted_length = 0.595
carrier_pin = [-0.74, 0.13, 0]
link_pin = [-1.146, 0.043, 0]
rated_flow = 1.7e-4
OIL
viscous = 1200
""".replace("OIL\n", _OIL)

CELL = """\
[robot]
model = "robots/links.toml"

[locations.near_low]
position = [700, 0, 600]
orientation = "free"
"""

TASK = """\
program square
units mm, deg, s
task Square(a: loc)
  mov a
  lin a offset (100, 0, 0) speed 300 mm/s
  lin a offset (100, 0, 100) speed 300 mm/s
  lin a offset (0, 0, 100) speed 300 mm/s
  lin a speed 300 mm/s
endp
Square near_low
Square (1300, 0, 1000) free
"""

NEUTRAL = """\
ICR 1.0 square
REQUIRE CAP FREE LIN PTP
PROC main
  PUSH REAL 0.3
  SPD.LIN
  PUSH POSE 1.3 0.0 1.0 1.0 0.0 0.0 0.0
  ORI.FREE
  MOVE.PTP
  PUSH POSE 1.4 0.0 1.0 1.0 0.0 0.0 0.0
  ORI.FREE
  MOVE.LIN
  PUSH POSE 1.4 0.0 1.1 1.0 0.0 0.0 0.0
  ORI.FREE
  MOVE.LIN
  HALT
END
"""


def two_link_project(folder: Path, name: str, program: str) -> Path:
    """Write the project with a program, such as `main.task`, and return its folder."""
    for inner in ("programs", "robots"):
        (folder / inner).mkdir(parents=True)
    (folder / "robots" / "links.toml").write_text(ROBOT, "utf-8")
    (folder / "cell.toml").write_text(CELL, "utf-8")
    (folder / "programs" / name).write_text(program, "utf-8")
    return folder
