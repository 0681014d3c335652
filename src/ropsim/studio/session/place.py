"""Where the studio of a project is found again: its port, and the secret that its pages keep.

A page that is still open when the server ends reconnects automatically to the next one: that takes the same
port and identifies the page by the same secret. The secret is in tabs of the browser only, never in an
address, and in a file that the user alone can read.
"""

import contextlib
import hashlib
import secrets
from pathlib import Path
from typing import Annotated

import msgspec
from msgspec import Meta, Struct

from ropsim.core import read_own_bytes, replace_private_file, state_folder

LONGEST = 7 * 24 * 3600.0
"""Age at which a secret is made anew [s]."""


class Place(Struct, frozen=True):
    """Port and secret of a project.

    Attributes:
        port: of the last start, 0 for none.
        secret: of its pages.
        made: when the secret was made [s since 1970].
    """

    port: Annotated[int, Meta(ge=0, le=65535)]
    secret: Annotated[str, Meta(pattern=r"\A[A-Za-z0-9_-]{32,1000}\Z")]
    made: float


def place_of(folder: Path, now: float) -> Place:
    """Return where the studio of a project was last, or a new place without a port.

    Args:
        folder: of the project.
        now: [s since 1970].
    """
    fresh = Place(0, secrets.token_urlsafe(24), now)
    try:
        kept = msgspec.json.decode(read_own_bytes(_file(folder)), type=Place)
    except (OSError, ValueError, RecursionError):
        return fresh
    return kept if 0.0 <= fresh.made - kept.made < LONGEST else fresh


def keep_place(folder: Path, place: Place) -> None:
    """Remember a place for the next start; without a place to write it, the next start is a new one."""
    content = msgspec.json.encode(place)
    with contextlib.suppress(OSError):
        replace_private_file(_file(folder), content)


def _file(folder: Path) -> Path:
    key = hashlib.sha256(str(folder).encode("utf-8", "surrogateescape")).hexdigest()[:20]
    return state_folder() / "studio" / f"{key}.json"
