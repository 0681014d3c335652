"""Robot files: the PUMA 560 as its papers print it, and small arms to make mistakes in."""

PUMA560 = """
name = "puma560"
title = "Unimation PUMA 560"
convention = "standard"
units = { length = "m", angle = "deg" }
home = [0, 75, -180, 0, -75, 0]
joints = [
  { alpha = 90, d = 0.67183, limits = [-160, 160], effort = 97.6 },
  { a = 0.4318, limits = [-45, 225], effort = 186.4 },
  { a = 0.0203, alpha = -90, d = 0.15005, limits = [-225, 45], effort = 89.4 },
  { alpha = 90, d = 0.4318, limits = [-110, 170], effort = 24.2 },
  { alpha = -90, limits = [-100, 100], effort = 20.1 },
  { limits = [-266, 266], effort = 21.3 },
]
links = [
  { mass = 0, com = [0, 0, 0], inertia = [0, 0.35, 0, 0, 0, 0] },
  { mass = 17.4, com = [-0.3638, 0.006, 0.2275], inertia = [0.13, 0.524, 0.539, 0, 0, 0] },
  { mass = 4.8, com = [-0.0203, -0.0141, 0.070], inertia = [0.066, 0.086, 0.0125, 0, 0, 0] },
  { mass = 0.82, com = [0, 0.019, 0], inertia = [1.8e-3, 1.3e-3, 1.8e-3, 0, 0, 0] },
  { mass = 0.34, com = [0, 0, 0], inertia = [0.3e-3, 0.4e-3, 0.3e-3, 0, 0, 0] },
  { mass = 0.09, com = [0, 0, 0.032], inertia = [0.15e-3, 0.15e-3, 0.04e-3, 0, 0, 0] },
]

[[drives]]
kind = "dc"
ratio = -62.6111
torque_constant = 0.19
resistance = 2.1
inductance = 3.5e-3
rotor_inertia = 200e-6
viscous = 1.48e-3
coulomb = [0.395, 0.435]
max_voltage = 40
max_current = 8.3
[[drives]]
kind = "dc"
ratio = 107.815
torque_constant = 0.19
resistance = 2.1
inductance = 3.5e-3
rotor_inertia = 200e-6
viscous = 0.817e-3
coulomb = [0.126, 0.071]
max_voltage = 40
max_current = 9.2
[[drives]]
kind = "dc"
ratio = -53.7063
torque_constant = 0.19
resistance = 2.1
inductance = 3.5e-3
rotor_inertia = 200e-6
viscous = 1.38e-3
coulomb = [0.132, 0.105]
max_voltage = 40
max_current = 8.8
[[drives]]
kind = "dc"
ratio = 76.0364
torque_constant = 0.07
resistance = 6.7
inductance = 5e-3
rotor_inertia = 33e-6
viscous = 71.2e-6
coulomb = [11.2e-3, 16.9e-3]
max_voltage = 40
max_current = 4.6
[[drives]]
kind = "dc"
ratio = 71.923
torque_constant = 0.07
resistance = 6.7
inductance = 5e-3
rotor_inertia = 33e-6
viscous = 82.6e-6
coulomb = [9.26e-3, 14.5e-3]
max_voltage = 40
max_current = 4.1
[[drives]]
kind = "dc"
ratio = 76.686
torque_constant = 0.07
resistance = 6.7
inductance = 5e-3
rotor_inertia = 33e-6
viscous = 36.7e-6
coulomb = [3.96e-3, 10.5e-3]
max_voltage = 40
max_current = 4
"""
"""Without speeds, accelerations and jerks, which the built-in model gives in radians."""

TWO_JOINTS = """
convention = "standard"
joints = [
  { a = 400, limits = [-170, 170], speed = 120 },
  { a = 300, alpha = 180, limits = [-150, 150], speed = 180 },
]
"""
"""A planar arm that says what it must and no more."""
