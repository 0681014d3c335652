"""Files of robots: exchange files of ISO 10303-21."""

from random import Random

from ropsim.core import SourceText
from ropsim.part21 import read_exchange, write_exchange
from support.fuzzing.mutation import BYTES, TEXT, mutated
from support.fuzzing.target import Target

_EXCHANGE = rb"""ISO-10303-21;
HEADER;
FILE_DESCRIPTION(('a \X2\03B1\X0\ b'),'2;1');
FILE_NAME('n','2000-01-01T00:00:00',(''),(''),'','','');
FILE_SCHEMA(('ANY'));
ENDSEC;
DATA;
/* units */
#1=(LENGTH_UNIT()NAMED_UNIT(*)SI_UNIT(.MILLI.,.METRE.));
#2=DIRECTION('it''s',(0.,0.,1.E-3));
#30=AXIS2_PLACEMENT_3D('',#2,$,#2);
#4=MEASURE(PLANE_ANGLE_MEASURE(0.5),((1,2),(-3,#30)),.T.,"0FF",'\X4\0001F916\X0\ \S\i \X\E9');
ENDSEC;
END-ISO-10303-21;
"""


def _exchange(content: bytes) -> str:
    file, findings = read_exchange(SourceText("t.stp", content.decode("utf-8", "replace")))
    if findings:
        return findings[0].code
    text = write_exchange(file)
    again, _ = read_exchange(SourceText("t.stp", text))
    assert write_exchange(again) == text
    return "read"


def _made(random: Random) -> bytes:
    return mutated(random, _EXCHANGE, random.choice((BYTES, TEXT)))


TARGETS = (Target("part21", _made, _exchange),)
