"""What a tab that comes during a live run is told."""

from ropsim.studio import Message
from ropsim.studio.testing import LiveLog, LiveStatus

LAYOUT = {"type": "layout", "channels": [], "bodies": [1]}


def placed(body: int, time: float) -> dict[str, object]:
    return {"type": "placed", "time": time, "body": body, "parent": -1}


def test_a_late_tab_hears_layout_newest_places_and_presses_but_no_notices() -> None:
    told: list[Message] = []
    log = LiveLog(told.append)
    log.start("main", 1.0)
    log.add({"type": "live", "state": "running"})
    log.add(LAYOUT)
    press = {"type": "stamped", "name": "gate", "value": 1.0, "time": 0.5}
    for message in (
        placed(4, 1.0),
        placed(5, 1.5),
        press,
        {"type": "notice", "code": "U980"},
        placed(4, 2.0),
    ):
        log.add(message)
    assert log.messages == (
        {"type": "live", "state": "running"},
        LAYOUT,
        placed(5, 1.5),
        press,
        placed(4, 2.0),
    )
    assert {"type": "notice", "code": "U980"} in told


def test_a_run_of_many_presses_stays_small() -> None:
    log = LiveLog(lambda _: None)
    log.start("main", 1.0)
    log.add(LAYOUT)
    for number in range(5000):
        log.add({"type": "stamped", "name": "gate", "value": 1.0, "time": float(number)})
    messages = log.messages
    assert len(messages) <= 1002
    assert messages[1] == LAYOUT
    assert messages[-1] == {"type": "stamped", "name": "gate", "value": 1.0, "time": 4999.0}


def test_of_a_task_that_goes_on_only_the_newest_word_is_kept() -> None:
    log = LiveLog(lambda _: None)
    log.start("main", 1.0)

    def happened(kind: str, duration: float, **data: object) -> dict[str, object]:
        event = {"kind": kind, "station": "robot", "duration": duration, "data": data}
        return {"type": "happened", "event": event}

    for duration in range(3):
        log.add(happened("move", duration))
        log.add(happened("task", duration, serial=1))
    moves = [happened("move", duration) for duration in range(3)]
    assert log.messages[1:] == (moves[0], happened("task", 2, serial=1), *moves[1:])


def test_when_the_run_is_over_it_is_forgotten() -> None:
    told: list[Message] = []
    log = LiveLog(told.append)
    log.start("main", 2.0)
    log.end()
    assert log.messages == ()
    assert told[-1] == LiveStatus("over", 2.0, "main")
