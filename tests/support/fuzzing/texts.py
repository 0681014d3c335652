"""Texts of a project: `cell.toml`, robot files, task programs and ICR programs."""

import json
from dataclasses import replace
from functools import cache
from pathlib import Path
from random import Random

import numpy as np

from ropsim import icr, kinematics, language, robots
from ropsim.cellfile import read_cell
from ropsim.core import Diagnostic, SourceText
from ropsim.dynamics import check_model
from ropsim.model import audit
from ropsim.records import numeric
from ropsim.robotfile import read_robot_file, robot_file_places, write_robot_file
from ropsim.views import Style, diagnostics_text, scene
from ropsim.workbench import environment_of
from support.cells import one_station
from support.fuzzing.cells import AXES, RIGHT, STATIONS
from support.fuzzing.mutation import TEXT, mutated, nest, numeral, word
from support.fuzzing.robots import ARMS
from support.fuzzing.target import Target

_ROOT = Path(__file__).parents[3]
_CELLS = (
    RIGHT.encode(),
    STATIONS.encode(),
    AXES.encode(),
    (_ROOT / "examples" / "first_cell" / "cell.toml").read_bytes(),
)
_CELL_FILES = tuple(sorted(_ROOT.glob("examples/*/cell.toml")))
_ICRS = tuple(
    path.read_bytes() for path in sorted(_ROOT.glob("tests/golden/icr/*.icr")) if path.stat().st_size < 2_000
)
_ON_FIXTURE = b"""program turning
units mm, deg, s
pattern slots = grid 2 x 2 from corner step (0, 30, 0), (30, 0, 0)
task Bring(place)
  mov place above 80
  lin place offset (0, 0, 10)
endp
mov joints(0, 75, -180, 0, -75, 0, 200, 90)
Bring corner
with frame fixture
  mov (10, 20, 60)
endwith
for each s in slots
  Bring s
endf
q = corner
q.z = 100
mov q in base
mov here above 50
print dist(corner, q)
"""
_ON_THE_WAY = b"""program moving
units mm, deg, s
signal glue = output 1
signal ready = input 2
signal force_z = analog input 3
loc a = (300, 0, 100; down, config (left, up), turns (0, -1))
loc b = (350, 80, 100)
loc c = (400, 0, 100)
task Bead(p: loc, m: loc, q: loc)
  lin p fine at 3 after start do set glue on at 0.2 s before end do set glue off
  circ via m to q blend 5 angle 270
  spline via p, m, q to p above 30 speed 50
endp
Bead a, b, c
mov via a above 50, joints(0, 90, -180, 0, -45, 0), home to b speed 50 %
lin via b, c to a fine at 5 mm before end do set glue = not ready
lin c until ready store touch timeout 2 speed 5
lin touch rel (0, 0, -5) until force_z > 15 N
lin (350, 0, 120; free, rz 10) offset (0, 0, 5) free blend 3
circ via b to c free
q = a free
q.y = q.y + 5
mov q until not (ready is off) store q
"""
_COMPARED = 20_000
"""Larger texts are formatted and not compiled before and after, which takes long [bytes]."""
_TASKS = (
    *(path.read_bytes() for path in sorted(_ROOT.glob("examples/*/programs/*.task"))),
    _ON_FIXTURE,
    _ON_THE_WAY,
)
_VALUES = (
    *(b"nan", b"-inf", b"1e308", b"0xffffffffffffffffff", b'"text"', b"[]", b"{}", b"true", b"[[1]]"),
    *(b"1979-05-27", b"-1", b"0", b"[1, 2]", b"[1, 2, 3]", b"[nan, 0, 1e308]", b'""', b"{ a = 1 }"),
)
_BUDGET = 1_000  # instructions
_SHOWN = 5  # findings that are written out


def _check(findings: tuple[Diagnostic, ...], source: SourceText) -> str:
    """Show findings as the terminal does; each must stand inside of its text."""
    assert isinstance(diagnostics_text(findings[:_SHOWN], {source.name: source}, Style.PLAIN), str)
    for found in findings:
        if found.span is not None:
            assert 1 <= found.span.line <= len(source.lines)
            assert 1 <= found.span.column <= len(source.line(found.span.line)) + 1
    wrong = [found.code for found in findings if found.is_error]
    return wrong[0] if wrong else "read"


def _cell(content: bytes) -> str:
    source = SourceText("cell.toml", content.decode("utf-8", errors="replace"))
    cell, findings = read_cell(source, "folder")
    answer = _check(findings, source)
    assert (cell is None) == (answer != "read")
    if cell is not None:
        environment_of(cell)
        json.dumps(numeric(scene(cell)), allow_nan=False)
    return answer


def _robot(content: bytes) -> str:
    source = SourceText("robots/arm.toml", content.decode("utf-8", errors="replace"))
    read = read_robot_file(source)
    answer = _check(read.findings, source)
    assert (read.robot is None) == (answer != "read")
    if read.robot is not None:
        _check(audit(read.robot, robot_file_places(source)), source)
        assert np.isfinite(kinematics.forward(read.robot, read.robot.home).matrix()).all()
        check_model(read.robot)
        again = read_robot_file(SourceText("robots/again.toml", write_robot_file(read.robot).text))
        assert again.robot is not None, again.findings
        cell = one_station("c", read.robot, robots.default_controller(replace(read.robot, drives=())))
        json.dumps(numeric(scene(cell)), allow_nan=False)
    return answer


def _icr(content: bytes) -> str:
    source = SourceText("a.icr", content.decode("utf-8", errors="replace"))
    code, findings = icr.read_text(source.text, source.name)
    if code is None:
        return _check(findings, source)
    findings = (*findings, *icr.verify(code))
    answer = _check(findings, source)
    if answer == "read":
        icr.run(code, budget=_BUDGET)
        assert icr.read_text(icr.disassemble(code))[0] == code
    return answer


def _task(content: bytes) -> str:
    source = SourceText("main.task", content.decode("utf-8", errors="replace"))
    return _check(language.compile(source.text, _everything(), source.name).diagnostics, source)


def _form(content: bytes) -> str:
    text = content.decode("utf-8", errors="replace")
    form = language.formatted(text)
    assert language.formatted(form) == form
    if len(content) > _COMPARED:
        return "large"
    before, after = (language.compile(one, _everything(), "main.task") for one in (text, form))
    codes, formed = ([one.code for one in found.diagnostics] for found in (before, after))
    assert codes == formed
    if before.icr is None or after.icr is None:
        return before.diagnostics[0].code if before.diagnostics else "read"
    assert icr.program_id(before.icr) == icr.program_id(after.icr)
    return "read"


@cache
def _everything() -> language.Environment:
    """Return an environment with all names of the cells, so that the programs are right."""
    texts = (*(path.read_text("utf-8") for path in _CELL_FILES), AXES)
    every = [read_cell(SourceText("cell.toml", text), "")[0] for text in texts]
    found = [environment_of(cell, at) for cell in every if cell for at in cell.stations.values()]
    return replace(
        found[0],
        frames={name: pose for one in found for name, pose in one.frames.items()},
        tools={name: pose for one in found for name, pose in one.tools.items()},
        locations={name: pose for one in found for name, pose in one.locations.items()},
        signals={name: use for one in found for name, use in one.signals.items()},
        axes=max((one.axes for one in found), key=len),
        external=max((one.external for one in found), key=len),
        moving=frozenset(name for one in found for name in one.moving),
        located={name: frame for one in found for name, frame in one.located.items()},
    )


def _made_toml(seeds: tuple[bytes, ...], random: Random) -> bytes:
    """Return a TOML file with damaged text, or one with other values behind its keys."""
    if random.random() < 0.4:
        return _made(seeds, random)
    lines = random.choice(seeds).split(b"\n")
    places = [k for k, line in enumerate(lines) if b" = " in line]
    for place in random.sample(places, random.choice((1, 1, 2, 3))):
        key, _, value = lines[place].partition(b" = ")
        other = lines[random.choice(places)].partition(b" = ")[2]
        changed = random.choice(
            (other, random.choice(_VALUES), mutated(random, value, (numeral, word, nest)))
        )
        lines[place] = key + b" = " + changed
    return b"\n".join(lines)


def _made(seeds: tuple[bytes, ...], random: Random) -> bytes:
    return mutated(random, random.choice(seeds), TEXT)


TARGETS = (
    Target("cell", lambda random: _made_toml(_CELLS, random), _cell),
    Target("robot", lambda random: _made_toml(ARMS, random), _robot),
    Target("icr", lambda random: _made(_ICRS, random), _icr),
    Target("task", lambda random: _made(_TASKS, random), _task),
    Target("form", lambda random: _made(_TASKS, random), _form),
)
