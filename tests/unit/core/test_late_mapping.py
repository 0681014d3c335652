"""Mappings that are made when they are asked for."""

import pickle

from ropsim.core import LateMapping


def test_it_is_made_once_and_only_when_it_is_asked_for() -> None:
    made: list[int] = []

    def make() -> dict[str, int]:
        made.append(1)
        return {"a": 1, "b": 2}

    late = LateMapping(make)
    assert made == []
    assert late["b"] == 2
    assert (list(late), len(late)) == (["a", "b"], 2)
    assert made == [1]


def test_it_equals_every_mapping_of_the_same_items() -> None:
    late = LateMapping(lambda: {"a": 1})
    assert late == {"a": 1}
    assert LateMapping(lambda: {"a": 1}) == late
    assert late != {"a": 2}
    assert repr(late) == "{'a': 1}"


def test_a_copy_for_another_process_holds_the_items() -> None:
    copied = pickle.loads(pickle.dumps(LateMapping(lambda: {"a": 1})))
    assert (type(copied), copied) == (dict, {"a": 1})
