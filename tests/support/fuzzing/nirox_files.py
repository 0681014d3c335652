"""NIROX files, damaged: mostly in numbers, references and entities, so that most keep their syntax."""

from dataclasses import replace
from functools import lru_cache
from random import Random

import numpy as np

from ropsim import robots
from ropsim.core import SourceText
from ropsim.kinematics import forward
from ropsim.model import ALL_DIRECTIONS, JointSpring, LoopCut, Spring, audit, mechanism_findings
from ropsim.nirox import nirox_schema, read_nirox, write_nirox
from ropsim.spatial import Pose
from ropsim.views import Style, diagnostics_text
from support.exchange_laws import random_chain
from support.fuzzing.mutation import damaged_exchange
from support.fuzzing.target import Target
from support.nirox_texts import TEXT as HAND
from support.nirox_texts import WEIGHED_PLAIN
from support.trees import random_tree

_CUT = LoopCut(-1, Pose(), 4, Pose(), ALL_DIRECTIONS[:5])
_SPRING = Spring("spring", -1, np.zeros(3), 1, np.ones(3), 100.0, 0.2, 1.0)
_ON_JOINT = JointSpring("on joint", 0, 10.0, 0.1)
_SHOWN = 5  # findings that are written out


@lru_cache(maxsize=1)
def _texts() -> tuple[bytes, ...]:
    """Return right files; they are made when the first case is, since all targets load this module."""
    scara, tree = robots.load("scara"), random_tree(2, 5).robot
    drawn = (scara.links[0], *(replace(one, shapes=()) for one in scara.links[1:]))  # fewer shapes: faster
    chain = replace(
        random_chain(2),
        couplings=(),
        axes=(0,),
        home=np.zeros(1),
        cuts=(_CUT,),
        springs=(_SPRING,),
        joint_springs=(_ON_JOINT,),
    )
    written = [write_nirox(one).text for one in (replace(scara, links=drawn, base_shapes=()), tree, chain)]
    return tuple(one.encode() for one in (HAND, WEIGHED_PLAIN, *written))


@lru_cache(maxsize=1)
def _entities() -> tuple[bytes, ...]:
    return tuple(name.upper().encode() for name in nirox_schema().entities)


def _made(random: Random) -> bytes:
    return damaged_exchange(random, random.choice(_texts()), _entities(), 262)


def _take(content: bytes) -> str:
    """Read a file; what was read can be looked over, moved, and written to a file that reads the same."""
    source = SourceText("a.stp", content.decode("utf-8", "replace"))
    found = read_nirox(source)
    assert isinstance(diagnostics_text(found.findings[:_SHOWN], {source.name: source}, Style.PLAIN), str)
    wrong = [one.code for one in found.findings if one.is_error]
    assert (found.robot is None) == bool(wrong)
    for one in found.findings:
        if one.span is not None:
            assert 1 <= one.span.line <= len(source.lines)
    if found.robot is None:
        return wrong[0]
    assert not mechanism_findings(found.robot)
    audit(found.robot)
    assert np.isfinite(forward(found.robot, found.robot.home).matrix()).all()
    written = write_nirox(found.robot, found.further)
    if not written.text:
        assert {one.code for one in written.losses} == {"X956"}
        return "refused"
    again = read_nirox(SourceText("b.stp", written.text))
    assert again.robot is not None, again.findings
    assert write_nirox(again.robot, again.further).text == written.text
    return "read"


TARGETS = (Target("nirox", _made, _take),)
