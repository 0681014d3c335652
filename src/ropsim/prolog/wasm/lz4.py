"""Blocks of LZ4, as emscripten packs the files of a program (source: LZ4 block format description, 1.6)."""


class DamagedBlockError(ValueError):
    """A block is not LZ4 or is longer than allowed."""


def unpacked(block: bytes, most: int) -> bytes:
    """Return the content of a block of LZ4.

    Args:
        block: as packed.
        most: the number of bytes that the content may have.

    Raises:
        DamagedBlockError: the block refers to missing data, ends early, or is longer than `most`.
    """
    content = bytearray()
    place, end = 0, len(block)
    try:
        while place < end:
            token = block[place]
            literals, place = _length(block, place + 1, token >> 4)
            content += block[place : place + literals]
            place += literals
            if place >= end:
                break
            distance = block[place] | block[place + 1] << 8
            match, place = _length(block, place + 2, token & 15)
            _repeat(content, distance, match + 4)
            if len(content) > most:
                raise DamagedBlockError(f"a block holds more than {most} bytes")
    except IndexError:
        raise DamagedBlockError("a block ends early") from None
    if place > end or len(content) > most:
        raise DamagedBlockError(f"a block does not end where it should, or holds more than {most} bytes")
    return bytes(content)


def _length(block: bytes, place: int, start: int) -> tuple[int, int]:
    """Return a length of which four bits are known, and the place behind it."""
    if start < 15:
        return start, place
    while block[place] == 255:
        start += 255
        place += 1
    return start + block[place], place + 1


def _repeat(content: bytearray, distance: int, length: int) -> None:
    """Append `length` bytes that begin `distance` bytes before the end; they may reach into themselves."""
    start = len(content) - distance
    if distance == 0 or start < 0:
        raise DamagedBlockError("a block repeats what is not there")
    repeated = content[start : start + length]
    content += (repeated * (length // len(repeated) + 1))[:length]
