"""Cells with thousands of parts and many stations: reading the file, the start of a run."""

import tomllib
from dataclasses import replace
from typing import Any

from measuring import Measure, processor_seconds

from ropsim.cellfile import read_cell
from ropsim.core import SourceText
from ropsim.kinematics import NO_BLOCKS
from ropsim.model import Cell
from ropsim.simulation.testing import Moment, initial_parts, scenery_of, stood

PARTS, ROW = 5000, 70
ROBOT = '[robot]\nmodel = "puma560"\n'
TABLE = ROBOT + '[[objects]]\nname = "table"\nposition = [0, 0, 700]\nsize = [9000, 9000, 50]\n'
MOVES = 'signal = "go"\nstep = 90\nspeed = 90\nacceleration = 400\n'
PART = '[[parts]]\nname = "p{k}"\nsize = [50, 50, 50]\nmass = 0.1\nposition = [{x}, {y}, {z}]\n'


def crowded() -> SourceText:
    """Return a cell file with 5,000 parts on a table, every other one on its neighbour."""
    places = (
        (60 * (k // 2 % ROW) - 2000, 60 * (k // 2 // ROW) - 2000, 750 + 50 * (k % 2)) for k in range(PARTS)
    )
    parts = (PART.format(k=k, x=x, y=y, z=z) for k, (x, y, z) in enumerate(places))
    return SourceText("cell.toml", TABLE + "".join(parts))


def busy() -> SourceText:
    """Return the same with 50 robots and 50 turntables around the parts."""
    base = "base = {{ position = [{}, {}, 500] }}\n"
    stations = (f'[stations.s{k}]\nrobot = "puma560"\n{base.format(1000 * k, 6000)}' for k in range(50))
    devices = (
        f'[devices.d{k}]\nkind = "turntable"\n{base.format(1000 * k, 8000)}diameter = 300\n{MOVES}'
        for k in range(50)
    )
    rest = crowded().text.removeprefix(ROBOT)
    return SourceText("cell.toml", "".join((*stations, *devices, "[signals.go]\noutput = 1\n", rest)))


def cell_of(text: SourceText) -> Cell:
    """Return the cell of a text without findings."""
    cell, findings = read_cell(text, "crowded")
    assert cell is not None
    assert findings == ()
    return cell


def opening(benchmark: Any, text: SourceText) -> Cell:
    """Hold the opening of a cell to its budget, in seconds and beside what the library takes to read TOML."""
    measure = Measure(benchmark)
    cell, _ = measure(lambda: cell_of(text), rounds=2)
    joined = "\n".join(text.lines)
    own, library = processor_seconds(lambda: cell_of(text), lambda: tomllib.loads(joined))
    measure.figure("processor s to open", own, most=2.0)
    measure.figure("times what `tomllib` takes for the text", own / library, most=4.5)
    return cell


def test_a_cell_of_5000_parts_opens(benchmark: Any) -> None:
    assert len(opening(benchmark, crowded()).parts) == PARTS


def test_a_cell_of_50_stations_50_devices_and_5000_parts_opens(benchmark: Any) -> None:
    cell = opening(benchmark, busy())
    assert (len(cell.stations), len(cell.devices), len(cell.parts)) == (50, 50, PARTS)


def test_5000_parts_find_their_supports(benchmark: Any) -> None:
    measure = Measure(benchmark)
    cell = cell_of(crowded())
    half = replace(cell, parts=cell.parts[: PARTS // 2])
    on_table, _ = measure(lambda: parts_on_the_table(cell), rounds=2)
    measure.figure("parts on the table", on_table, least=PARTS / 2, most=PARTS / 2)
    whole, fewer = processor_seconds(lambda: parts_on_the_table(cell), lambda: parts_on_the_table(half))
    measure.figure("processor s to find the supports", whole, most=2.0)
    measure.figure("times what half of the parts take", whole / fewer, most=3.0)


def parts_on_the_table(cell: Cell) -> int:
    """Start a run of a cell as far as its parts are concerned; return how many stand on the table."""
    scenery, parts = scenery_of(cell, cell.content), initial_parts(cell)
    _, found = stood(parts, tuple(parts.seats), scenery, cell.supports, Moment({}, NO_BLOCKS))
    return sum(one.on == "table" for one in found.values())
