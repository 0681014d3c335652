"""`ropsim part`: the part library on the command line; millimetres, kilograms and seconds."""

import argparse
import textwrap
from collections.abc import Iterator, Mapping
from pathlib import Path

from ropsim.cli.terminal.output import Output, cannot_write
from ropsim.core import replace_file
from ropsim.parts import (
    PART_KINDS,
    Parameter,
    PartKind,
    Product,
    bound_words,
    fact_words,
    library_part,
    part_kind,
    range_words,
    tcp_words,
    value_words,
    values_words,
)
from ropsim.workbench import ProjectError

COLUMNS = 100
"""Width to which meanings and sources are wrapped."""


def list_(_options: argparse.Namespace, output: Output) -> int:
    """List the kinds of parts."""
    width = max(map(len, PART_KINDS))
    rows = [f"{'kind':{width}}  {'for':9}  {'models':>6}  part"]
    rows += [
        f"{kind.name:{width}}  {kind.use.value:9}  {len(kind.products) or '–':>6}  {kind.title}"
        for kind in PART_KINDS.values()
    ]
    output.text("\n".join(rows))
    output.document(
        {
            "kinds": {
                kind.name: {
                    "title": kind.title,
                    "use": kind.use.value,
                    "models": [one.name for one in kind.products],
                }
                for kind in PART_KINDS.values()
            }
        }
    )
    return 0


def show(options: argparse.Namespace, output: Output) -> int:
    """Print the parameters and models of a kind."""
    kind = part_kind(options.kind)
    part = library_part(options.kind, options.model)
    lines = [f"{kind.name}: {kind.title}, for: {kind.use.value}", *_wrapped(f"frame: {kind.frame}", 2), ""]
    lines += _parameter_lines(kind)
    lines += [f"  {bound_words(bound)}" for bound in kind.at_most]
    if part.X_MT is not None:
        words = tcp_words(kind, kind.product(options.model), float(part.X_MT.position[2]))
        lines += ["", f"  {options.model or 'without a model'}: {words}"]
    if kind.products:
        lines += ["", "models"]
    for product in kind.products:
        lines += _product_lines(kind, product)
    output.text("\n".join(lines))
    if options.png:
        from ropsim.views import part_png

        try:
            replace_file(Path(options.png), part_png(options.model or kind.name, part))
        except OSError as error:
            raise ProjectError(cannot_write(options.png, error)) from error
        output.text(f"\nwrote {options.png}")
    output.document(_document(kind))
    return 0


def _parameter_lines(kind: PartKind) -> Iterator[str]:
    """Yield a table of the parameters, each with its meaning and source in the next lines."""
    name, default = max(len(one.name) for one in kind.parameters), 10
    yield f"  {'parameter':{name}}  {'default':>{default}}  range"
    for one in kind.parameters:
        yield f"  {one.name:{name}}  {value_words(one, one.default):>{default}}  {range_words(one)}"
        source = f": {one.source}" if one.source else ""
        yield from _wrapped(f"{one.meaning} [{one.origin.value}{source}]", 6)


def _product_lines(kind: PartKind, product: Product) -> Iterator[str]:
    """Yield the figures of a product with their origin."""
    yield f"  {product.name}: {product.title}"
    facts = "; ".join(fact_words(fact) for fact in product.facts)
    figures = "; ".join(text for text in (values_words(kind, product.values), facts) if text)
    yield from _wrapped(f"{product.origin.value}: {figures}", 6)
    yield from _wrapped(f"source: {product.source}", 6)
    if product.estimates:
        yield from _wrapped(f"estimated: {values_words(kind, product.estimates)}", 6)
    X_MT = library_part(kind.name, product.name).X_MT
    if X_MT is not None:
        yield f"      {tcp_words(kind, product, float(X_MT.position[2]))}"


def _wrapped(text: str, indent: int) -> list[str]:
    lead = " " * indent
    return textwrap.wrap(
        text, COLUMNS, initial_indent=lead, subsequent_indent=f"{lead}  ", break_on_hyphens=False
    )


def _document(kind: PartKind) -> Mapping[str, object]:
    """Return a kind as a JSON document, values in SI units."""
    return {
        "name": kind.name,
        "title": kind.title,
        "use": kind.use.value,
        "frame": kind.frame,
        "parameters": [_parameter_document(one) for one in kind.parameters],
        "at_most": [
            {"small": one.small, "large": one.large, "of_several": list(one.of_several)}
            for one in kind.at_most
        ],
        **_tcp_document(kind, None),
        "models": [
            {
                "name": one.name,
                "title": one.title,
                "values": dict(one.values),
                "origin": one.origin.value,
                "source": one.source,
                "estimated": dict(one.estimates),
                **_tcp_document(kind, one),
                "facts": [
                    {"name": fact.name, "values": list(fact.values), "unit": fact.unit} for fact in one.facts
                ],
            }
            for one in kind.products
        ],
    }


def _tcp_document(kind: PartKind, product: Product | None) -> Mapping[str, object]:
    """Return the distance of the TCP of a tool from the mechanical interface [m] and its origin."""
    X_MT = library_part(kind.name, product.name if product else "").X_MT
    if X_MT is None:
        return {}
    return {"tcp": {"distance": float(X_MT.position[2]), "origin": kind.tcp_origin(product).value}}


def _parameter_document(one: Parameter) -> Mapping[str, object]:
    return {
        "name": one.name,
        "quantity": one.measure.value,
        "default": one.default,
        "low": one.low,
        "high": one.high,
        "meaning": one.meaning,
        "origin": one.origin.value,
        "source": one.source,
    }
