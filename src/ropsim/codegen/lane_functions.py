"""Elementary functions of eight numbers at a time.

Angles are taken off in multiples of π/2, whose first 99 bits stand in three numbers, and what is left goes
into polynomials (Sun Microsystems 1993, fdlibm: k_sin.c, k_cos.c, e_rem_pio2.c); farther out than a million
the C library is asked. The hyperbolic tangent is m/(m + 2) with m = exp(2·|x|) - 1, by powers of 2 and the
series of exp between them. Errors are below 3e-16 of sine and cosine, and of the tangent as a share of it.
"""

import ast
from math import factorial

from llvmlite import ir

from ropsim.codegen.lane_values import LANES, VECTOR, LaneValues

_FARTHEST = 1e6
"""Up to here multiples of the first two parts of π/2 are exact."""
_WHOLE = 6755399441055744.0
"""1.5·2⁵²: a number that it is added to and taken off from again is rounded to a whole one."""
_ANGLES = f"""\
k = (x * 0.6366197723675814 + {_WHOLE}) - {_WHOLE}
r = ((x - k * 1.57079632673412561417) - k * 6.07710050630396597660e-11) - k * 2.02226624871116645580e-21
z = r * r
u = 2.75573137070700676789e-06 + z * (z * 1.58969099521155010221e-10 - 2.50507602534068634195e-08)
u = 8.33333333332248946124e-03 + z * (z * u - 1.98412698298579493134e-04)
s = r + (z * r) * (z * u - 1.66666666666666324348e-01)
u = z * (2.08757232129817482790e-09 - z * 1.13596475577881948265e-11) - 2.75573143513906633035e-07
u = z * (2.48015872894767294178e-05 + z * u) - 1.38888888888741095749e-03
u = 4.16666666666666019037e-02 + z * u
h = 0.5 * z
w = 1.0 - h
c = w + (((1.0 - w) - h) + (z * z) * u)
half = (k * 0.5 - 0.25 + {_WHOLE}) - {_WHOLE}
odd = k - 2.0 * half
even = 1.0 - odd
quarter = (half * 0.5 - 0.25 + {_WHOLE}) - {_WHOLE}
sign = 1.0 - 2.0 * (half - 2.0 * quarter)
sine = sign * (even * s + odd * c)
cosine = sign * (even * c - odd * s)
"""
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
    values = [lines.value(ast.Name(id=name)) for name in ("sine", "cosine")]
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
    wholes = ir.VectorType(ir.IntType(64), LANES)
    exponent = builder.bitcast(lines.value(ast.Name(id="b")), wholes)
    power = builder.bitcast(builder.shl(exponent, ir.Constant(wholes, [52] * LANES)), VECTOR)
    lines = LaneValues(builder, {}, {"two": power, "p": lines.value(ast.Name(id="p"))})
    _write(lines, "m = two * p + (two - 1.0)\nfound = m / (m + 2.0)")
    builder.ret(lines.intrinsic("llvm.copysign", [lines.value(ast.Name(id="found")), x]))
    return made


def _of_each(lines: LaneValues, name: str, x: ir.Value) -> ir.Value:
    """Return what a function of the C library makes of each number of a vector."""
    found = ir.Constant(VECTOR, ir.Undefined)
    for lane in range(LANES):
        found = lines.with_lane(found, lane, lines.foreign(name, [lines.lane(x, lane)]))
    return found


def _write(lines: LaneValues, text: str) -> None:
    for line in ast.parse(text).body:
        lines.write(line)


def _pair(builder: ir.IRBuilder, kind: ir.Type, values: list[ir.Value]) -> ir.Value:
    pair = ir.Constant(kind, ir.Undefined)
    for place, value in enumerate(values):
        pair = builder.insert_value(pair, value, place)
    return pair
