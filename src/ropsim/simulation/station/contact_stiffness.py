"""Meant contacts that are too stiff for the control rate of an arm."""

from collections.abc import Iterator

import numpy as np

from ropsim.core import Diagnostic
from ropsim.dynamics import mass_matrix
from ropsim.flow import Fidelity
from ropsim.kinematics import jacobian_at
from ropsim.model import ROBOT, Cell, MeantContact, Payload, Station, Tool, combine
from ropsim.simulation.servo.diagnostics import STIFF_CONTACT
from ropsim.simulation.station.shapes_at_once import shapes_at_once
from ropsim.spatial import Pose


def stiff_findings(cell: Cell, fidelity: Fidelity) -> Iterator[Diagnostic]:
    """Yield a warning for each contact and arm with drives in which its force would not settle.

    Args:
        cell: that is run.
        fidelity: that was requested.
    """
    if fidelity is Fidelity.KINEMATIC:
        return
    for contact in cell.contacts:
        for station in cell.stations.values():
            tool = _tool(station, contact)
            if not station.robot.drives or tool is None:
                continue
            period = station.controller.rates.control_period
            mass = felt_mass(station, tool)
            damper, most = contact.damping + 0.5 * contact.stiffness * period, 2.0 * mass / period
            count = shapes_at_once(cell, contact, station)
            if count * damper >= most:
                yield _finding(contact, station, (mass, count), count * damper / most)


def felt_mass(station: Station, tool: Tool) -> float:
    """Return the least mass that a force at the tool centre point feels, at the start and at rest [kg].

    It is 1/λ, λ the greatest eigenvalue of J·M⁻¹·Jᵀ with the linear rows of the Jacobian J.

    Args:
        station: with drives.
        tool: at its arm.
    """
    load = combine(tool.loads)
    return min(_least(station, tool.X_MT, load, q) for q in (station.q_start, station.robot.home))


def _least(station: Station, X_MT: Pose, load: Payload, q: np.ndarray) -> float:
    J = jacobian_at(station.robot, q, X_MT)[:3]
    yields = J @ np.linalg.solve(mass_matrix(station.robot, q, load), J.T)
    return float(1.0 / np.linalg.eigvalsh(yields)[-1])


def _tool(station: Station, contact: MeantContact) -> Tool | None:
    """Return the tool of a contact, or the one with which a station holds a part; None without one."""
    own = station.tools.get(contact.moving)
    if own is not None:
        return own
    return station.tools.get(station.default_tool)


def _finding(contact: MeantContact, station: Station, on: tuple[float, float], ratio: float) -> Diagnostic:
    """Return the finding of a contact on a mass [kg], with so many pairs of shapes at once."""
    mass, count = on
    each = f", for as much as {count:.3g} pairs of shapes that may touch at once," if count > 1.0 else ""
    where = "" if station.name == ROBOT else f" at station `{station.name}`"
    hz = station.controller.rates.control_hz
    return STIFF_CONTACT.at(
        None,
        f"contact `{contact.name}`{where}: {contact.stiffness / 1e3:.6g} N/mm with damping "
        f"{contact.damping / 1e3:.3g} N·s/mm{each} at {hz} Hz acts on {mass:.3g} kg; "
        f"{'n·' if each else ''}(c + k·T/2)·T/2m is {ratio:.3g}, allowed is less than 1",
        hint=f"lower `stiffness` and `damping` by {1.5 * ratio:.2g}, or raise `control_hz`",
        data={"contact": contact.name, "station": station.name, "mass_kg": mass, "pairs": count},
    )
