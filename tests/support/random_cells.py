"""Cells at random: stations that share places, devices, parts and programs that talk by signals."""

from dataclasses import replace

import numpy as np

import ropsim
from ropsim import icr, robots
from ropsim.model import (
    Barrier,
    BeltDrive,
    Box,
    Cell,
    Device,
    Gripper,
    IndexDrive,
    Part,
    Rates,
    Shape,
    Signal,
    Sink,
    Station,
    SwitchDrive,
    Tool,
)
from ropsim.spatial import Pose
from ropsim.workbench import environment_of

ARM = robots.load("puma560")
CONTROLLER = robots.default_controller(ARM)
DOWN = np.array([0.0, 1.0, 0.0, 0.0])
TURNED = np.array([0.0, 0.0, 0.0, 1.0])
SPACING = 1.0  # between two stations that face each other [m]
HEIGHT = 0.5  # of the grasp points [m]
OUTPUTS = ("go", "ready", "done", "belt_on", "turn", "push")
SCRIPTED = ("key", "late")
TOLD = ("there", "in_place", "is_out")
RATES = (1000, 1000, 500, 400)


def random_cell(rng: np.random.Generator) -> tuple[Cell, dict[str, icr.Program]]:
    """Return a cell with one to five stations, and a program for each of them."""
    stations = {f"s{k}": _station(rng, k) for k in range(int(rng.integers(1, 6)))}
    places = {
        f"p{k}": Pose(np.array([SPACING * (k // 3) + 0.5, 0.15 * (k % 3 - 1), HEIGHT]), DOWN)
        for k in range(3 * (len(stations) + 1) // 2)
    }
    signals = {name: Signal(name, is_input=False) for name in OUTPUTS}
    signals |= {name: Signal(name, is_input=True) for name in TOLD}
    signals |= {name: replace(signals["there"], name=name, changes=_script(rng)) for name in SCRIPTED}
    cell = Cell(
        "random",
        stations,
        parts=_parts(rng, places),
        devices={one.name: one for one in _devices(rng, len(stations))},
        signals=signals,
        locations=places,
        sinks=(Sink("bin", (0.5, 0.15, HEIGHT), 0.05),) if rng.random() < 0.3 else (),
    )
    return cell, {name: _program(rng, cell, name) for name in stations}


def _station(rng: np.random.Generator, number: int) -> Station:
    """Return an arm; those of odd numbers face the one before."""
    X_WB = Pose(np.array([SPACING * number, 0.0, 0.0]), TURNED if number % 2 else np.eye(4)[0])
    opens, closes = rng.choice([0.0, 0.05, 0.2], 2).tolist()
    gripper = Gripper(opens, closes, float(rng.choice([0.005, 0.05, 0.15])))
    tool = Tool("jaws", Pose(np.array([0.0, 0.0, 0.1])), 1.0, gripper=gripper)
    controller = replace(CONTROLLER, rates=Rates(int(rng.choice(RATES)), 4, 2))
    name = f"s{number}"
    return Station(name, ARM, controller, X_WB, {"jaws": tool}, "jaws", program=name)


def _script(rng: np.random.Generator) -> tuple[tuple[float, float], ...]:
    times = np.sort(rng.uniform(0.0, 6.0, int(rng.integers(0, 4)))).round(3)
    return tuple((time, float(k % 2 == 0)) for k, time in enumerate(times.tolist()))


def _parts(rng: np.random.Generator, places: dict[str, Pose]) -> tuple[Part, ...]:
    parts: list[Part] = []
    for name, pose in places.items():
        kind, size = rng.random(), np.array([0.05, 0.05, 0.04])
        low = Part(f"{name}_a", size, 0.5, Pose(pose.position))
        if kind < 0.35:
            parts.append(low)
        elif kind < 0.5:
            high = replace(low, name=f"{name}_b", X_WO=Pose(pose.position + np.array([0.0, 0.0, 0.04])))
            parts += [low, high]
        elif kind < 0.7:
            parts += [replace(low, name=f"{name}_{k}", supply=name, turn=k) for k in range(3)]
    return tuple(parts)


def _devices(rng: np.random.Generator, stations: int) -> list[Device]:
    """Return devices whose tops lie under some of the places."""
    top = HEIGHT - 0.04
    plate = (Shape(Box((0.3, 0.3, 0.02)), Pose(np.array([0.0, 0.0, -0.01]))),)
    found = []
    if rng.random() < 0.6:
        barrier = Barrier(float(rng.uniform(0.3, 0.9)), "there") if rng.random() < 0.6 else None
        drive = BeltDrive(
            float(rng.uniform(0.1, 0.5)), 1.0, str(rng.choice(["", "belt_on", "key"])), 1.0, barrier
        )
        X_WB = Pose(np.array([float(rng.choice([0.2, 0.5])), 0.0, top]))
        found.append(Device("belt", robots.conveyor(1.0, 0.5, 0.1), drive, X_WB))
    if stations > 2 and rng.random() < 0.5:
        table = IndexDrive("turn", np.pi / 2, 2.0, 6.0, "in_place")
        found.append(Device("table", robots.rotary(plate), table, Pose(np.array([1.5, 0.0, top]))))
    if rng.random() < 0.4:
        slide = SwitchDrive(str(rng.choice(["push", "late"])), 0.0, 0.3, 0.5, 2.0, "", "is_out")
        found.append(Device("slide", robots.slide(plate), slide, Pose(np.array([2.5, 0.0, top]))))
    return found


def _program(rng: np.random.Generator, cell: Cell, name: str) -> icr.Program:
    lines = [f"program {name}", "units mm, deg, s", *(_handing(cell, name) if rng.random() < 0.7 else ())]
    for _ in range(int(rng.integers(3, 9))):
        body = _statement(rng, cell)
        lines += ["repeat 2", *body, "endr"] if rng.random() < 0.2 else body
    code = ropsim.language.compile("\n".join([*lines, ""]), environment_of(cell, cell.stations[name]), name)
    assert code.icr is not None, [str(one) for one in code.diagnostics]
    return code.icr


def _handing(cell: Cell, name: str) -> list[str]:
    """Return how an arm of even number gives what lies amid it and the next one, and how that takes it."""
    number = int(name[1:])
    place = f"p{3 * (number // 2 * 2) + 1}"
    if place not in cell.locations:
        return []
    if number % 2 == 0:
        return [
            f"mov {place}",
            "close",
            f"lin {place} above 100 mm",
            "set ready on",
            'wait until done timeout 2 s else print "late"',
        ]
    return [
        'wait until ready timeout 4 s else print "late"',
        f"mov {place} above 100 mm",
        "close",
        "set done on",
        "wait 0.1 s",
    ]


def _statement(rng: np.random.Generator, cell: Cell) -> list[str]:
    place = str(rng.choice(list(cell.locations)))
    signal, level = str(rng.choice(OUTPUTS)), str(rng.choice(["on", "off"]))
    wanted = str(rng.choice([*OUTPUTS, *SCRIPTED, *TOLD]))
    no, time = str(rng.choice(["", "not "])), float(rng.uniform(0.0, 1.0).__round__(3))
    choices: list[list[str]] = [
        [f"mov {place} above {int(rng.integers(0, 120))} mm", "close"],
        [f"mov {place}", "close", f"lin {place} above 100 mm"],
        [f"mov {place} above 60 mm", f"lin {place}", "open", f"lin {place} above 60 mm"],
        [f"mov {place} offset ({int(rng.integers(-80, 80))}, 0, {int(rng.integers(0, 80))})", "open"],
        ["mov home"],
        [f"wait {time} s"],
        [f"set {signal} {level}"],
        [f"set {signal} on", f"wait {time} s", f"set {signal} off"],
        [f"wait until {no}{wanted}"],
        [f'wait until {no}{wanted} timeout {time} s else print "late"'],
        [f'if {no}{wanted} then print "seen"'],
        ["close"],
        ["open"],
    ]
    return choices[int(rng.integers(len(choices)))]
