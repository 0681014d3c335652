"""SWI-Prolog as it has started: its start is made once and kept in the user's cache folder."""

from collections.abc import Mapping
from contextlib import suppress
from functools import lru_cache
from hashlib import sha256
from pathlib import Path

from ropsim.core import read_bytes
from ropsim.prolog.wasm.image import Image, unpacked_image
from ropsim.prolog.wasm.module_cache import KEPT
from ropsim.version import __version__


def mark_of(program: str, memory_bytes: int, sources: Mapping[str, bytes]) -> str:
    """Return the key of a started program.

    Args:
        program: digest of its code and library.
        memory_bytes: the most memory that it may have.
        sources: that it loads at its start, by their names.
    """
    hasher = sha256(f"{__version__} {_host()} {program} {memory_bytes}".encode())
    for name, content in sorted(sources.items()):
        hasher.update(f"\n{name} {len(content)}\n".encode() + content)
    return hasher.hexdigest()


def image_name(*marks: str) -> str:
    """Return the name of the image of a program, from its keys."""
    return f"{sha256(' '.join(marks).encode()).hexdigest()[:32]}.image"


def kept_image(name: str) -> Image | None:
    """Return a kept image; None where there is none that is whole."""
    packed = KEPT.find(name)
    if packed is not None:
        with suppress(ValueError):
            return _image(packed)
    return None


def keep_image(name: str, image: Image) -> None:
    """Keep an image for other processes; where that cannot be, the next start takes longer."""
    KEPT.keep(name, image.packed())


@lru_cache(maxsize=4)
def _image(packed: bytes) -> Image:
    return unpacked_image(packed)


@lru_cache(maxsize=1)
def _host() -> str:
    """Return the digest of the texts of this folder: they determine the initial state of a program."""
    texts = sorted(Path(__file__).parent.glob("*.py"))
    return sha256(b"".join(read_bytes(path) for path in texts)).hexdigest()
