"""The keys of a servo valve and its supply, which hydraulic motors and cylinders share."""

from ropsim.tomltext import NUMBER, TomlTable

HYDRAULIC = NUMBER.within(1e-18, 1e12)
"""Areas, volumes for a radian and pressures are far from 1 in SI units."""
VALVE_NEEDED = (
    "supply_pressure",
    "bulk_modulus",
    "rated_flow",
    "rated_pressure_drop",
    "rated_input",
    "natural_frequency",
)
_FROM_ZERO = NUMBER.within(0.0, 1e9)
_POSITIVE = NUMBER.within(1e-9, 1e9)
_MOST_RETURN = 0.99
"""Share of the supply pressure that the return may have at the most: at all of it nothing moves."""


def read_valve(table: TomlTable) -> dict[str, float]:
    """Return what hydraulic motors and cylinders have in common, by the names of their attributes."""
    valve = {key: table.number(key, HYDRAULIC, 1.0) for key in VALVE_NEEDED}
    most = _MOST_RETURN * valve["supply_pressure"] if "supply_pressure" in table else 1e9
    return {
        "leakage": table.number("leakage", _FROM_ZERO, 0.0),
        "return_pressure": table.number("return_pressure", NUMBER.within(0.0, most), 0.0),
        "damping_ratio": table.number("damping_ratio", _POSITIVE, 0.7),
        "oil_density": table.number("oil_density", _POSITIVE, 870.0),
        **valve,
    }
