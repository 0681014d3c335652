"""Random task programs as keys that a person presses, and the text that a plain editor has then.

That editor indents each line by its block: a program is made of its blocks, so that the depth of each line is
known without reading any text. What is typed has no leading blanks; wrong letters are taken back, lists of
completions are opened, walked through, left with Escape or ignored.
"""

import random
from collections.abc import Sequence
from dataclasses import dataclass, field

UNIT = "  "
"""What a line is deeper by in each block."""
CHOSEN = "\0"
"""Stands in a line for what is taken from a list."""
KEY_TIMES = 0.04, 0.4
"""Between two keys [s]; each power of ten as often as another."""
BREATHS = 0.0, 2.0
"""Before Enter [s]."""
GLIMPSE = 0.3, 1.2
"""Before an arrow key in a list: it has been seen [s]."""
DEEPEST = 3
PLAIN = (
    "wait 1 s",
    "wait 250 ms",
    "mov home",
    "mov pick_up above 60 mm",
    "lin set_down speed 150 mm/s",
    "lin pick_up",
    "lin pick_up free blend 5 mm",
    "speed 20 %",
    "open",
    "close",
    "n = 3",
    "ending = 3",
    "elsewhere = (1 + n) * 4",
    "const depth = 40 mm",
    "const p1 = 3",
    "loc above_box = pick_up + (0, 0, 40)",
    "mov (500, 0, 600; rpy 0 180 0)",
    "Carry pick_up, set_down",
    "if n > 3 then mov home",
    'print "half (done", n',
    "set lamp on  # or off",
    '# 5" wide ( and open',
    "// units are mm, deg, s",
    # words that mean nothing
    "movv home",
    "lin nowhere",
    "wiat 3 s",
    "hoem",
    "",
)
HEADS: Sequence[tuple[str, Sequence[str], Sequence[str]]] = (
    ("repeat 3", ("endr", "end", "until n > 3"), ()),
    ("while n < 4 do", ("endw", "end"), ()),
    ("for i = 1 to 3", ("endf", "end"), ()),
    ("if n > 3 then", ("endif", "end"), ("elseif n > 2 then", "else")),
    ("if lamp then  # only so", ("endif",), ("else",)),
    ("with speed 100 mm/s", ("endwith", "end"), ()),
)
"""Heads of blocks, the words that close them, and those that divide them."""


@dataclass(frozen=True)
class Key:
    """A key as the browser names it, pressed after a while [s]."""

    name: str
    wait: float


@dataclass(frozen=True)
class Choice:
    """An entry of a list, taken with the arrow and Enter; where there is none the rest of the name is typed.

    Attributes:
        written: the beginning of the name, typed before.
        rest: of the name.
        wait: until the list has been seen [s].
    """

    written: str
    rest: str
    wait: float


Act = Key | Choice


@dataclass(frozen=True)
class TypedProgram:
    """A program and how it is typed.

    Attributes:
        seed: its number.
        lines: as they are to stand, with `CHOSEN` for what is taken from lists.
        acts: in order.
    """

    seed: int
    lines: tuple[str, ...]
    acts: tuple[Act, ...]

    def text(self, taken: Sequence[str]) -> str:
        """Return the text with what was taken from lists, in order."""
        first, *rest = "\n".join(self.lines).split(CHOSEN)
        return first + "".join(name + part for name, part in zip(taken, rest, strict=True))


def typed_program(seed: int, fewest: int, most: int) -> TypedProgram:
    """Return the program of a number, which has between `fewest` and `most` lines."""
    source = random.Random(seed)
    lines: list[str] = []
    while not fewest <= len(lines) <= most:
        lines = _Writer(source, most).program()
    hand = _Hand(source)
    for number, line in enumerate(lines):
        if number:
            hand.enter()
        hand.line(line)
    return TypedProgram(seed, tuple(lines), tuple(hand.acts))


@dataclass
class _Writer:
    """Makes the lines of a program, each as deep as its block."""

    source: random.Random
    most: int
    lines: list[str] = field(default_factory=list)

    def program(self) -> list[str]:
        """Return the lines."""
        if self.source.random() < 0.5:
            self.put(0, "program typed")
            self.put(0, "units mm, deg, s")
        if self.source.random() < 0.4:
            self.put(
                0, self.source.choice(("task Fetch(a: loc)", "task T1", "task Go(place: loc, far: length)"))
            )
            self.block(1)
            self.put(0, self.source.choice(("endp", "endtask", "end")))
        self.block(0)
        if len(self.lines) < self.most:
            self.put(0, self.source.choice(("stop", "mov home", f"mov {CHOSEN}")))
        return self.lines

    def put(self, depth: int, text: str) -> None:
        """Write a line; one without a word stays empty."""
        self.lines.append(depth * UNIT + text if text else "")

    def block(self, depth: int) -> None:
        """Write some statements."""
        for _ in range(self.source.randint(1, 3)):
            kind = self.source.random()
            room = self.most - len(self.lines)
            if kind < 0.35 and depth <= DEEPEST and room > 2:
                self.nested(depth)
            elif kind < 0.42:
                self.put(depth, "mov (500, 200,")
                self.put(depth, "     600)")
            elif kind < 0.47:
                self.put(depth, "total = one + \\")
                self.put(depth + 1, "two")
            elif kind < 0.6:
                self.put(depth, self.source.choice(("mov", "lin")) + f" {CHOSEN}")
            else:
                self.put(depth, self.source.choice(PLAIN))

    def nested(self, depth: int) -> None:
        """Write a block with its head and end."""
        head, closers, dividers = self.source.choice(HEADS)
        self.put(depth, head)
        self.block(depth + 1)
        for divider in dividers:
            if self.source.random() < 0.4:
                self.put(depth, divider)
                self.block(depth + 1)
        self.put(depth, self.source.choice(closers))


@dataclass
class _Hand:
    """Makes the keys of lines."""

    source: random.Random
    acts: list[Act] = field(default_factory=list)

    def press(self, name: str) -> None:
        """Press a key after the time that a finger takes."""
        low, high = KEY_TIMES
        self.acts.append(Key(name, low * (high / low) ** self.source.random()))

    def enter(self) -> None:
        """Break the line after a breath; a list that is open then is to be left alone."""
        self.acts.append(Key("Enter", self.source.uniform(*BREATHS)))

    def line(self, line: str) -> None:
        """Type a line without its leading blanks."""
        text = line.strip()
        before, taken, behind = text.partition(CHOSEN)
        if taken:
            written, rest = self.source.choice((("pic", "k_up"), ("set_d", "own"), ("hom", "e")))
            self.word(before + written)
            self.acts.append(Choice(written, rest, self.source.uniform(*GLIMPSE)))
            self.word(behind)
        else:
            self.word(text)

    def word(self, text: str) -> None:
        """Type some signs, now and then wrong ones that are taken back, or with a look at a list."""
        for at, sign in enumerate(text):
            fate = self.source.random()
            if fate < 0.03:
                self.mistake(self.source.choice("esx"))
            elif fate < 0.04 and text[at + 1 : at + 2].isalpha():
                self.mistake(text[at + 1] + sign)  # the wrong way round
            self.press(sign)
            if sign.isalpha() and _is_plain(text[:at]):
                self.look(self.source.random(), is_last=at == len(text) - 1)

    def mistake(self, wrong: str) -> None:
        """Type what does not belong here, and take it back."""
        for sign in wrong:
            self.press(sign)
        for _ in wrong:
            self.press("Backspace")

    def look(self, fate: float, *, is_last: bool) -> None:
        """Sometimes ask for a list, walk in it or close it, and type on."""
        if fate < 0.015:
            self.press("Control+Space")
        elif fate < 0.03:
            self.press("Escape")
        elif fate < 0.05:
            self.press("ArrowDown")
            self.press("Escape")
        elif fate < 0.055:
            for name in ("Control+Space", "ArrowDown", "ArrowDown", "Escape"):
                self.press(name)
        elif fate < 0.07 and not is_last:
            self.press("ArrowDown")  # given up by the next letter


def _is_plain(text: str) -> bool:
    """Return whether no bracket or quote is open, which an editor would have closed behind the cursor."""
    return not any(sign in text for sign in '(["')
