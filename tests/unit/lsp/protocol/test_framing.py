"""Framing: messages in any cut, and bytes that are none."""

from ropsim.lsp.testing import MAX_BODY, FrameFault, FrameReader, framed


def test_messages_come_whole_however_they_are_cut() -> None:
    stream = framed(b"one") + framed("zwö".encode()) + framed(b"")
    reader = FrameReader()
    found = [body for k in range(len(stream)) for body in reader.feed(stream[k : k + 1])]
    assert found == [b"one", "zwö".encode(), b""]


def test_other_headers_are_allowed() -> None:
    header = b"Content-Type: application/vscode-jsonrpc\r\ncontent-length: 2\r\n\r\n"
    assert FrameReader().feed(header + b"{}") == [b"{}"]


def test_a_header_without_length_is_skipped_and_the_next_message_read() -> None:
    fault, body = FrameReader().feed(b"Hello: you\r\n\r\n" + framed(b"x"))
    assert isinstance(fault, FrameFault)
    assert body == b"x"


def test_noise_is_dropped_up_to_the_next_header() -> None:
    found = FrameReader().feed(b"\x00noise" * 2000 + framed(b"x"))
    assert [one for one in found if isinstance(one, bytes)] == [b"x"]
    assert any(isinstance(one, FrameFault) for one in found)


def test_a_message_that_is_too_large_is_skipped_without_being_kept() -> None:
    reader = FrameReader()
    (fault,) = reader.feed(b"Content-Length: %d\r\n\r\n" % (MAX_BODY + 1))
    assert isinstance(fault, FrameFault)
    rest = MAX_BODY + 1
    while rest:
        piece = min(rest, 4_000_000)
        assert reader.feed(bytes(piece)) == []
        rest -= piece
    assert reader.feed(framed(b"x")) == [b"x"]
