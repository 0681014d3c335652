"""Expressions of xacro: Python's values for Python's grammar; nothing else is called, and nothing grows."""

import math

import pytest

from ropsim.exchange.testing import Scope, Value, XacroError, literal, text_of, truth, value_of
from support.xacro_files import LooseFile

NAMES: dict[str, Value] = {"a": 2, "b": 0.5, "s": "left", "l": [1, [2, 3]], "d": {"x": 1.5, "deep": {"y": 2}}}


def scope() -> Scope:
    made = Scope(LooseFile())
    for name, value in NAMES.items():
        made.give(name, value)
    return made


SAME_AS_PYTHON = [
    "1 + 2*3 - 4/8",
    "-2**2",
    "2**-1",
    "2**3**2",
    "7 // 2 + 7 % 4 - -3",
    "(a + b) * -(a - 1)",
    "1 < a < 3",
    "1 < a > 3",
    "a == 2 and not b > 1 or s == 'right'",
    "not not a",
    "1 if s == 'left' else 1/0",
    "0 and 1/0",
    "a or 1/0",
    "l[1][0] + l[-2] + len(l)",
    "d['deep']['y']",
    "'le' + \"ft\" == s",
    "'ef' in s and 5 not in l",
    "min(3, a, 1.5) + max(0, b) + abs(-2)",
    "sum([1, 2, 3]) + sorted([3, 1])[0]",
    "round(2.71828, 2) + int('7') + float('.5')",
    "str(a) + 'x'",
    "{'k': 1}['k']",
    "1e-3 + .5 + 3.",
    "range(3)[2]",
    "dict(x=1, y=a + 1)['y']",
    "d.get('x', 0) + d.get('none', 7)",
    "d.get('none') == None",
    "(1, 2)[1]",
    "True and False",
    "'a,b;c'.split(',')",
    "'a b'.split() + ' x '.strip().split('y')",
    "'left_arm'.startswith('left') and s.endswith(('ft', 'x'))",
    "'Left'.lower() + s.upper() + s.replace('ef', 'oo') + '-'.join(['a', 'b'])",
    "'%s_%02d %.3f%%' % (s, 7, 0.5)",
    "'joint_%d' % a",
    "'..x'.lstrip('.') + 'x..'.rstrip('.') + 'a_b_c'.rsplit('_', 1)[0]",
    "s[1:3] + s[:-1] + s[::-1] + s[-2:]",
    "l[1:] + [0, 1, 2, 3][::2] + l[:1]",
    "(1, 2, 3)[1:]",
    "2 * 'ab' + 'c' * a",
    "[0] * 3 + 2 * [1]",
    "[2 * x for x in [1, 2, 3] if x != 2]",
    "[x + y for x in [1, 2] for y in [10, 20] if x < 2]",
    "[k + str(v) for k, v in dict(x=1, y=2).items()]",
    "sum(x * x for x in range(4))",
    "list(map(float, '1 2.5'.split()))",
    "[int(x) for x in '1;2'.split(';')]",
    "sorted([3, 1, 2], reverse=True) + list((1, 2))",
    "max([1, 5, 3]) if any([False, True]) else all([])",
    "[k for k in dict(x=1, y=2).keys()] + list(dict(z=3))",
    "'ab' 'cd' + \"e'f\" + 'g\\'h' + u'i'",
    "None is None and a is not None",
    "5 & 3 | 8 ^ 2",
    "1 << 4 >> 1",
    "'x' not in 'abc' and 'k' in dict(k=1)",
    "divmod(7, 2)",
    "list(zip([1, 2], 'ab')) + list(enumerate('x'))",
    "()",
]


@pytest.mark.parametrize("text", SAME_AS_PYTHON)
def test_values_are_those_of_python(text: str) -> None:
    expected = eval(text, {"__builtins__": {n: getattr(__import__("builtins"), n) for n in _BUILTINS}}, NAMES)
    found = value_of(text, scope())
    assert found == expected
    assert type(found) is type(expected)


_BUILTINS = (
    "min",
    "max",
    "abs",
    "sum",
    "sorted",
    "round",
    "int",
    "float",
    "str",
    "range",
    "len",
    "dict",
    "list",
    "map",
    "zip",
    "enumerate",
    "any",
    "all",
    "divmod",
)


@pytest.mark.parametrize(
    ("text", "value"),
    [
        ("sin(pi/2) + cos(0)", 2.0),
        ("math.pi", math.pi),
        ("math.radians(180)", math.pi),
        ("degrees(atan2(1, 1))", 45.0),
        ("d.x + d.deep.y", 3.5),
        ("sqrt(2)**2", 2.0),
    ],
)
def test_mathematics_is_at_hand(text: str, value: float) -> None:
    assert value_of(text, scope()) == pytest.approx(value)


REFUSED = [
    "__import__('os').system('true')",
    "open('/etc/hostname')",
    "eval('1')",
    "().__class__",
    "d.pop('x')",
    "l.append(3)",
    "dict(1)",
    "s.get('x')",
    "a.__class__",
    "'{0.__class__}'.format(a)",
    "s.upper",
    "lambda: 1",
    "s % 3",
    "'a' * 10**9",
    "[0] * 10**9",
    "'%2000d' % 1",
    "'%*d' % (2000, 1)",
    "'%s'.replace('', 'x' * 15000)",
    "'x'.ljust(10**9)",
    "('x' * 15000).join(['a', 'b', 'c'])",
    "1 << 10**9",
    "l[0:1:0]",
    "l['x':]",
    "a[0:1]",
    "[x for x in 5]",
    "[x for x, y in [[1]]]",
    "[" + "[x for x in range(2000)] " + "for y in range(2000)]",
    "[1 for x in range(2000) for y in range(2000) for z in range(2000) if False]",
    "list(map(range, [2000] * 1500))",
    "map(5, [1])",
    "xacro.system('true')",
    "xacro.fatal('no', 'arm')",
    "xacro.arg('none')",
    "python.open('x')",
    "math.os",
    "b'bytes'",
    "'\\x41'",
    "l" + "[0]" * 1300,
    "unknown",
    "1 +",
    "(1",
    "[1, 2",
    "1 2",
    "a = 3",
    "f'{a}'",
    "1/0",
    "(-1)**0.5",
    "sqrt(-1)",
    "10.0**400",
    "float('nan')",
    "l[7]",
    "d['none']",
    "sin()",
    "x" * 5000,
    "9" * 400,
    "(" * 100 + "1" + ")" * 100,
    "2**" * 100 + "2",
    "range(10**9)",
    "[" + "0," * 1500 + "[" + "0," * 400,
    "round(5, -10**9) + 'a'",
    "@",
]


@pytest.mark.parametrize("text", REFUSED)
def test_everything_else_is_refused(text: str) -> None:
    with pytest.raises(XacroError):
        value_of(text, scope())


def test_signs_and_powers_do_not_grow_without_bound() -> None:
    assert value_of("-" * 900 + "1", scope()) == 1
    big = value_of("10**200", scope())
    assert isinstance(big, float)
    assert value_of("10**18 * 10", scope()) == 1e19


@pytest.mark.parametrize(
    ("text", "value"),
    [
        ("1", 1),
        ("-1.5", -1.5),
        ("true", True),
        ("False", False),
        ("'1'", "1"),
        ("1_0", "1_0"),
        ("x", "x"),
        ("", ""),
    ],
)
def test_texts_stand_for_what_they_look_like(text: str, value: Value) -> None:
    assert literal(text) == value
    assert type(literal(text)) is type(value)


def test_functions_of_xacro_are_at_hand() -> None:
    made = scope()
    assert value_of("xacro.tokenize('a, b;c')", made) == ["a", "b", "c"]
    assert value_of("xacro.tokenize('a,,b', sep=',', skip_empty=False)", made) == ["a", "", "b"]
    assert value_of("xacro.dotify(dict(a=1)).a + int(xacro.arg('count'))", made) == 4
    assert value_of("xacro.abs_filename('x.yaml')", made) == "urdf/x.yaml"
    assert value_of("xacro.warning('no', 1) + xacro.message('quiet')", made) == ""
    assert isinstance(made.file, LooseFile)
    assert made.file.messages == ["no 1"]


@pytest.mark.parametrize(
    ("construct", "text"),
    [
        ("`lambda`", "map(lambda x: x, [1])"),
        ("method `pop`", "d.pop('x')"),
        ("method `format`", "'{}'.format(1)"),
        ("`xacro.system`", "xacro.system('true')"),
        ("`python.open`", "python.open('x')"),
        ("`f` before it", "f'{a}'"),
        ("`open` cannot be called", "open('x')"),
        ("no key `none`", "d.none"),
    ],
)
def test_a_refusal_names_the_construct(construct: str, text: str) -> None:
    with pytest.raises(XacroError, match=construct):
        value_of(text, scope())


@pytest.mark.parametrize(
    ("text", "made"),
    [
        ("${1.0} ${2} ${1 == 1} ${[1, 'a']} ${(1, 2)}", "1.0 2 True [1, 'a'] (1, 2)"),
        ("$(arg side)_$(arg ${'co' + 'unt'}) ${2 * '$(arg side)'}", "left_3 leftleft"),
        ("$(eval count + 1) $(eval arg('side')) $(eval side == 'left')", "4 left True"),
        ("$(optenv HOME none) $(optenv HOME)", "none "),
        ("$(find arm)/urdf $(dirname)/x", "package://arm/urdf urdf/x"),
        ("$ $x $${y} $$(z) $$${w}", "$ $x ${y} $(z) $${w}"),
    ],
)
def test_texts_are_printed_as_the_official_tool_prints_them(text: str, made: str) -> None:
    assert text_of(text, scope()) == made


@pytest.mark.parametrize("command", ["env", "anon", "cwd", "sh"])
def test_a_command_that_is_not_carried_out_is_named(command: str) -> None:
    with pytest.raises(XacroError, match=rf"\$\({command} \.\.\.\)"):
        text_of(f"$({command} HOME)", scope())


def test_conditions_are_true_false_or_numbers() -> None:
    assert [truth(one) for one in ("true", "False", "1", 0, 0.0, True)] == [
        True,
        False,
        True,
        False,
        False,
        True,
    ]
    with pytest.raises(XacroError):
        truth("perhaps")
