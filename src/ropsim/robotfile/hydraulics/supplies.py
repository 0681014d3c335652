"""The section `supplies`: pumps with accumulators, at which the valves of several drives are."""

from collections.abc import Mapping, Sequence
from dataclasses import replace

from ropsim.dynamics import drive_fault, shared_supply_fault
from ropsim.model import Drive, HydraulicSupply
from ropsim.robotfile.hydraulics.valves import HYDRAULIC
from ropsim.robotfile.toml_words import number, text, unless
from ropsim.tomltext import NUMBER, VALUE_OUT_OF_RANGE, TomlTable

_NEEDED = ("gas_volume", "precharge", "pump_flow", "line_volume", "relief_pressure")
_BAND = HydraulicSupply.__dataclass_fields__["pump_band"].default
_EXPONENT = HydraulicSupply.__dataclass_fields__["exponent"].default
_GAS = NUMBER.within(1.0, 1.7)


def read_supplies(root: TomlTable) -> dict[str, tuple[HydraulicSupply, TomlTable]]:
    """Return the supplies of a file by their names, each with its table.

    Args:
        root: the file, with the key `supplies`.
    """
    found: dict[str, tuple[HydraulicSupply, TomlTable]] = {}
    for table in root.tables("supplies"):
        table.require("name", *_NEEDED)
        name = table.text("name", "")
        supply = HydraulicSupply(
            name,
            pump_band=table.number("pump_band", HYDRAULIC, _BAND),
            exponent=table.number("exponent", _GAS, _EXPONENT),
            **{key: table.number(key, HYDRAULIC, 1.0) for key in _NEEDED},
        )
        table.finish()
        if name in found:
            message = f"`{table.name_of('name')}` is `{name}`, which another supply is called"
            table.findings.add(
                VALUE_OUT_OF_RANGE, table.value_span("name"), message, "give each its own name"
            )
        found.setdefault(name, (supply, table))
    return found


def with_supplies(
    drives: Sequence[Drive | None],
    rows: Sequence[TomlTable],
    names: Sequence[str],
    supplies: Mapping[str, tuple[HydraulicSupply, TomlTable]],
) -> tuple[Drive | None, ...]:
    """Return drives at the supplies that their rows name; impossible numbers are reported.

    Args:
        drives: of the rows, None for one that is not known.
        rows: of the file.
        names: of the supply in each row; empty for none.
        supplies: of the file.
    """
    made, faulty = list[Drive | None](), set[str]()
    for drive, row, name in zip(drives, rows, names, strict=True):
        if drive is None or name not in supplies:
            made.append(drive)
            continue
        supply, table = supplies[name]
        at = replace(drive, supply=supply)
        fault = drive_fault(at) if drive_fault(drive) is None and not table.missing else None
        if fault and name not in faulty:
            faulty.add(name)
            key = fault[0].strip("`")
            where, span = (table, table.value_span(key)) if key in table else (row, row.value_span("supply"))
            where.findings.add(VALUE_OUT_OF_RANGE, span, " ".join(fault), _HINT)
        made.append(at)
    known = [drive for drive in made if drive is not None]
    shared = shared_supply_fault(known) if len(known) == len(made) else None
    if shared:
        row = rows[shared[0]]
        row.findings.add(VALUE_OUT_OF_RANGE, row.value_span("supply"), " ".join(shared[1]), _HINT)
    return tuple(made)


_HINT = "pressures are in Pa, those of a supply are the same in the rows of all drives at it"


def supply_sections(drives: Sequence[Drive]) -> list[tuple[str, dict[str, str]]]:
    """Return the sections of the supplies of drives, as a file has them."""
    supplies = dict.fromkeys(drive.supply for drive in drives if drive.supply is not None)
    return [
        (
            "[[supplies]]",
            {
                "name": text(one.name),
                **{key: number(float(getattr(one, key))) for key in _NEEDED},
                "pump_band": unless(one.pump_band, _BAND),
                "exponent": unless(one.exponent, _EXPONENT),
            },
        )
        for one in supplies
    ]
