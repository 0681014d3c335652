"""The keys of a servo valve and its supply, which hydraulic motors and cylinders share."""

from ropsim.tomltext import NUMBER, VALUE_OUT_OF_RANGE, TomlTable

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
_FREQUENCY = NUMBER.within(0.1, 1e6)  # [rad/s]
_DAMPING_RATIO = NUMBER.within(1e-3, 1e3)
_MOST_OVERLAP = 0.9
_MOST_RETURN = 0.99
"""Share of the supply pressure that the return may have at the most: at all of it nothing moves."""


def read_valve(table: TomlTable) -> dict[str, float]:
    """Return the common data of hydraulic motors and cylinders, by the names of their attributes."""
    ranges = dict.fromkeys(VALVE_NEEDED, HYDRAULIC) | {"natural_frequency": _FREQUENCY}
    valve = {key: table.number(key, ranges[key], 1.0) for key in VALVE_NEEDED}
    return {
        "leakage": table.number("leakage", _FROM_ZERO, 0.0),
        "return_pressure": _return_pressure(table, valve["supply_pressure"]),
        "damping_ratio": table.number("damping_ratio", _DAMPING_RATIO, 0.7),
        "oil_density": table.number("oil_density", _POSITIVE, 870.0),
        "null_flow": _null_flow(table, valve["rated_flow"]),
        "overlap": table.number("overlap", NUMBER.within(0.0, _MOST_OVERLAP), 0.0),
        **valve,
    }


def _null_flow(table: TomlTable, rated: float) -> float:
    """Return the flow through a valve at its centre [m³/s], which is less than the rated one."""
    found = table.number("null_flow", _FROM_ZERO, 0.0)
    if "rated_flow" in table and found >= rated:
        message = f"`{table.name_of('null_flow')}` is {found:g} m³/s, the rated flow is {rated:g} m³/s"
        hint = "a valve at its centre lets some hundredths of its rated flow through"
        table.findings.add(VALUE_OUT_OF_RANGE, table.value_span("null_flow"), message, hint)
    return found


def _return_pressure(table: TomlTable, supply: float) -> float:
    """Return the pressure of the return [Pa], which is less than that of the supply."""
    found = table.number("return_pressure", _FROM_ZERO, 0.0)
    if "supply_pressure" in table and found > _MOST_RETURN * supply:
        message = f"`{table.name_of('return_pressure')}` is {found:g} Pa, the supply has {supply:g} Pa"
        hint = "the return has less than the supply; are both in Pa?"
        table.findings.add(VALUE_OUT_OF_RANGE, table.value_span("return_pressure"), message, hint)
    return found
