"""SWI-Prolog as it has started: its start is made once and kept in the user's cache folder."""

from collections.abc import Mapping
from contextlib import suppress
from functools import lru_cache
from hashlib import sha256
from pathlib import Path

from ropsim.core import cache_folder, read_bytes, read_own_bytes, replace_private_file
from ropsim.prolog.wasm.image import Image, unpacked_image
from ropsim.version import __version__


def mark_of(program: str, memory_bytes: int, sources: Mapping[str, bytes]) -> str:
    """Return what tells a program that has started from others.

    Args:
        program: digest of its code and library.
        memory_bytes: the most memory that it may have.
        sources: that it loads at its start, by their names.
    """
    hasher = sha256(f"{__version__} {_host()} {program} {memory_bytes}".encode())
    for name, content in sorted(sources.items()):
        hasher.update(f"\n{name} {len(content)}\n".encode() + content)
    return hasher.hexdigest()


def image_path(*marks: str) -> Path:
    """Return the file that holds the image of a program, by what tells it from others."""
    digest = sha256(" ".join(marks).encode()).hexdigest()
    return cache_folder() / "prolog" / f"{digest[:32]}.image"


def kept_image(path: Path) -> Image | None:
    """Return the image in a file; None where there is none, or one that somebody else could have written."""
    with suppress(OSError, ValueError):
        content = read_own_bytes(path)
        if sha256(content[32:]).digest() == content[:32]:
            return _image(content[32:])
    return None


def keep_image(path: Path, image: Image) -> None:
    """Write an image to a file; where that cannot be, the next start takes longer."""
    packed = image.packed()
    with suppress(OSError):
        replace_private_file(path, sha256(packed).digest() + packed)


@lru_cache(maxsize=4)
def _image(packed: bytes) -> Image:
    return unpacked_image(packed)


@lru_cache(maxsize=1)
def _host() -> str:
    """Return the digest of the texts of this folder: they decide what a program finds when it starts."""
    texts = sorted(Path(__file__).parent.glob("*.py"))
    return sha256(b"".join(read_bytes(path) for path in texts)).hexdigest()
