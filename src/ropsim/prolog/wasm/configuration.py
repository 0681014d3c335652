"""How wasmtime runs SWI-Prolog: with exceptions, so that it can be stopped, and in little address space."""

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from wasmtime import Config

_RESERVED = 64 << 20
"""Bytes of address space of a memory when it is made; beyond that it moves to a larger place."""
_GROWTH = 192 << 20
"""Bytes that are reserved in front of it when it has moved."""
_GUARD = 64 << 10
"""Bytes behind a memory that cannot be accessed."""
SETTINGS = f"epochs exceptions {_RESERVED} {_GROWTH} {_GUARD}"
"""Properties on which the machine code depends."""


def configuration() -> "Config":
    """Return the configuration of an engine.

    wasmtime would reserve 8.5 GB for each engine (4 GB for a memory and for its exceptions, with guards), so
    that no access has to be checked. Where a process may have less (`ulimit -v`, clusters) it would not
    start. The checks make Prolog slower by 30 %.
    """
    from wasmtime import Config

    config = Config()
    config.epoch_interruption = True
    config.wasm_exceptions = True
    config.memory_may_move = True
    config.memory_reservation = _RESERVED
    config.memory_reservation_for_growth = _GROWTH
    config.memory_guard_size = _GUARD
    return config
