"""Which run comes next, with a toy in place of the simulator."""

import asyncio
from collections.abc import Awaitable, Callable
from dataclasses import dataclass, field
from functools import partial
from pathlib import Path

from ropsim.studio import Message
from ropsim.studio.testing import LiveStatus, Runs, RunStatus, RunWays, WorkerLink, orders
from support.patience import PATIENCE

VERSIONS = {"programs/main.task": 3}


@dataclass(slots=True)
class Stage:
    """Runs of a toy, and what they have told."""

    runs: Runs
    texts: dict[str, str]
    told: list[Message]
    frames: list[bytes]
    changed: asyncio.Event = field(default_factory=asyncio.Event)

    async def until(self, wanted: Callable[[Message], bool]) -> None:
        """Wait until a message of that kind has been told."""
        while not any(wanted(one) for one in self.told):
            self.changed.clear()
            await self.changed.wait()

    async def until_state(self, *states: str) -> None:
        """Wait until runs have had these states, in this order among others."""
        for state in states:
            await self.until(partial(_has_state, state))

    def states(self) -> list[tuple[int, str]]:
        """Return run numbers and states, without repetitions."""
        told = [(one.id, one.state) for one in self.told if isinstance(one, RunStatus)]
        return [one for index, one in enumerate(told) if index == 0 or told[index - 1] != one]


def _has_state(state: str, message: Message) -> bool:
    return isinstance(message, RunStatus) and message.state == state


def on_stage(folder: Path, play: Callable[[Stage], Awaitable[None]]) -> None:
    """Play with runs of a toy."""

    async def run() -> None:
        link = WorkerLink("toy", str(folder), lambda _: None, "support.toy_worker:main")
        texts: dict[str, str] = {"programs/main.task": "x"}
        told: list[Message] = []
        frames: list[bytes] = []
        stage: Stage

        def tell(message: Message) -> None:
            told.append(message)
            stage.changed.set()

        stage = Stage(
            Runs(folder, link, lambda: texts, lambda: VERSIONS, tell, frames.append), texts, told, frames
        )
        try:
            await asyncio.wait_for(play(stage), PATIENCE)
        finally:
            stage.runs.close()
            await link.close()

    asyncio.run(run())


def test_a_finished_run_has_its_pack_and_a_tab_that_comes_later_hears_of_it(tmp_path: Path) -> None:
    async def play(stage: Stage) -> None:
        stage.runs.run("main", "dynamic")
        await stage.until_state("done")
        assert stage.states() == [(1, "running"), (1, "done")]
        assert stage.runs.pack(1) == b"x|0"
        assert stage.runs.pack(2) is None
        assert stage.runs.news[0] == RunStatus(1, "done", "main", simulated=1, versions=VERSIONS)

    on_stage(tmp_path, play)


def _is_ways(message: Message) -> bool:
    return isinstance(message, RunWays)


def test_the_ways_of_a_finished_run_are_looked_at_and_a_tab_that_comes_later_hears_of_it(
    tmp_path: Path,
) -> None:
    async def play(stage: Stage) -> None:
        stage.runs.run("main", "dynamic")
        await stage.until(_is_ways)
        done = RunStatus(1, "done", "main", simulated=1, versions=VERSIONS)
        assert stage.runs.news == (done, RunWays(1, ({"code": "S751"},), {"warnings": 1}))
        stage.texts["programs/main.task"] = "seen before"
        stage.told.clear()
        stage.runs.run("main", "dynamic")
        await stage.until_state("done")
        assert not any(_is_ways(one) for one in stage.runs.news)
        assert await stage.runs.file(2, "report") == b"report 3"
        assert not any(_is_ways(one) for one in stage.told)

    on_stage(tmp_path, play)


def test_the_next_run_ends_the_look_at_the_ways_of_the_one_before(tmp_path: Path) -> None:
    async def play(stage: Stage) -> None:
        stage.texts["programs/main.task"] = "far"
        stage.runs.run("main", "dynamic")
        await stage.until_state("done")
        stage.texts["programs/main.task"] = "near"
        stage.runs.run("main", "dynamic")
        await stage.until(_is_ways)
        assert stage.states() == [(1, "running"), (1, "done"), (2, "running"), (2, "done")]
        assert [one.run for one in stage.told if isinstance(one, RunWays)] == [2]

    on_stage(tmp_path, play)


def test_text_that_rests_is_simulated_once(tmp_path: Path) -> None:
    async def play(stage: Stage) -> None:
        for text in ("a", "ab", "abc"):
            stage.texts["programs/main.task"] = text
            stage.runs.text_changed()
        await stage.until_state("done")
        assert stage.states() == [(1, "running"), (1, "done")]
        assert stage.runs.pack(1) == b"abc|0"

    on_stage(tmp_path, play)


def test_the_newest_wish_wins(tmp_path: Path) -> None:
    async def play(stage: Stage) -> None:
        stage.runs.run("endless", "dynamic")
        stage.runs.run("endless", "dynamic")
        stage.runs.run("main", "dynamic")
        await stage.until_state("done")
        assert stage.states() == [(1, "running"), (2, "waiting"), (3, "waiting"), (3, "running"), (3, "done")]

    on_stage(tmp_path, play)


def test_a_refused_run_leaves_the_one_before_as_it_was(tmp_path: Path) -> None:
    async def play(stage: Stage) -> None:
        stage.runs.run("main", "dynamic")
        await stage.until_state("done")
        stage.texts["programs/main.task"] = "wrong"
        stage.runs.text_changed()
        await stage.until_state("refused")
        assert [one.state for one in stage.runs.news if isinstance(one, RunStatus)] == ["done", "refused"]
        assert stage.runs.pack(1) == b"x|0"

    on_stage(tmp_path, play)


def test_cancelling_says_so(tmp_path: Path) -> None:
    async def play(stage: Stage) -> None:
        stage.runs.run("endless", "dynamic")
        stage.runs.cancel()
        await stage.until_state("cancelled")
        assert stage.states()[-1] == (1, "cancelled")

    on_stage(tmp_path, play)


def test_a_simulator_that_dies_is_told_and_the_next_run_works(tmp_path: Path) -> None:
    async def play(stage: Stage) -> None:
        stage.runs.run("crash", "dynamic")
        await stage.until_state("failed")
        stage.runs.run("main", "dynamic")
        await stage.until_state("done")
        assert stage.states()[-1] == (2, "done")

    on_stage(tmp_path, play)


def test_keys_of_a_live_run_are_inputs_of_the_runs_after_it_until_forgotten(tmp_path: Path) -> None:
    async def play(stage: Stage) -> None:
        stage.runs.start_live("main", 2.0)
        await stage.until(lambda one: isinstance(one, dict) and one["type"] == "layout")
        stage.runs.order_live(orders.SetSignal("gate", 1.0))
        stage.runs.text_changed()  # a live run is not disturbed by typing
        stage.runs.order_live(orders.LiveControl("stop"))
        await stage.until_state("done")
        assert stage.frames == [b"RS frame"]
        assert stage.told[0] == LiveStatus("starting", 2.0, "main")
        live_over = next(one for one in stage.told if isinstance(one, RunStatus) and one.state == "done")
        assert (live_over.id, live_over.inputs) == (1, 1)
        await stage.until(lambda one: isinstance(one, RunStatus) and one.age == "older")
        stage.told.clear()
        stage.runs.run("main", "dynamic")
        await stage.until_state("done")
        stage.told.clear()
        stage.runs.forget_inputs()
        await stage.until_state("done")
        assert [stage.runs.pack(run) for run in (1, 3, 4)] == [b"live", b"x|1", b"x|0"]

    on_stage(tmp_path, play)


def test_a_text_that_changed_beside_a_live_run_leaves_it_the_result_and_says_so(tmp_path: Path) -> None:
    async def play(stage: Stage) -> None:
        stage.runs.start_live("main", 1.0)
        await stage.until(lambda one: isinstance(one, dict) and one["type"] == "layout")
        stage.texts["programs/main.task"] = "y"
        stage.runs.text_changed()
        stage.runs.order_live(orders.LiveControl("stop"))
        await stage.until(lambda one: isinstance(one, RunStatus) and one.age == "older")
        (stays,) = stage.runs.news
        assert isinstance(stays, RunStatus)
        assert (stays.id, stays.state, stage.runs.pack(1)) == (1, "done", b"live")
        assert stage.runs.pack(2) is None
        stage.texts["programs/main.task"] = "z"
        stage.runs.text_changed()
        await stage.until(lambda one: isinstance(one, RunStatus) and (one.id, one.state) == (3, "done"))
        (now,) = stage.runs.news
        assert isinstance(now, RunStatus)
        assert (now.id, now.age, stage.runs.pack(now.id)) == (3, "newest", b"z|0")

    on_stage(tmp_path, play)


def test_running_at_once_ends_a_live_run(tmp_path: Path) -> None:
    async def play(stage: Stage) -> None:
        stage.runs.start_live("main", 1.0)
        await stage.until(lambda one: isinstance(one, dict) and one["type"] == "layout")
        stage.runs.run("main", "kinematic")
        await stage.until(lambda one: isinstance(one, RunStatus) and (one.id, one.state) == (2, "done"))
        assert LiveStatus("over", 1.0, "main") in stage.told

    on_stage(tmp_path, play)


def test_a_tab_that_comes_during_a_live_run_hears_what_was_said_before(tmp_path: Path) -> None:
    async def play(stage: Stage) -> None:
        stage.runs.start_live("main", 1.0)
        await stage.until(lambda one: isinstance(one, dict) and one["type"] == "layout")
        assert stage.runs.news == ({"type": "live", "state": "running", "speed": 1.0}, {"type": "layout"})

    on_stage(tmp_path, play)
