"""Inertias in a TOML file: six numbers about the centre of mass, such as a rigid body can have."""

import numpy as np

from ropsim.spatial import Array, frozen
from ropsim.tomltext import diagnostics as kinds
from ropsim.tomltext.checks import TomlTable
from ropsim.tomltext.quantity import MOMENT

_ROUNDING = 1e-6  # relative; inertias are often written with few digits


def read_tensor(table: TomlTable) -> Array:
    """Return the tensor of the key `inertia` [kg·m²], shape (3, 3); zeros where it is absent."""
    ixx, iyy, izz, ixy, ixz, iyz = table.numbers("inertia", 6, MOMENT, (0.0,) * 6)
    return frozen([[ixx, ixy, ixz], [ixy, iyy, iyz], [ixz, iyz, izz]])


def read_inertia(table: TomlTable, mass: float) -> Array:
    """Return the tensor about the centre of mass [kg·m²], shape (3, 3); zeros where the key is absent.

    Args:
        table: with the key `inertia`.
        mass: of the body [kg]; one without mass has no inertia.
    """
    tensor = read_tensor(table)
    smallest, middle, greatest = np.linalg.eigvalsh(tensor).tolist()
    slack = _ROUNDING * max(abs(smallest), abs(greatest))
    message = ""
    if mass == 0.0 and greatest > 0.0:
        message = f"`{table.name_of('inertia')}` is not zero, but the mass is"
    elif smallest < -slack:
        message = f"`{table.name_of('inertia')}` has the negative principal moment {smallest:.6g} kg·m²"
    elif greatest > smallest + middle + slack:
        message = (
            f"`{table.name_of('inertia')}` has the principal moment {greatest:.6g} kg·m², "
            f"the other two allow at most {smallest + middle:.6g} kg·m²"
        )
    if message:
        hint = "the order is ixx, iyy, izz, ixy, ixz, iyz, in kg·m² about the centre of mass"
        table.findings.add(kinds.IMPOSSIBLE_INERTIA, table.value_span("inertia"), message, hint)
        return frozen(np.zeros((3, 3)))
    return tensor
