"""Values of external axes in `[locations.NAME]`: in the units of the axes, within limits, of one station."""

import math

import pytest

from ropsim.cellfile import read_cell
from ropsim.core import Diagnostic, SourceText
from ropsim.model import Cell
from ropsim.workbench import environment_of

TRACK = "track = { length = 3000 }\n"
TABLE = "positioner = { radius = 400, height = 600, base = { position = [0, 2000, 0] } }\n"
ROBOT = '[robot]\nmodel = "puma560"\n'
PLACE = "[locations.stock]\nposition = [800, 700, 910]\n"
GATE = (
    '[stations.gate]\nmechanism = { kind = "slide", low = 0, high = 600, size = [200, 200, 20], mass = 20, '
    "speed = 600, acceleration = 1500 }\n"
)
BESIDE = "base = { position = [0, 5000, 0] }\n"


def station(name: str, more: str = "") -> str:
    return f'[stations.{name}]\nrobot = "puma560"\n{more}'


def read(text: str) -> tuple[Cell | None, tuple[Diagnostic, ...]]:
    return read_cell(SourceText("cell.toml", text), "folder")


def cell_of(text: str) -> Cell:
    cell, findings = read(text)
    assert [str(found) for found in findings] == []
    assert cell is not None
    return cell


def one(text: str) -> tuple[str, int, str]:
    """Return code, line and message of the only finding."""
    cell, (found,) = read(text)
    assert cell is None
    assert found.span is not None
    return found.code, found.span.line, found.message


def seen(cell: Cell, name: str) -> tuple[float, ...]:
    """Return the values that a program of a station sees at the location."""
    at = cell.stations[name]
    place = environment_of(cell, at).locations["stock"]
    assert place[7:] == cell.external_at("stock", at)
    return place[7:]


def test_values_are_in_the_units_of_their_axes() -> None:
    text = f"{PLACE}external = [800, 90]\n"
    assert seen(cell_of(ROBOT + TRACK + TABLE + text), "robot") == pytest.approx((0.8, math.pi / 2.0))
    metres = (
        '[units]\nlength = "m"\nangle = "rad"\n[locations.stock]\nposition = [1, 1, 1]\nexternal = [1, 1]\n'
    )
    track = "track = { length = 3 }\npositioner = { radius = 0.4, base = { position = [0, 2, 0] } }\n"
    assert seen(cell_of(ROBOT + track + metres), "robot") == pytest.approx((1.0, 1.0))


def test_a_location_without_values_has_none() -> None:
    cell = cell_of(ROBOT + TRACK + PLACE)
    assert (seen(cell, "robot"), cell.external) == ((), {})


def test_the_station_that_has_external_axes_is_meant() -> None:
    cell = cell_of(station("left") + station("right", BESIDE + TRACK) + PLACE + "external = [800]\n")
    assert (seen(cell, "left"), seen(cell, "right")) == ((), (0.8,))
    assert cell.external["stock"].station == "right"


def test_axes_of_one_kind_may_all_be_meant() -> None:
    cell = cell_of(station("left", TRACK) + station("right", BESIDE + TRACK) + PLACE + "external = [800]\n")
    assert (seen(cell, "left"), seen(cell, "right")) == ((0.8,), (0.8,))


def test_one_station_of_several_is_named() -> None:
    stations = station("left", TRACK) + station("right", BESIDE + TABLE) + PLACE
    cell = cell_of(f'{stations}external = [90]\nstation = "right"\n')
    assert seen(cell, "left") == ()
    assert seen(cell, "right") == pytest.approx((math.pi / 2.0,))
    code, line, message = one(f"{stations}external = [90]\n")
    assert (code, line) == ("X803", stations.count("\n") + 1)
    assert "`left` and `right`, whose external axes differ" in message


@pytest.mark.parametrize(
    "other",
    [
        station("right", BESIDE + TRACK + TABLE),
        GATE,
    ],
)
def test_stations_that_cannot_use_the_values_are_not_meant(other: str) -> None:
    cell = cell_of(f"{station('left', TRACK)}{other}{PLACE}external = [800]\n")
    assert seen(cell, "left") == (0.8,)


@pytest.mark.parametrize(
    ("value", "code", "words"),
    [
        ("[800]", "X805", "`locations.stock.external` has 1 item, needed are 2: E1 (track), E2 (positioner)"),
        ("[800, 90, 1]", "X805", "has 3 items, needed are 2"),
        ("[]", "X805", "has 0 items, needed are 2"),
        ("800", "X804", "needed is a list of numbers"),
        ('["800", 90]', "X804", "item 1 of `locations.stock.external` is text"),
        ("[800, true]", "X804", "item 2 of `locations.stock.external`"),
        ("[nan, 0]", "X807", "is `nan`"),
        ("[1501, 0]", "X806", "is 1501 mm, allowed is -1500 to 1500 mm"),
        ("[0, -361]", "X806", "is -361 deg, allowed is -360 to 360 deg"),
    ],
)
def test_a_wrong_value_is_told_on_its_line(value: str, code: str, words: str) -> None:
    text = ROBOT + TRACK + TABLE + PLACE
    found, line, message = one(f"{text}external = {value}\n")
    assert (found, line) == (code, text.count("\n") + 1)
    assert words in message


def test_values_on_the_limits_are_right() -> None:
    cell = cell_of(ROBOT + TRACK + PLACE + "external = [-1500]\n")
    assert seen(cell, "robot") == (-1.5,)


def test_values_for_all_stations_are_within_the_limits_of_each() -> None:
    both = station("left", TRACK) + station("right", BESIDE + "track = { length = 1000 }\n")
    code, _, message = one(f"{both}{PLACE}external = [800]\n")
    assert code == "X806"
    assert "allowed is -500 to 500 mm" in message


@pytest.mark.parametrize(
    ("text", "code", "words"),
    [
        (f"{ROBOT}{PLACE}external = [800]\n", "X805", "no robot of this cell has external axes"),
        (
            f'{station("left", TRACK)}{station("right", BESIDE)}{PLACE}external = [800]\nstation = "right"\n',
            "X805",
            "station `right` has no external axes",
        ),
        (
            f'{ROBOT}{TRACK}{PLACE}external = [800]\nstation = "lift"\n',
            "X809",
            "station `lift` is not defined",
        ),
        (
            f'{station("left", TRACK)}{GATE}{PLACE}external = [800]\nstation = "gate"\n',
            "X805",
            "is given for `gate`, which has no arm",
        ),
        (f'{ROBOT}{TRACK}{PLACE}station = "robot"\n', "X802", "`locations.stock.station` has no meaning"),
    ],
)
def test_values_that_belong_to_nobody_are_told(text: str, code: str, words: str) -> None:
    found, _, message = one(text)
    assert found == code
    assert words in message


def test_a_station_that_cannot_be_read_is_told_alone() -> None:
    code, _, _ = one(f'[robot]\nmodel = "pumma"\n{PLACE}external = [800]\n')
    assert code == "X860"


@pytest.mark.parametrize(("value", "codes"), [(6.2831853072, []), (-6.2831853072, []), (6.2832, ["X806"])])
def test_a_limit_may_be_written_with_the_decimals_that_one_has(value: float, codes: list[str]) -> None:
    """A turntable turns once to each side: 2π, which is 6.2831853072 rounded up to ten decimals."""
    table = "positioner = { radius = 0.4, height = 0.6, base = { position = [0, 2, 0] } }\n"
    units = '[units]\nlength = "m"\nangle = "rad"\n'
    place = "[locations.stock]\nposition = [1, 1, 1]\n"
    _, findings = read(f"{ROBOT}{table}{units}{place}external = [{value}]\n")
    assert [found.code for found in findings] == codes
