"""Robot files, damaged: URDF, xacro with its parameter files, and MJCF."""

from random import Random

import numpy as np

from ropsim import robots
from ropsim.core import SourceText
from ropsim.exchange import read_mjcf, read_urdf, write_mjcf, write_urdf
from ropsim.exchange.testing import XacroError, bounded, yaml_value
from ropsim.kinematics import forward
from ropsim.model import ReadRobot, audit, mechanism_findings
from ropsim.views import Style, diagnostics_text
from support.fuzzing.mutation import TEXT, mutated, numeral, word
from support.fuzzing.target import Target
from support.mjcf_texts import ARM as MJCF_ARM
from support.mjcf_texts import HANDS, framed_chain
from support.urdf_texts import ARM, LIMITS, MACROS, SPELLINGS

_WRITTEN = [robots.load(name) for name in ("palletizer", "scara", "two_link")]
_URDF = (ARM.encode(), *(write_urdf(one).text.encode() for one in _WRITTEN))
_CALL = '<xacro:arg name="bare" default="0"/><xacro:arm prefix="r_"/></robot>'
_XACRO = (MACROS.replace("</robot>", _CALL).encode(), SPELLINGS.encode())
_ROWS = MJCF_ARM.replace(
    "<worldbody>",
    '<default><default class="f"><joint type="free"/></default></default><worldbody>'
    '<replicate count="3" offset="0.1 0 0.2" euler="0 10 0" sep="_"><body name="c" childclass="f">'
    '<joint name="r"/><geom size="0.1"/></body></replicate>',
).replace(
    "</mujoco>",
    '<option><flag gravity="disable"/></option><actuator><motor joint="r" forcerange="-1 1"/></actuator>'
    f'<keyframe><key qpos="{"0.1 " * 23}"/></keyframe></mujoco>',
)
_MJCF = (
    MJCF_ARM.encode(),
    HANDS.format(angle="degree", order="XYz").encode(),
    framed_chain(0).encode(),
    _ROWS.encode(),
    *(write_mjcf(one).text.encode() for one in _WRITTEN),
)
_ENTITIES = b'<!DOCTYPE a [<!ENTITY b "bb"><!ENTITY c "&b;&b;">]>'
_SHOWN = 5  # findings that are written out


class _Make:
    """Damaged copies of texts; most stay XML, since attributes are what readers look into."""

    def __init__(self, texts: tuple[bytes, ...]) -> None:
        self._texts = texts

    def __call__(self, random: Random) -> bytes:
        content = random.choice(self._texts)
        choice = random.random()
        if choice < 0.02:
            return _ENTITIES + content
        if choice < 0.7:
            for _ in range(random.choice((1, 1, 2, 3))):
                content = random.choice((numeral, word))(random, content)
            return content
        return mutated(random, content, TEXT)


def _check(found: ReadRobot, source: SourceText) -> str:
    """Return the code of the first error; a robot that was read can be audited, moved and written."""
    assert isinstance(diagnostics_text(found.findings[:_SHOWN], {source.name: source}, Style.PLAIN), str)
    wrong = [one.code for one in found.findings if one.is_error]
    assert (found.robot is None) == bool(wrong)
    for one in found.findings:
        if one.span is not None:
            assert 1 <= one.span.line <= len(source.lines)
            assert 1 <= one.span.column <= len(source.line(one.span.line)) + 1
    if found.robot is None:
        return wrong[0]
    assert not mechanism_findings(found.robot)
    audit(found.robot)
    assert np.isfinite(forward(found.robot, found.robot.home).matrix()).all()
    write_mjcf(found.robot)
    again = read_urdf(SourceText("b.urdf", write_urdf(found.robot).text))
    if again.robot is None:  # kilometres and tons make numbers beyond what is read
        assert {one.code for one in again.findings if one.is_error} == {"X983"}
        return "large"
    assert again.robot.n == found.robot.n
    return "read"


def _urdf(content: bytes) -> str:
    source = SourceText("a.urdf", content.decode("utf-8", errors="replace"))
    return _check(read_urdf(source), source)


def _mjcf(content: bytes) -> str:
    source = SourceText("a.xml", content.decode("utf-8", errors="replace"))
    return _check(read_mjcf(source), source)


def _yaml(content: bytes) -> str:
    try:
        bounded(yaml_value(content.decode("utf-8", errors="replace")))
    except XacroError as error:
        return error.message.split("`")[0].strip()[:20] or "refused"
    return "read"


def _take(content: bytes) -> str:
    """Read a file as what it seems to be: one process for all formats starts four times as fast."""
    if b"<mujoco" in content:
        return _mjcf(content)
    return _urdf(content) if b"<robot" in content else _yaml(content)


TARGETS = (Target("robots", _Make((*_URDF, *_XACRO, *_MJCF, LIMITS.encode())), _take),)
