"""Elementary functions of eight numbers at a time.

Angles are taken off in multiples of π/2, whose first 99 bits stand in three numbers, and the remainder goes
into polynomials (Sun Microsystems 1993, fdlibm: k_sin.c, k_cos.c, e_rem_pio2.c); farther out than a million
the C library is called. The hyperbolic tangent is m/(m + 2) with m = exp(2·|x|) - 1, by powers of 2 and the
series of exp between them. The direction of (x, y) is a multiple of π/4 and an angle of less than π/8 on one
side of it, by the polynomial of s_atan.c there. Errors are below 3e-16 of sine and cosine, and of the tangent
as a share of it; of the direction below 4e-16 as a share. Exponential functions and powers, which few
formulas have, are those of the C library, lane by lane.
"""

import ast
from math import factorial

from llvmlite import ir

from ropsim.codegen.vector.instructions import LANES, VECTOR, LaneValues

_WHOLES = ir.VectorType(ir.IntType(64), LANES)
_FARTHEST = 1e6
"""Up to here multiples of the first two parts of π/2 are exact."""
_WHOLE = 6755399441055744.0
"""1.5·2⁵²: a number that it is added to and taken off from again is rounded to a whole one."""
_ANGLES = f"""\
b = x * 0.6366197723675814 + {_WHOLE}
k = b - {_WHOLE}
r = ((x - k * 1.57079632673412561417) - k * 6.07710050630396597660e-11) - k * 2.02226624871116645580e-21
z = r * r
u = 2.75573137070700676789e-06 + z * (z * 1.58969099521155010221e-10 - 2.50507602534068634195e-08)
u = 8.33333333332248946124e-03 + z * (z * u - 1.98412698298579493134e-04)
s = r + (z * r) * (z * u - 1.66666666666666324348e-01)
u = z * (2.08757232129817482790e-09 - z * 1.13596475577881948265e-11) - 2.75573143513906633035e-07
u = z * (2.48015872894767294178e-05 + z * u) - 1.38888888888741095749e-03
u = 4.16666666666666019037e-02 + z * u
c = 1.0 - (0.5 * z - (z * z) * u)
"""
"""Sine and cosine of the remainder, and in the last bits of b the number of right angles taken off."""
_SERIES = 13
_GROWTH = f"""\
y = min(2.0 * abs(x), 44.0)
k = (y * 1.4426950408889634 + {_WHOLE}) - {_WHOLE}
r = (y - k * 6.93147180369123816490e-01) - k * 1.90821492927058770002e-10
p = {1.0 / factorial(_SERIES)!r}
{"".join(f"p = p * r + {1.0 / factorial(order)!r}{chr(10)}" for order in range(_SERIES - 1, 1, -1))}
p = r + (r * r) * p
b = k + {_WHOLE + 1023.0}
"""
"""Of the tangent: powers of 2 and the series of exp, and the exponent of the power in the last bits of b."""
_STEEP = 0.41421356237309503
"""Tangent of π/8."""
_DIRECTION = f"""\
one = abs(x)
other = abs(y)
less = one if other > one else other
more = other if other > one else one
level = {_STEEP} * more
top = less - more if less > level else less
both = less + more
base = both if less > level else more
r = top / (1.0 if base == 0.0 else base)
z = r * r
w = z * z
u = -1.11111104054623557880e-01 + w * (-7.69187620504482999495e-02 + w * (-5.83357013379057348645e-02 + w * \
(-3.65315727442169155270e-02)))
v = 9.09088713343650656196e-02 + w * (6.66107313738753120669e-02 + w * (4.97687799461593236017e-02 + w * \
1.62858201153657823623e-02))
u = -1.99999999998764832476e-01 + w * u
v = 3.33333333333329318027e-01 + w * (1.42857142725034663711e-01 + w * v)
off = r - r * (z * v + w * u)
k = 1.0 if less > level else 0.0
k = 2.0 - k if other > one else k
side = -1.0 if other > one else 1.0
k = 4.0 - k if x < 0.0 else k
side = -side if x < 0.0 else side
found = k * 0.78539816336706280708 + (k * 3.03855025325309630e-11 + side * off)
"""
"""One of 33 bits, of which multiples are exact, and the rest of π/4."""


def sine_and_cosine(module: ir.Module) -> ir.Function:
    """Return sine and cosine of a vector of angles in a module; they are written where they are not yet."""
    symbol = "lanes.sine_and_cosine"
    known = module.globals.get(symbol)
    if known is not None:
        return known
    both = ir.LiteralStructType([VECTOR, VECTOR])
    made = ir.Function(module, ir.FunctionType(both, [VECTOR]), symbol)
    made.linkage = "internal"
    (x,) = made.args
    builder = ir.IRBuilder(made.append_basic_block())
    lines = LaneValues(builder, {}, {"x": x})
    near = builder.fcmp_ordered("<", lines.intrinsic("llvm.fabs", [x]), lines.number(_FARTHEST))
    _write(lines, _ANGLES)
    s, c, b = (lines.value(ast.Name(id=name)) for name in "scb")
    quarters = builder.bitcast(b, _WHOLES)
    odd = builder.trunc(quarters, ir.VectorType(ir.IntType(1), LANES))
    values = [
        _turned(builder, builder.select(odd, c, s), quarters),
        _turned(builder, builder.select(odd, s, c), builder.add(quarters, _whole(1))),
    ]
    bits = ir.IntType(LANES)
    all_near = builder.icmp_unsigned("==", builder.bitcast(near, bits), ir.Constant(bits, (1 << LANES) - 1))
    with builder.if_then(builder.not_(all_near), likely=False):
        far = [_of_each(lines, name, x) for name in ("sin", "cos")]
        pairs = zip(values, far, strict=True)
        builder.ret(_pair(builder, both, [builder.select(near, one, other) for one, other in pairs]))
    builder.ret(_pair(builder, both, values))
    return made


def tangent(module: ir.Module) -> ir.Function:
    """Return the hyperbolic tangent of a vector in a module; it is written where it is not there yet."""
    symbol = "lanes.tangent"
    known = module.globals.get(symbol)
    if known is not None:
        return known
    made = ir.Function(module, ir.FunctionType(VECTOR, [VECTOR]), symbol)
    made.linkage = "internal"
    (x,) = made.args
    builder = ir.IRBuilder(made.append_basic_block())
    lines = LaneValues(builder, {}, {"x": x})
    _write(lines, _GROWTH)
    exponent = builder.bitcast(lines.value(ast.Name(id="b")), _WHOLES)
    power = builder.bitcast(builder.shl(exponent, _whole(52)), VECTOR)
    lines = LaneValues(builder, {}, {"two": power, "p": lines.value(ast.Name(id="p"))})
    _write(lines, "m = two * p + (two - 1.0)\nfound = m / (m + 2.0)")
    builder.ret(lines.intrinsic("llvm.copysign", [lines.value(ast.Name(id="found")), x]))
    return made


def direction(module: ir.Module) -> ir.Function:
    """Return atan2 of vectors y and x in a module; it is written where it is not there yet.

    Zeros have no sign in x, and the direction of no number and of two infinite ones is none.
    """
    symbol = "lanes.direction"
    known = module.globals.get(symbol)
    if known is not None:
        return known
    made = ir.Function(module, ir.FunctionType(VECTOR, [VECTOR, VECTOR]), symbol)
    made.linkage = "internal"
    y, x = made.args
    lines = LaneValues(ir.IRBuilder(made.append_basic_block()), {}, {"y": y, "x": x})
    _write(lines, _DIRECTION)
    lines.builder.ret(lines.intrinsic("llvm.copysign", [lines.value(ast.Name(id="found")), y]))
    return made


class LaneFunctions(LaneValues):
    """Lines of vectors with elementary functions.

    Args:
        builder: at the end of the function.
        arrays: see `Instructions`.
        values: see there.
    """

    def __init__(
        self, builder: ir.IRBuilder, arrays: dict[str, ir.Value], values: dict[str, ir.Value] | None = None
    ) -> None:
        super().__init__(builder, arrays, values)
        self._angles: dict[ir.Value, tuple[ir.Value, ir.Value]] = {}

    def _elementary(self, name: str, args: list[ir.Value]) -> ir.Value:
        module, value = self.builder.module, args[0]
        if name in ("tanh", "atan2"):
            return self.builder.call(tangent(module) if name == "tanh" else direction(module), args)
        if name in ("exp", "pow"):
            return _of_each(self, name, *args)
        if name not in ("sin", "cos"):
            raise ValueError(f"`{name}` is not written for vectors")
        if value not in self._angles:
            both = self.builder.call(sine_and_cosine(module), args)
            self._angles[value] = self.builder.extract_value(both, 0), self.builder.extract_value(both, 1)
        return self._angles[value][name == "cos"]


def _turned(builder: ir.IRBuilder, value: ir.Value, quarters: ir.Value) -> ir.Value:
    """Return a sine of an angle in its quarter with the sign that it has all round.

    Args:
        builder: at the end of the function.
        value: of the angle in its quarter.
        quarters: whole numbers whose last two bits are the quarter; in the last two of four the sign changes.
    """
    sign = builder.shl(builder.and_(quarters, _whole(2)), _whole(62))
    return builder.bitcast(builder.xor(builder.bitcast(value, _WHOLES), sign), VECTOR)


def _whole(number: int) -> ir.Value:
    """Return a whole number in all lanes."""
    return ir.Constant(_WHOLES, [number] * LANES)


def _of_each(lines: LaneValues, name: str, *args: ir.Value) -> ir.Value:
    """Return the results of a function of the C library for each number of its arguments."""
    found = ir.Constant(VECTOR, ir.Undefined)
    for lane in range(LANES):
        found = lines.with_lane(found, lane, lines.foreign(name, [lines.lane(one, lane) for one in args]))
    return found


def _write(lines: LaneValues, text: str) -> None:
    for line in ast.parse(text).body:
        lines.write(line)


def _pair(builder: ir.IRBuilder, kind: ir.Type, values: list[ir.Value]) -> ir.Value:
    pair = ir.Constant(kind, ir.Undefined)
    for place, value in enumerate(values):
        pair = builder.insert_value(pair, value, place)
    return pair
