"""Code of blocks without memory."""

from ropsim import blockdiagram as b
from ropsim.controller.diagrams.written import Written, total


def spread(values: tuple[float, ...], size: int) -> tuple[float, ...]:
    """Return one number for each element of an output."""
    return values * size if len(values) == 1 else values


def gain(block: b.Gain, to: Written) -> None:
    """Write y = factor·u."""
    (inputs,), results = to.inputs(block), to.results(block)
    for y, u, factor in zip(results, inputs, spread(block.factors, len(results)), strict=True):
        to.outputs.append(f"{y} = {to.number(factor)} * {u}")


def matrix_gain(block: b.MatrixGain, to: Written) -> None:
    """Write y = K·u."""
    inputs = to.flat(block)
    for y, row in zip(to.results(block), block.matrix, strict=True):
        to.outputs.append(f"{y} = {dot(row, inputs, to)}")


def dot(row: tuple[float, ...], inputs: list[str], to: Written) -> str:
    """Return the product of a row of a matrix and a vector, without zeros."""
    return total(f"{to.number(one)} * {u}" for one, u in zip(row, inputs, strict=True) if one != 0.0)


def sum_(block: b.Sum, to: Written) -> None:
    """Write the sum."""
    inputs = to.inputs(block)
    for k, y in enumerate(to.results(block)):
        terms = [f"{'-' if sign < 0 else ''}{one[k]}" for sign, one in zip(block.signs, inputs, strict=True)]
        to.outputs.append(f"{y} = {total(terms)}")


def product(block: b.Product, to: Written) -> None:
    """Write the product."""
    inputs = to.inputs(block)
    for k, y in enumerate(to.results(block)):
        to.outputs.append(f"{y} = {' * '.join(one[k] for one in inputs)}")


def constant(block: b.Constant, to: Written) -> None:
    """Write the numbers."""
    results = to.results(block)
    for y, value in zip(results, spread(block.values, len(results)), strict=True):
        to.outputs.append(f"{y} = {to.number(value)}")


def saturation(block: b.Saturation, to: Written) -> None:
    """Write the limited input."""
    (inputs,), results = to.inputs(block), to.results(block)
    lower, upper = (spread(one, len(results)) for one in (block.lower, block.upper))
    for y, u, low, high in zip(results, inputs, lower, upper, strict=True):
        to.outputs.append(f"{y} = min(max({u}, {to.number(low)}), {to.number(high)})")


def dead_band(block: b.DeadBand, to: Written) -> None:
    """Write the distance to the nearer bound."""
    (inputs,), results = to.inputs(block), to.results(block)
    lower, upper = (spread(one, len(results)) for one in (block.lower, block.upper))
    for y, u, low, high in zip(results, inputs, lower, upper, strict=True):
        to.outputs.append(f"{y} = max({u} - {to.number(high)}, 0.0) + min({u} - {to.number(low)}, 0.0)")


def lookup(block: b.Lookup, to: Written) -> None:
    """Write the value between two points."""
    (inputs,), results = to.inputs(block), to.results(block)
    x, y_ = to.numbers_from(block.points), to.numbers_from(block.values)
    last = len(block.points) - 2
    for y, u in zip(results, inputs, strict=True):
        k, share = to.local(), to.local()
        to.outputs += [
            f"{k} = 0",
            f"while {k} < {last} and {u} > p[{x + 1} + {k}]:",
            f"    {k} += 1",
            f"{share} = ({u} - p[{x} + {k}]) / (p[{x + 1} + {k}] - p[{x} + {k}])",
            f"{share} = min(max({share}, 0.0), 1.0)",
            f"{y} = p[{y_} + {k}] + {share} * (p[{y_ + 1} + {k}] - p[{y_} + {k}])",
        ]


def switch(block: b.Switch, to: Written) -> None:
    """Write one of two inputs."""
    condition, first, second = to.inputs(block)
    results = to.results(block)
    threshold = to.number(block.threshold)
    for k, y in enumerate(results):
        chosen = condition[k] if len(condition) > 1 else condition[0]
        to.outputs.append(f"{y} = {first[k]} if {chosen} >= {threshold} else {second[k]}")
