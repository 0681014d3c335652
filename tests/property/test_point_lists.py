"""No bytes make the reader of point lists raise, and every finding lies in the text."""

import random

import pytest

from ropsim.core import SourceText
from ropsim.tasks import point_table, points_of
from ropsim.tasks.testing import decoded

SAMPLES = (
    b'name,x,y,z,pitch,roll,yaw\n,mm,mm,mm,deg,deg,deg\np1,1.5,2,3,4,5,6\n"a,b",1,2,3,,,\n,4,5,6,7,8,\n',
    'sep=;\r\nName;X;Y;Z\r\n;mm;cm;m\r\nTür;12,5;3;4\r\n\r\n"x""y";1;2;3\r\n'.encode("cp1252"),
    "name\tx\ty\tz\n\tinch\tmm\tmm\na\t1,5\t2\t3\n".encode("utf-16"),
)
WORDS = tuple(one.encode("latin-1") for one in (*',;"\n\r\t-\0', "nan", "inf", "1e999", "ÿþ", "ï»¿", "mm"))
CASES = 1500


def mutated(sample: bytes, chance: random.Random) -> bytes:
    content = bytearray(sample)
    for _ in range(chance.randint(1, 8)):
        at = chance.randrange(len(content) + 1)
        what = chance.random()
        if what < 0.4:
            content[at:at] = chance.choice(WORDS) * chance.choice((1, 1, 1, 300))
        elif what < 0.7:
            del content[at : at + chance.randint(1, 12)]
        else:
            content[at : at + 1] = bytes([chance.randrange(256)])
    return bytes(content)


@pytest.mark.parametrize("seed", range(4))
def test_no_content_makes_the_reader_raise(seed: int) -> None:
    chance = random.Random(seed)
    listed = 0
    for number in range(CASES):
        sample = SAMPLES[number % len(SAMPLES)]
        content = chance.randbytes(chance.randint(0, 200)) if number % 5 == 0 else mutated(sample, chance)
        text = SourceText("points/l.csv", decoded(content))
        found, findings = points_of(text, "l")
        for one in findings:
            assert one.message
            assert one.hint or one.span is not None
            if one.span is not None:
                assert 1 <= one.span.line <= len(text.lines) + 1
                assert one.span.end_column <= len(text.line(one.span.line)) + 2
        if found is not None:
            assert len(found.points) == len(found.lines)
            assert all(1 <= number <= len(found.points) for number in found.numbers.values())
            table = point_table(found)
            assert len(table.points) == len(found.points)
            listed += len(table.points) > 0
    assert listed > CASES / 20
