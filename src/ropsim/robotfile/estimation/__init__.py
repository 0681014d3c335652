"""Masses, torque limits, rotors, friction and accelerations of arms by rule, where none are published."""
