"""Code of blocks with memory, which start in the steady state of their first input."""

import numpy as np

from ropsim import blockdiagram as b
from ropsim.controller.diagrams.static_blocks import dot, spread
from ropsim.controller.diagrams.written import Written, total
from ropsim.spatial import Array

_SINGULAR = 1e-10
"""Least singular value of I - A, over the largest, of a system with a steady state."""


def state_space(block: b.StateSpace, to: Written) -> None:
    """Write x(k+1) = A·x + B·u, y = C·x + D·u."""
    inputs, states = to.flat(block), len(block.a)
    first = to.memory(states)
    kept = [f"x[{first + k}]" for k in range(states)]
    if block.x0:
        at_start = [f"{one} = {to.number(value)}" for one, value in zip(kept, block.x0, strict=True)]
    else:
        rows = _steady(np.array(block.a), np.array(block.b)).tolist()
        at_start = [f"{one} = {dot(tuple(row), inputs, to)}" for one, row in zip(kept, rows, strict=True)]
    if b.passes_at_once(block) or block.x0:
        to.before(at_start)
    else:
        to.before(f"if attempt == 0: {one} = 0.0" for one in kept)
        to.behind(at_start)
    for y, c, d in zip(to.results(block), block.c, block.d, strict=True):
        to.outputs.append(f"{y} = {total(filter(_counts, (dot(c, kept, to), dot(d, inputs, to))))}")
    new = [to.local() for _ in kept]
    for name, a, b_ in zip(new, block.a, block.b, strict=True):
        to.kept.append(f"{name} = {total(filter(_counts, (dot(a, kept, to), dot(b_, inputs, to))))}")
    to.kept += [f"{one} = {name}" for one, name in zip(kept, new, strict=True)]


def _counts(term: str) -> bool:
    return term != "0.0"


def _steady(A: Array, B: Array) -> Array:
    """Return the state over a constant input, 0 where there is no steady state."""
    whole = np.eye(len(A)) - A
    values = np.linalg.svd(whole, compute_uv=False)
    if values[-1] <= _SINGULAR * max(1.0, float(values[0])):
        return np.zeros(B.shape)
    return np.asarray(np.linalg.solve(whole, B))


def filtered(block: b.Block, made: b.Filter, to: Written) -> None:
    """Write a filter of each element in its transposed second direct form."""
    (inputs,), order = to.inputs(block), made.order
    for y, u in zip(to.results(block), inputs, strict=True):
        first = to.memory(order)
        kept = [f"x[{first + k}]" for k in range(order)]
        at_start = [f"{one} = 0.0" for one in kept]
        if made.steady_gain is not None:
            at_start = [
                f"{kept[k]} = {to.number(made.b[k + 1] - made.a[k + 1] * made.steady_gain)} * {u}"
                + (f" + {kept[k + 1]}" if k + 1 < order else "")
                for k in reversed(range(order))
            ]
        if made.b[0] != 0.0 or not order:
            to.before(at_start)
        else:
            to.before(f"if attempt == 0: {one} = 0.0" for one in kept)
            to.behind(at_start)
        terms = [f"{to.number(made.b[0])} * {u}"] if made.b[0] != 0.0 else []
        to.outputs.append(f"{y} = {total([*terms, *kept[:1]])}")
        for k, one in enumerate(kept):
            inside = f"{to.number(made.b[k + 1])} * {u} - {to.number(made.a[k + 1])} * {y}"
            to.kept.append(f"{one} = {inside}" + (f" + {kept[k + 1]}" if k + 1 < order else ""))


def integrator(block: b.Integrator, to: Written) -> None:
    """Write y(k+1) = y(k) + T·factor·u(k); an element whose factor is 0 stays as it starts."""
    (inputs,), results = to.inputs(block), to.results(block)
    size = len(results)
    factors, initial = spread(block.factors, size), spread(block.initial, size)
    for y, u, factor, start in zip(results, inputs, factors, initial, strict=True):
        if factor == 0.0:
            to.outputs.append(f"{y} = {to.number(start)}")
            continue
        kept = f"x[{to.memory(1)}]"
        to.before([f"if attempt == 0: {kept} = {to.number(start)}"])
        to.outputs.append(f"{y} = {kept}")
        to.kept.append(f"{kept} += {to.number(factor * block.sample_time)} * {u}")


def rate_limiter(block: b.RateLimiter, to: Written) -> None:
    """Write the input, as far as the last output lets it."""
    (inputs,), results = to.inputs(block), to.results(block)
    falling, rising = (spread(one, len(results)) for one in (block.falling, block.rising))
    for y, u, low, high in zip(results, inputs, falling, rising, strict=True):
        kept = f"x[{to.memory(1)}]"
        to.before([f"{kept} = {u}"])
        down, up = to.number(low * block.sample_time), to.number(high * block.sample_time)
        to.outputs.append(f"{y} = {kept} + min(max({u} - {kept}, {down}), {up})")
        to.kept.append(f"{kept} = {y}")


def delay(block: b.Delay, to: Written) -> None:
    """Write the input of some ticks ago."""
    (inputs,), last = to.inputs(block), block.ticks - 1
    for y, u in zip(to.results(block), inputs, strict=True):
        first, k = to.memory(block.ticks), to.local()
        to.before([f"if attempt == 0: x[{first}] = 0.0"])
        to.outputs.append(f"{y} = x[{first}]")
        to.behind([f"for {k} in range({block.ticks}):", f"    x[{first} + {k}] = {u}"])
        to.kept += _shifted(first, last, k, u)


def _shifted(first: int, last: int, k: str, u: str) -> list[str]:
    moved = [f"for {k} in range({last}):", f"    x[{first} + {k}] = x[{first + 1} + {k}]"] if last else []
    return [*moved, f"x[{first + last}] = {u}"]


def moving_filter(block: b.MovingFilter, to: Written) -> None:
    """Write the mean of the last inputs."""
    (inputs,), before = to.inputs(block), block.ticks - 1
    for y, u in zip(to.results(block), inputs, strict=True):
        if not before:
            to.outputs.append(f"{y} = {u}")
            continue
        first, k = to.memory(before), to.local()
        to.before([f"for {k} in range({before}):", f"    x[{first} + {k}] = {u}"])
        to.outputs += [f"{y} = {u}", f"for {k} in range({before}):", f"    {y} += x[{first} + {k}]"]
        to.outputs.append(f"{y} = {y} * {to.number(1.0 / block.ticks)}")
        to.kept += _shifted(first, before - 1, k, u)
