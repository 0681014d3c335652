"""Task programs at random: tasks with parameters and results, loops in loops, locations and frames."""

from random import Random

from support.programs.expressions import Sight, literal, made, place
from support.programs.nodes import KINDS, PLACE, Expr, Parameter, Pattern, Program, Stmt, Task
from support.programs.numbers import MM
from support.programs.simple import FRAMES, Simple

_NUMBERS = ("int", "num", "bool", "length")


def program(seed: int) -> Program:
    """Return program number `seed`, always the same."""
    return _Maker(Random(seed)).program()


def spoilt_program(seed: int) -> Program:
    """Return the same program; one in twenty has a line that takes the name of something declared."""
    return _Maker(Random(seed)).spoilt()


def _telling(one: Parameter) -> Stmt:
    """Return a statement whose use of a parameter tells its type."""
    read = Expr("name", one.kind, text=one.name)
    if one.kind == "loc":
        return Stmt("lin", parts=(read,))
    if one.kind == "length":
        return Stmt("lin", parts=(Expr("above", "loc", (Expr("name", "loc", text="infeed"), read)),))
    if one.kind == "bool":
        return Stmt("if", parts=(read,), blocks=([],))
    if one.kind == "int":
        count = Expr("min", "int", (read, Expr("literal", "int", text="2", value=2)))
        return Stmt("repeat", parts=(count,), blocks=([Stmt("print", parts=(read,))],))
    return Stmt("print", parts=(Expr("/", "num", (read, Expr("literal", "num", text="1.5", value=1.5))),))


class _Maker(Simple):
    def program(self) -> Program:
        random = self.random
        shared = {}
        for kind in _NUMBERS:
            if random.random() < 0.4:
                self.made.constants[self.name("c")] = literal(random, kind)
        for kind in KINDS:
            for _ in range(random.randint(0, 2)):
                name = self.name("g")
                shared[name] = kind
                self.made.shared[name] = place(random) if kind == "loc" else literal(random, kind)
        for _ in range(random.randint(0, 2)):
            self.made.patterns.append(self.pattern())
        for _ in range(random.randint(0, 2)):
            one = self.classic(shared) if random.random() < 0.25 else self.task(shared)
            self.made.tasks.append(one)
        sight = self.sight(shared)
        self.made.main = [*self.start(sight, "m"), *self.block(sight, 2, random.randint(1, 4), ())]
        self.made.main.append(self.told(sight))
        self.made.kinds = dict(sight.names)
        return self.made

    def spoilt(self) -> Program:
        made = self.program()
        if self.random.random() < 0.05:
            made.wrong = self.hiding()
        return made

    def hiding(self) -> tuple[str, str]:
        """Return a line that takes the name of something declared, and the code of its finding."""
        made, random = self.made, self.random
        of_text = ["shelf", "tilted", *made.constants]
        of_text += [*(one.name for one in made.patterns), *(one.name for one in made.tasks)]
        of_cell = ["pallet", "infeed", "part_ok", "jaws"]
        assigned = ("{} = 3", "load (x, {}, z), infeed", "lin infeed store {}", "if part_ok then {} = infeed")
        declared = ("var {}: int", "const {} = 3", "pattern {} = grid 2 from (0, 0, 0) step (1, 0, 0)")
        name = random.choice((*of_text, *of_cell))
        if random.random() < 0.5:
            return random.choice(assigned).format(name), "N207"
        if random.random() < 0.5:
            return f"task Hides({name}: int)\nendp", "N223"
        return random.choice(declared).format(name), "N206" if name in of_text else "N223"

    def sight(self, names: dict[str, str]) -> Sight:
        constants = self.made.constants.items()
        known = [Expr("literal", one.kind, text=name, value=one.value) for name, one in constants]
        return Sight(dict(names), known)

    def pattern(self) -> Pattern:
        random = self.random
        counts = tuple(random.randint(1, 3) for _ in range(random.randint(1, 3)))
        steps = tuple((10 * (k == 0), 20 * (k == 1) + k, 7 * (k == 2)) for k in range(len(counts)))
        first = (random.randint(0, 9), random.randint(0, 9), 40)
        order = random.choice(("row", "column", "snake"))
        return Pattern(self.name("pat"), counts, first, steps, order, random.choice(("", "shelf", "tilted")))

    def task(self, shared: dict[str, str]) -> Task:
        random = self.random
        parameters = []
        for _ in range(random.randint(0, 3)):
            kind = random.choice(KINDS)
            default = literal(random, kind) if kind != "loc" and random.random() < 0.3 else None
            parameters.append(Parameter(self.name("p"), kind, default))
        parameters.sort(key=lambda one: one.default is not None)
        sight = self.sight({**shared, **{one.name: one.kind for one in parameters}})
        return self.with_body(Task(self.name("Task"), tuple(parameters), random.choice(("", *KINDS))), sight)

    def with_body(self, task: Task, sight: Sight) -> Task:
        """Return a task with statements behind those that it has."""
        count = self.random.randint(1, 3)
        task.body += [*self.start(sight, "v"), *self.block(sight, 2, count, ("return", task.result))]
        if task.result:
            task.body.append(Stmt("return", parts=(made(self.random, sight, task.result, 2),)))
        return task

    def classic(self, shared: dict[str, str]) -> Task:
        """Return a task without parameter list: locations `l`, `l2`, then the names that it reads first."""
        random = self.random
        places = ["l", "l2", "l3"][: random.randint(0, 3)]
        scalars = {self.name("b"): random.choice(_NUMBERS) for _ in range(random.randint(0, 3))}
        parameters = [*(Parameter(name, "loc") for name in places)]
        parameters += [Parameter(name, scalars[name]) for name in sorted(scalars)]
        body = [_telling(one) for one in parameters]
        random.shuffle(body)
        sight = self.sight({**shared, **{one.name: one.kind for one in parameters}})
        sight.references = len(places)
        task = Task(self.name("Task"), tuple(parameters), random.choice(("", *KINDS)), body, is_classic=True)
        return self.with_body(task, sight)

    def start(self, sight: Sight, prefix: str) -> list[Stmt]:
        """Return first assignments of variables of a body, each of a type that nobody can doubt."""
        found = []
        infeed = Expr("name", "loc", text="infeed")
        firsts = [Expr("of", PLACE, (infeed,), text=axis) for axis in "xyz"]
        for kind in KINDS:
            names = sight.of(kind)
            if names and self.random.random() < 0.7:
                firsts.append(Expr("name", kind, text=names[0]))
        for first in firsts:
            name = self.name(prefix)
            found.append(Stmt("assign", name, (first,)))
            sight.names[name] = first.kind
        return found

    # --- statements

    def block(self, sight: Sight, depth: int, count: int, around: tuple[str, ...]) -> list[Stmt]:
        """Return statements; `around` says which ways out there are: loops, and the result of the task."""
        found: list[Stmt] = []
        for _ in range(count):
            found += self.statement(sight, depth, around)
        return found

    def statement(self, sight: Sight, depth: int, around: tuple[str, ...]) -> list[Stmt]:
        random = self.random
        simple = [
            self.assigned,
            self.assigned,
            self.told_one,
            self.moved,
            self.component,
            self.loaded,
            self.called,
        ]
        if depth > 0 and random.random() < 0.45:
            choices = (self.branch, self.counted, self.counting, self.waiting, self.through, self.framed)
            return random.choice(choices)(sight, depth - 1, around)
        if around and random.random() < 0.12:
            return self.way_out(sight, around)
        if random.random() < 0.01:
            return [Stmt("stop")]
        if random.random() < 0.05:
            return self.frame_set(sight)
        if depth == 2 and not around and random.random() < 0.1:
            return self.declared(sight)
        if random.random() < 0.12:
            return self.on_one_line(sight, around, [*simple, self.frame_set, self.setting])
        return random.choice((*simple, self.setting))(sight)

    # --- blocks

    def inner(self, sight: Sight, depth: int, around: tuple[str, ...], more: str = "") -> list[Stmt]:
        ways = (*around[:2], more) if more and "loop" not in around else around
        if more and not around:
            ways = ("", "", more)
        return self.block(sight, depth, self.random.randint(1, 3), ways)

    def branch(self, sight: Sight, depth: int, around: tuple[str, ...]) -> list[Stmt]:
        count = self.random.randint(1, 2)
        conditions = tuple(made(self.random, sight, "bool", 3) for _ in range(count))
        blocks = [self.inner(sight, depth, around) for _ in range(count + self.random.randint(0, 1))]
        return [Stmt("if", parts=conditions, blocks=tuple(blocks))]

    def counted(self, sight: Sight, depth: int, around: tuple[str, ...]) -> list[Stmt]:
        count = Expr(
            "min", "int", (made(self.random, sight, "int", 2), Expr("literal", "int", text="3", value=3))
        )
        body = self.inner(sight, depth, around, "loop")
        if self.random.random() < 0.4:
            return [Stmt("until", parts=(count, made(self.random, sight, "bool", 2)), blocks=(body,))]
        return [Stmt("repeat", parts=(count,), blocks=(body,))]

    def counting(self, sight: Sight, depth: int, around: tuple[str, ...]) -> list[Stmt]:
        random = self.random
        kind = random.choice(("int", "int", "num", "length"))
        steps = (1, 2, -1) if kind == "int" else (0.5, 0.25, -0.5)
        used = [name for name in sight.of(kind) if name[0] in "imgvp"]
        name = random.choice(used) if used and random.random() < 0.5 else self.name("i")
        step = random.choice(steps)
        first, last = random.sample((0, 1, 2, 3), 2)
        numbers = (first, last, step) if kind == "int" else (float(first), float(last), step)
        scale, unit = (MM, " mm") if kind == "length" else (1, "")
        low, high, written = (Expr("literal", kind, text=f"{n}{unit}", value=n * scale) for n in numbers)
        if kind == "int" and random.random() < 0.5:
            high = Expr("min", kind, (made(random, sight, kind, 2), high))
        before = dict(sight.names)
        sight.names[name] = kind
        body = self.inner(sight, depth, around, "loop")
        sight.names = before
        return [Stmt("for", name, (low, high, written), (body,))]

    def waiting(self, sight: Sight, depth: int, around: tuple[str, ...]) -> list[Stmt]:
        counter = self.name("k")
        wholes = sight.of("int")
        if not wholes:
            return []
        zero = Expr("-", "int", (Expr("name", "int", text=wholes[0]), Expr("name", "int", text=wholes[0])))
        read = Expr("name", "int", text=counter)
        one = Expr("literal", "int", text="1", value=1)
        limit = Expr("<", "bool", (read, Expr("literal", "int", text="3", value=3)))
        sight.names[counter] = "int"
        condition = Expr("and", "bool", (limit, made(self.random, sight, "bool", 2)))
        body = [
            Stmt("assign", counter, (Expr("+", "int", (read, one)),)),
            *self.inner(sight, depth, around, "loop"),
        ]
        del sight.names[counter]
        return [Stmt("assign", counter, (zero,)), Stmt("while", parts=(condition,), blocks=(body,))]

    def through(self, sight: Sight, depth: int, around: tuple[str, ...]) -> list[Stmt]:
        if not self.made.patterns:
            return []
        pattern = self.random.choice(self.made.patterns).name
        fresh = self.random.random() < 0.6 or not sight.counters
        name = self.name("s") if fresh else self.random.choice(sight.counters)
        before, counters = dict(sight.names), list(sight.counters)
        sight.names[name] = "loc"
        sight.counters = [*counters, name]
        body = self.inner(sight, depth, around, "loop")
        sight.names, sight.counters = before, counters
        return [Stmt("each", name, blocks=(body,), names=(pattern,))]

    def framed(self, sight: Sight, depth: int, around: tuple[str, ...]) -> list[Stmt]:
        """Return a `with` of a frame alone, of settings alone, or of both."""
        random = self.random
        settings = random.sample(("speed", "blend"), random.choice((0, 0, 1, 2)))
        parts = tuple(self.setting_of(one).parts[0] for one in settings)
        frame = random.choice(FRAMES) if not settings or random.random() < 0.5 else ""
        body = self.inner(sight, depth, around)
        return [Stmt("with", frame, parts, (body,), tuple(settings))]
