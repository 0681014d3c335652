"""Rules of an MJCF file for the weights of its bodies: bounds, balance, and the mass of the whole model."""

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from ropsim.core import frozen_dataclass
from ropsim.exchange.assembly.description import Body
from ropsim.exchange.files.values import number_of, numbers_of
from ropsim.exchange.files.xml_tree import Element
from ropsim.exchange.losses.notes import Notes
from ropsim.exchange.mjcf.keywords import Keyword, keyword_of, says
from ropsim.model import Payload
from ropsim.spatial import Array

_GUARD = 1e-9
"""Bounds up to this [kg, kg·m²] keep MuJoCo from dividing by zero and are left out."""
_SLACK = 1e-12  # relative, of A + B >= C: products of rotations round


@frozen_dataclass
class WeightRules:
    """Attributes of `compiler` that change weights (XML reference of MuJoCo).

    Attributes:
        from_geometry: which bodies have the mass of their geometry (`inertiafromgeom`): `auto` for bodies
            without `inertial`, `true` for all, `false` for none.
        groups: first and last group of geometry that has a mass (`inertiagrouprange`).
        least_mass: of a body [kg] (`boundmass`).
        least_inertia: principal moment of a body [kg·m²] (`boundinertia`).
        balances: whether moments that break A + B >= C become their mean (`balanceinertia`).
        total: mass to which the whole model is scaled [kg]; none where it is not positive (`settotalmass`).
    """

    from_geometry: Keyword
    groups: tuple[float, float]
    least_mass: float
    least_inertia: float
    balances: bool
    total: float

    def has_mass(self, group: float) -> bool:
        """Return whether geometry of a group has a mass."""
        return self.groups[0] <= group <= self.groups[1]


def weight_rules(compiler: Element, notes: Notes) -> WeightRules:
    """Return the rules that the settings of a file say."""
    first, last = numbers_of(compiler, "inertiagrouprange", notes, (0.0, 5.0))
    return WeightRules(
        keyword_of(compiler, "inertiafromgeom", notes),
        (first, last),
        number_of(compiler, "boundmass", notes),
        number_of(compiler, "boundinertia", notes),
        says(compiler, "balanceinertia", notes),
        number_of(compiler, "settotalmass", notes, -1.0),
    )


def corrected(weight: Payload, rules: WeightRules) -> Payload:
    """Return the weight of a body with its mass and moments not below their bounds, and balanced."""
    if not rules.balances and max(rules.least_mass, rules.least_inertia) <= _GUARD:
        return weight
    moments, axes = np.linalg.eigh((weight.inertia + weight.inertia.T) / 2.0)
    made: Array = np.maximum(moments, rules.least_inertia)
    if rules.balances and made[0] + made[1] < made[2] * (1.0 - _SLACK):
        made = np.full(3, made.mean())
    inertia = weight.inertia if np.array_equal(made, moments) else axes @ np.diag(made) @ axes.T
    return Payload(max(weight.mass, rules.least_mass), weight.com, inertia)


def scaled_to_total(bodies: Sequence[Body], rules: WeightRules) -> tuple[Body, ...]:
    """Return bodies whose masses add up to the mass of the model; their inertias are scaled with them."""
    mass = sum(one.weight.mass for one in bodies)
    if rules.total <= 0.0 or mass <= 0.0:
        return tuple(bodies)
    factor = rules.total / mass
    return tuple(replace(one, weight=_times(one.weight, factor)) for one in bodies)


def _times(weight: Payload, factor: float) -> Payload:
    return Payload(weight.mass * factor, weight.com, weight.inertia * factor)
