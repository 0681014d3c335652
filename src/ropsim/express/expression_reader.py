"""Read an expression of ISO 10303-11; `**` binds strongest, comparisons weakest."""

from collections.abc import Callable

from ropsim.express.expressions import (
    FUNCTIONS,
    Binary,
    Call,
    Collection,
    Expression,
    Index,
    Literal,
    Member,
    Name,
    Operator,
    Query,
    Self,
    Unary,
)
from ropsim.express.scanner import Scanner, TokenKind

MAX_DEPTH = 40
"""Expressions in each other that are read."""

_COMPARED = ("=", "<>", "<", "<=", ">", ">=", ":=:", ":<>:", "in")
_ADDED = ("+", "-", "or", "xor")
_MULTIPLIED = ("*", "/", "and")
_CONSTANTS = {"true": True, "false": False, "unknown": None}


def read_expression(scanner: Scanner, depth: int = 0) -> Expression:
    """Return the expression that comes next.

    Args:
        scanner: stands before it, and behind it afterwards.
        depth: how many expressions it stands in.

    Raises:
        SchemaProblemError: there is none, or it is deeper than `MAX_DEPTH`.
    """
    if depth > MAX_DEPTH:
        raise scanner.problem(f"at most {MAX_DEPTH} expressions in each other")
    left = _sum(scanner, depth)
    if scanner.token.text in _COMPARED:
        return Binary(Operator(scanner.take().text), left, _sum(scanner, depth))
    return left


def _sum(scanner: Scanner, depth: int) -> Expression:
    return _chain(scanner, depth, _ADDED, _product)


def _product(scanner: Scanner, depth: int) -> Expression:
    return _chain(scanner, depth, _MULTIPLIED, _power)


def _chain(
    scanner: Scanner, depth: int, signs: tuple[str, ...], read: Callable[[Scanner, int], Expression]
) -> Expression:
    left = read(scanner, depth)
    length = 0
    while scanner.token.text in signs and scanner.token.kind is not TokenKind.TEXT:
        length += 1
        if depth + length > MAX_DEPTH:
            raise scanner.problem(f"at most {MAX_DEPTH} operands in a row")
        left = Binary(Operator(scanner.take().text), left, read(scanner, depth))
    return left


def _power(scanner: Scanner, depth: int) -> Expression:
    left = _signed(scanner, depth)
    if scanner.took("**"):
        return Binary(Operator.POWER, left, _signed(scanner, depth))
    return left


def _signed(scanner: Scanner, depth: int) -> Expression:
    for sign in ("-", "+", "not"):
        if scanner.took(sign):
            return Unary(Operator(sign), _qualified(scanner, depth))
    return _qualified(scanner, depth)


def _qualified(scanner: Scanner, depth: int) -> Expression:
    found = _primary(scanner, depth)
    length = 0
    while scanner.comes(".") or scanner.comes("\\") or scanner.comes("["):
        length += 1
        if depth + length > MAX_DEPTH:
            raise scanner.problem(f"at most {MAX_DEPTH} attributes in a row")
        if scanner.took("["):
            found = Index(found, read_expression(scanner, depth + 1))
            scanner.need("]")
            continue
        owner = scanner.word("an entity") if scanner.took("\\") else ""
        scanner.need(".")
        found = Member(found, scanner.word("an attribute"), owner)
    return found


def _primary(scanner: Scanner, depth: int) -> Expression:
    token = scanner.token
    match token.kind:
        case TokenKind.INTEGER if len(token.text) <= 18:
            return Literal(int(scanner.take().text))
        case TokenKind.REAL:
            return Literal(float(scanner.take().text))
        case TokenKind.TEXT:
            return Literal(scanner.take().text[1:-1].replace("''", "'"))
        case TokenKind.WORD:
            return _word(scanner, depth)
        case _:
            return _bracketed(scanner, depth)


def _word(scanner: Scanner, depth: int) -> Expression:
    word = scanner.take().text
    if word == "self":
        return Self()
    if word in _CONSTANTS:
        return Literal(_CONSTANTS[word])
    if word == "query":
        return _query(scanner, depth)
    if scanner.took("("):
        arguments = [read_expression(scanner, depth + 1)]
        while scanner.took(","):
            arguments.append(read_expression(scanner, depth + 1))
        if FUNCTIONS.get(word) != len(arguments):
            allowed = ", ".join(f"{name} of {count}" for name, count in FUNCTIONS.items())
            raise scanner.problem(f"one of the functions {allowed} arguments before this")
        scanner.need(")")
        return Call(word, tuple(arguments))
    return Name(word)


def _query(scanner: Scanner, depth: int) -> Expression:
    scanner.need("(")
    variable = scanner.word("a variable")
    scanner.need("<*")
    source = _sum(scanner, depth + 1)
    scanner.need("|")
    condition = read_expression(scanner, depth + 1)
    scanner.need(")")
    return Query(variable, source, condition)


def _bracketed(scanner: Scanner, depth: int) -> Expression:
    """Return an expression in parentheses, an aggregate, an interval, or `?`."""
    if scanner.took("?"):
        return Literal(None)
    if scanner.took("("):
        inner = read_expression(scanner, depth + 1)
        scanner.need(")")
        return inner
    if scanner.took("["):
        items: list[Expression] = []
        while not scanner.comes("]"):
            if items:
                scanner.need(",")
            items.append(read_expression(scanner, depth + 1))
        scanner.need("]")
        return Collection(tuple(items))
    if scanner.took("{"):
        low = _sum(scanner, depth + 1)
        first = _interval_sign(scanner)
        middle = _sum(scanner, depth + 1)
        second = _interval_sign(scanner)
        high = _sum(scanner, depth + 1)
        scanner.need("}")
        return Binary(Operator.AND, Binary(first, low, middle), Binary(second, middle, high))
    raise scanner.problem("an expression")


def _interval_sign(scanner: Scanner) -> Operator:
    if not (scanner.comes("<") or scanner.comes("<=")):
        raise scanner.problem("`<` or `<=`")
    return Operator(scanner.take().text)
