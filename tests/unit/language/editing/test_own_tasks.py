"""The tasks of a text that is being edited are those of its outline, whatever was read before."""

from random import Random

import pytest

from ropsim.core import SourceText
from ropsim.language import LineCache, OwnTasks, outline

PIECES = (
    "task Reach(p: loc)",
    "task Grip",
    "3. task Reach",
    "TASK other(x, y)",
    "  lin p",
    "endp",
    "end",
    "if part_ok",
    "endif",
    "# task Hidden",
    'print "task"',
    "x = (1 +",
    "  task Inner)",
    "needs gripper open",
    "",
)


def told(text: str, cache: LineCache) -> dict[str, tuple[int, int]]:
    tasks = outline(SourceText("t", text), cache).tasks
    return {one.definition.name: (one.definition.span.line, one.span.end_line) for one in tasks}


@pytest.mark.parametrize("seed", range(20))
def test_after_any_edit_the_names_are_those_of_the_outline(seed: int) -> None:
    random, cache = Random(seed), LineCache()
    own, lines = OwnTasks(cache), [random.choice(PIECES) for _ in range(60)]
    for _ in range(30):
        place = random.randrange(len(lines))
        lines[place : place + random.randrange(3)] = [
            random.choice(PIECES) for _ in range(random.randrange(3))
        ]
        lines = lines or [""]
        text = "\n".join(lines)
        assert own.names(SourceText("t", text)) == frozenset(told(text, cache))


def test_tasks_lie_where_the_outline_has_them() -> None:
    cache = LineCache()
    body = "\n".join(f"# above {k}\ntask T{k}(p: loc)\n  lin p\n  x = {k}\nendp\nmov home" for k in range(50))
    source = SourceText("t", f"program p\n{body}\ntask Last\n  mov home\n")
    names = frozenset(("T3", "T40", "Last", "nobody"))
    found = OwnTasks(cache).spans(source, names)
    wanted = told(source.text, cache)
    assert {name: (span.line, span.end_line) for name, span in found.items()} == {
        name: wanted[name] for name in ("T3", "T40", "Last")
    }


def test_names_that_stay_are_the_same_object() -> None:
    own = OwnTasks(LineCache())
    first = own.names(SourceText("t", "task A\nendp\nmov home"))
    assert own.names(SourceText("t", "task A\nendp\nmov home\nmov home")) is first
