"""Numbers at the edges of their types: what the compiler passes, the verifier passes; runs have no NaN."""

import math

from hypothesis import given, settings
from hypothesis import strategies as st

from ropsim import icr
from ropsim.spatial import Pose
from support.examples import examples
from support.tasks import compiled

HEAD = f"""units m, deg
const huge = {"*".join(["1e12"] * 25)}*1e8
task T(q: loc, far: length)
  mov q above far
endp
q = infeed
n = 2.5
i = 1
j = joints(0, 0, 0)
"""
BUDGET = 2_000
leaves = st.sampled_from(
    ["0", "3", "-0.5", "1e12", "1e-12", "huge", "-huge*1.7", "n", "i", "9007199254740993"]
)
numbers = st.recursive(
    leaves,
    lambda inner: st.one_of(
        st.builds("({} {} {})".format, inner, st.sampled_from(["+", "-", "*", "/", "mod"]), inner),
        st.builds("{}({})".format, st.sampled_from(["sqrt", "abs", "round", "trunc"]), inner),
        st.builds("atan2({}, {}) / 1 deg".format, inner, inner),
        st.builds("dist(({}, {}, 0), q) / 1 mm".format, inner, inner),
    ),
    max_leaves=4,
)
locations = st.recursive(
    st.sampled_from(["infeed", "q", "here"]) | st.builds("({}, {}, {})".format, numbers, numbers, numbers),
    lambda inner: st.one_of(
        st.builds("({} above {})".format, inner, numbers),
        st.builds("({} offset ({}, {}, 0))".format, inner, numbers, numbers),
        st.builds("({} rel (0, {}, 0; rz {}))".format, inner, numbers, leaves),
        st.builds("({} in pallet)".format, inner),
        st.builds("({}, {}, 0, {}, {})".format, numbers, numbers, numbers, numbers),
    ),
    max_leaves=3,
)
targets = st.lists(numbers, min_size=1, max_size=40).map(lambda one: f"joints({', '.join(one)})")
lines = st.one_of(
    st.builds("mov {}".format, locations | targets),
    st.builds("lin {} speed {}".format, locations, leaves),
    st.builds("q = {}".format, locations),
    st.builds("n = {}".format, numbers),
    st.builds("i = {}".format, numbers),
    st.builds("j = {}".format, targets),
    st.builds("q.{} = {}".format, st.sampled_from(["x", "rz"]), numbers),
    st.builds("load (a, b, c, d, e), {}".format, locations),
    st.builds("wait {}".format, numbers),
    st.builds("set blend {}".format, numbers),
    st.builds("print {}, {}".format, numbers, locations),
    st.builds("repeat {}\n  break\nendr".format, numbers),
    st.builds("for k = {} to {} step {}\n  break\nendf".format, numbers, numbers, leaves),
    st.builds("T {}, {}".format, locations, numbers),
    st.builds("set frame pallet\nprint here.x, {}".format, locations),
)


@settings(max_examples=examples(250), derandomize=True)
@given(st.lists(lines, min_size=1, max_size=4))
def test_a_text_without_findings_is_verified_and_runs_in_finite_numbers(program: list[str]) -> None:
    assert compiled(HEAD).ok
    right = [line for line in program if compiled(HEAD + line).icr is not None]
    result = compiled(HEAD + "\n".join(right))
    if result.icr is None:  # they contradict each other
        return
    assert icr.verify(result.icr) == ()
    run = icr.run(result.icr, icr.StillWorld(), BUDGET)
    targets = [move.target for move in run.moves]
    poses = [one.as_tuple() for one in targets if isinstance(one, Pose)]
    joints = [one for one in targets if isinstance(one, tuple)]
    assert all(math.isfinite(number) for one in (*poses, *joints) for number in one)
    assert not any(word in message for message in run.messages for word in ("nan", "inf"))
