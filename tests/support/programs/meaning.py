"""A program object carried out as the manual says: statement by statement, without compiler and machine."""

from collections.abc import Mapping
from dataclasses import dataclass, field, replace

from support.programs import places
from support.programs.grids import cells
from support.programs.nodes import Expr, Program, Stmt, Task
from support.programs.numbers import TrapError, shown
from support.programs.places import ARM, FRAMES, Place
from support.programs.values import AXES, Datum, Scope, TooLongError, Values

STEPS = 3_000


class _BreakError(Exception):
    pass


class _ContinueError(Exception):
    pass


class _StopError(Exception):
    pass


class _ReturnError(Exception):
    pass


@dataclass(frozen=True, slots=True)
class Sent:
    """Where the arm was sent, with the speed in force [m/s], None for that of the cell, and the zone [m].

    Joint coordinates and home are there as they are written.
    """

    place: Place | str
    speed: float | None
    zone: float


@dataclass(slots=True)
class Run:
    """What has happened so far: what was said, where the arm was sent, how it ended."""

    says: list[str] = field(default_factory=list)
    moves: list[Sent] = field(default_factory=list)
    trap: tuple[str, int] | None = None
    values: dict[str, Datum] = field(default_factory=dict)


def carried_out(program: Program, inputs: Mapping[str, bool]) -> Run:
    """Return what a program does.

    Raises:
        TooLongError: it does not come to its end.
    """
    return _Meaning(program, inputs).run()


class _Meaning(Values):
    def __init__(self, program: Program, inputs: Mapping[str, bool]) -> None:
        super().__init__(inputs)
        self.program, self.done, self.line, self.steps = program, Run(), 0, 0
        self.tasks = {task.name: task for task in program.tasks}
        self.patterns = {pattern.name: pattern for pattern in program.patterns}
        self.result: Datum | None = None
        self.settings: dict[str, float | None] = {"speed": None, "blend": 0.0}

    def run(self) -> Run:
        main = Scope(self.shared)
        try:
            for name, first in self.program.shared.items():
                self.shared[name] = self.value(main, first)
            self.block(main, self.program.main)
        except TrapError as trap:
            self.done.trap = (str(trap), self.line)
        except _StopError:
            pass
        self.done.values = dict(self.shared)
        return self.done

    # --- statements

    def block(self, scope: Scope, block: list[Stmt]) -> None:
        """Carry out statements; a `set frame` among them holds to their end."""
        before = scope.frame
        try:
            self.each(scope, block)
        finally:
            scope.frame = before

    def each(self, scope: Scope, block: list[Stmt]) -> None:
        for one in block:
            self.steps += 1
            if self.steps > STEPS:
                raise TooLongError
            self.line = one.line
            getattr(self, "do_" + one.op.replace(" ", "_"))(scope, one)

    def do_assign(self, scope: Scope, one: Stmt) -> None:
        self.store(scope, one.name, self.value(scope, one.parts[0]))

    def do_component(self, scope: Scope, one: Stmt) -> None:
        number = float(self.number(scope, one.parts[0]))
        before = self.place(scope, Expr("name", "loc", text=one.name))
        numbers = places.seen(before, scope.frame)
        at = [number if k == AXES[one.names[0]] else old for k, old in enumerate(numbers.at)]
        changed = places.read_in(replace(numbers, at=(at[0], at[1], at[2])), scope.frame)
        self.store(scope, one.name, replace(changed, axes=before.axes))

    def do_load(self, scope: Scope, one: Stmt) -> None:
        numbers = places.seen(self.place(scope, one.parts[0]), scope.frame)
        for name, number in zip(one.names, numbers.at, strict=True):
            self.store(scope, name, number)

    def do_call(self, scope: Scope, one: Stmt) -> None:
        self.result = None
        task = self.tasks[one.name]
        inner = Scope(self.arguments(scope, task, one))
        try:
            self.block(inner, task.body)
        except _ReturnError:
            return

    def do_plain_call(self, scope: Scope, one: Stmt) -> None:
        self.do_call(scope, one)

    def do_result(self, scope: Scope, one: Stmt) -> None:
        self.do_call(scope, one)
        assert self.result is not None
        self.store(scope, one.names[-1], self.result)

    def arguments(self, scope: Scope, task: Task, one: Stmt) -> dict[str, Datum]:
        by_place = iter(task.parameters)
        given = {name or next(by_place).name: part for name, part in zip(one.names, one.parts, strict=False)}
        found: dict[str, Datum] = {}
        for parameter in task.parameters:
            chosen = given.get(parameter.name, parameter.default)
            assert chosen is not None
            found[parameter.name] = _as(parameter.kind, self.value(scope, chosen))
        return found

    def do_return(self, scope: Scope, one: Stmt) -> None:
        self.result = self.value(scope, one.parts[0]) if one.parts else None
        raise _ReturnError

    def do_print(self, scope: Scope, one: Stmt) -> None:
        self.done.says.append(" ".join(shown(self.number(scope, part)) for part in one.parts))

    def do_lin(self, scope: Scope, one: Stmt) -> None:
        self.here = self.place(scope, one.parts[0])
        self.send(self.here)

    def send(self, place: Place | str) -> None:
        self.done.moves.append(Sent(place, self.settings["speed"], self.settings["blend"] or 0.0))

    def do_setting(self, scope: Scope, one: Stmt) -> None:
        self.settings[one.name] = float(self.number(scope, one.parts[0]))

    def do_loc(self, scope: Scope, one: Stmt) -> None:
        self.fixed[one.name] = self.place(scope, one.parts[0])

    def do_then(self, scope: Scope, one: Stmt) -> None:
        if self.number(scope, one.parts[0]):
            self.block(scope, one.blocks[0])

    def do_wait(self, scope: Scope, one: Stmt) -> None:
        if self.number(scope, one.parts[0]):
            return
        if not one.blocks:
            raise TrapError("I462")
        self.block(scope, one.blocks[0])

    def do_mov(self, _scope: Scope, one: Stmt) -> None:
        self.here = ARM[one.name]
        self.send(one.name)

    def do_when(self, scope: Scope, one: Stmt) -> None:
        if self.number(scope, one.parts[0]):
            raise _BreakError if one.name == "break" else _ContinueError

    def do_if(self, scope: Scope, one: Stmt) -> None:
        for condition, block, line in zip(one.parts, one.blocks, one.lines, strict=False):
            self.line = line
            if self.number(scope, condition):
                self.block(scope, block)
                return
        if len(one.blocks) > len(one.parts):
            self.block(scope, one.blocks[-1])

    def do_set(self, scope: Scope, one: Stmt) -> None:
        scope.frame = FRAMES[one.name]

    def do_stop(self, _scope: Scope, _one: Stmt) -> None:
        raise _StopError

    def do_with(self, scope: Scope, one: Stmt) -> None:
        """Carry out a block; all settings are then what they were, however it ends."""
        before = dict(self.settings)
        values = [float(self.number(scope, part)) for part in one.parts]
        self.settings.update(zip(one.names, values, strict=True))
        frame = [Stmt("set", one.name, line=one.line)] if one.name else []
        try:
            self.block(scope, [*frame, *one.blocks[0]])
        finally:
            self.settings = before

    # --- loops

    def passed(self, scope: Scope, one: Stmt) -> bool:
        """Carry out one pass of a loop and return whether it may go on."""
        try:
            self.block(scope, one.blocks[0])
        except _ContinueError:
            pass
        except _BreakError:
            return False
        self.line = one.lines[-1]
        return True

    def do_while(self, scope: Scope, one: Stmt) -> None:
        while self.number(scope, one.parts[0]) and self.passed(scope, one):
            pass

    def do_repeat(self, scope: Scope, one: Stmt) -> None:
        for _ in range(int(self.number(scope, one.parts[0]))):
            if not self.passed(scope, one) or (one.op == "until" and self.number(scope, one.parts[1])):
                return

    do_until = do_repeat

    def do_for(self, scope: Scope, one: Stmt) -> None:
        first, last, step = (self.number(scope, part) for part in one.parts)
        is_own = one.name in scope.counting or one.name not in {**self.shared, **scope.own}
        scope.loops.append({one.name: first} if is_own else {})
        scope.counting.append(one.name)
        passes = int((last - first) / step + 1e-9) + 1 if (last - first) * step >= 0 else 0
        for number in range(passes):
            self.store(scope, one.name, first + number * step)
            if not self.passed(scope, one):
                break
        scope.loops.pop()
        scope.counting.pop()

    def do_each(self, scope: Scope, one: Stmt) -> None:
        scope.loops.append({})
        for place, cell in cells(self.patterns[one.names[0]]):
            scope.loops[-1].update({one.name: place, **{f"{one.name}.{k}": v for k, v in cell.items()}})
            if not self.passed(scope, one):
                break
        scope.loops.pop()


def _as(kind: str, value: Datum) -> Datum:
    return float(value) if kind not in ("int", "bool", "loc") and not isinstance(value, Place) else value
