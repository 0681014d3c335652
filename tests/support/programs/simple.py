"""Statements of one line at random."""

from collections.abc import Callable
from random import Random

from support.programs.expressions import Sight, literal, made, written_place
from support.programs.nodes import PLACE, Expr, Program, Stmt
from support.programs.numbers import MM
from support.programs.places import ARM

FRAMES = ("base", "pallet", "shelf", "tilted")
Maker = Callable[[Sight], list[Stmt]]


class Simple:
    """Makes statements over the names in sight.

    Attributes:
        random: where all choices come from.
        made: the program so far; its tasks can be called.
        count: names given so far.
    """

    def __init__(self, random: Random) -> None:
        self.random = random
        self.made = Program()
        self.count = 0

    def name(self, prefix: str) -> str:
        self.count += 1
        return f"{prefix}{self.count}"

    def assigned(self, sight: Sight) -> list[Stmt]:
        fixed = set(sight.counters)
        names = [n for n, kind in sight.names.items() if n not in fixed and not n.startswith("k")]
        if not names:
            return []
        name = self.random.choice(names)
        return [Stmt("assign", name, (made(self.random, sight, sight.names[name], 3),))]

    def component(self, sight: Sight) -> list[Stmt]:
        names = [name for name in sight.of("loc") if name not in sight.counters]
        if not names:
            return []
        value = made(self.random, sight, self.random.choice(("length", PLACE)), 2)
        return [Stmt("component", self.random.choice(names), (value,), names=(self.random.choice("xyz"),))]

    def loaded(self, sight: Sight) -> list[Stmt]:
        names = sight.of(PLACE)
        if len(names) < 3:
            return []
        chosen = tuple(self.random.sample(names, 3))
        return [Stmt("load", parts=(made(self.random, sight, "loc", 2),), names=chosen)]

    def told_one(self, sight: Sight) -> list[Stmt]:
        kinds = [self.random.choice(("int", "num", "bool")) for _ in range(self.random.randint(1, 3))]
        return [Stmt("print", parts=tuple(made(self.random, sight, kind, 3) for kind in kinds))]

    def told(self, sight: Sight) -> Stmt:
        names = [(n, kind) for n, kind in sight.names.items() if kind in ("int", "num", "bool")]
        parts = tuple(Expr("name", kind, text=n) for n, kind in names)
        return Stmt("print", parts=parts or (literal(self.random, "int"),))

    def moved(self, sight: Sight) -> list[Stmt]:
        if self.random.random() < 0.2:
            return [Stmt("mov", self.random.choice(tuple(ARM)))]
        return [Stmt("lin", parts=(made(self.random, sight, "loc", 3),))]

    def called(self, sight: Sight) -> list[Stmt]:
        if not self.made.tasks:
            return []
        random = self.random
        task = random.choice(self.made.tasks)
        names, parts, is_named = [], [], False
        for one in task.parameters:
            if one.default is not None and random.random() < 0.5:
                is_named = True
                continue
            is_named = is_named or random.random() < 0.2
            names.append(one.name if is_named else "")
            if one.kind == "loc" and sight.references and random.random() < 0.4:
                number = str(random.randint(1, sight.references))
                parts.append(Expr("reference", "loc", text=number))
            else:
                parts.append(made(random, sight, one.kind, 2))
        targets = [n for n in sight.of(task.result) if n not in sight.counters and not n.startswith("k")]
        if targets and random.random() < 0.8:
            return [Stmt("result", task.name, tuple(parts), names=(*names, random.choice(targets)))]
        is_plain = any(part.op == "reference" for part in parts)
        return [Stmt("plain call" if is_plain else "call", task.name, tuple(parts), names=tuple(names))]

    def frame_set(self, _: Sight) -> list[Stmt]:
        return [Stmt("set", self.random.choice(FRAMES))]

    def setting(self, _: Sight) -> list[Stmt]:
        return [self.setting_of(self.random.choice(("speed", "blend")))]

    def setting_of(self, word: str) -> Stmt:
        """Return `set speed` or `set blend` with a value of its own."""
        number, unit = self.random.randint(1, 99), "mm/s" if word == "speed" else "mm"
        return Stmt("setting", word, (Expr("literal", "length", text=f"{number} {unit}", value=number * MM),))

    def declared(self, sight: Sight) -> list[Stmt]:
        """Return a `loc` among the control statements, read in the frame in force there."""
        name = self.name("fixed")
        written = written_place(self.random)
        if self.random.random() < 0.3:
            written = Expr("in", "loc", (written,), text=self.random.choice(FRAMES))
        sight.constants.append(Expr("name", "loc", text=name))
        return [Stmt("loc", name, (written,))]

    def on_one_line(self, sight: Sight, around: tuple[str, ...], simple: list[Maker]) -> list[Stmt]:
        """Return a statement behind `then` or `else`, or a wait that may time out."""
        random = self.random
        condition = made(random, sight, "bool", 2)
        if random.random() < 0.1:
            return [Stmt("wait", parts=(condition,))]
        inner = [Stmt("return")] if around and around[1] == "" and around[0] else []
        inner = inner if random.random() < 0.2 else random.choice(simple)(sight)
        if not inner or (inner[0].blocks and inner[0].op not in ("then", "wait")):
            return []
        if random.random() < 0.2:
            inner = [Stmt("then", parts=(made(random, sight, "bool", 1),), blocks=(inner,))]
        return [Stmt(random.choice(("then", "then", "wait")), parts=(condition,), blocks=(inner,))]

    def way_out(self, sight: Sight, around: tuple[str, ...]) -> list[Stmt]:
        if "loop" in around:
            condition = made(self.random, sight, "bool", 2)
            return [Stmt("when", self.random.choice(("break", "continue")), (condition,))]
        result = around[1]
        value = (made(self.random, sight, result, 2),) if result else ()
        return [
            Stmt("if", parts=(made(self.random, sight, "bool", 2),), blocks=([Stmt("return", parts=value)],))
        ]
