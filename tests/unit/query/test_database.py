"""The query engine: what runs again when an input changes, and what does not."""

from ropsim.query import Database, Event, Once, Outcome, always_new


def words(db: Database) -> tuple[str, ...]:
    text: str = db.read("text")
    return tuple(text.split())


def count(db: Database) -> int:
    return len(db.ask(words))


def is_long(db: Database, limit: int) -> bool:
    return db.ask(count) > limit


@always_new
def large(db: Database) -> int:
    return len(db.ask(words))


def twice(db: Database) -> int:
    return 2 * db.ask(large)


def chosen(db: Database) -> str:
    """Reads one of two inputs."""
    found: str = db.read("left") if db.read("is left") else db.read("right")
    return found


def database(**inputs: object) -> Database:
    db = Database()
    db.give({name.replace("_", " "): value for name, value in inputs.items()})
    db.events = []
    return db


def ran(db: Database) -> list[str]:
    """Return the functions that were called since this was asked last, in order of their end."""
    assert db.events is not None
    found = [event.function for event in db.events if event.outcome is not Outcome.REUSED]
    db.events.clear()
    return found


def test_an_answer_is_worked_out_once() -> None:
    db = database(text="a b c")
    assert [db.ask(is_long, 2), db.ask(is_long, 2), db.ask(count)] == [True, True, 3]
    assert ran(db) == ["words", "count", "is_long"]


def test_arguments_tell_answers_apart() -> None:
    db = database(text="a b c")
    assert [db.ask(is_long, 2), db.ask(is_long, 3)] == [True, False]
    assert ran(db) == ["words", "count", "is_long", "is_long"]


def test_a_changed_input_reaches_what_depends_on_it() -> None:
    db = database(text="a b c")
    assert db.ask(is_long, 3) is False
    db.give({"text": "a b c d"})
    assert db.ask(is_long, 3) is True


def test_an_equal_answer_ends_the_search() -> None:
    db = database(text="a b c")
    db.ask(is_long, 2)
    ran(db)
    db.give({"text": "x y z"})
    assert db.ask(is_long, 2) is True
    assert db.events == [
        Event("words", (), Outcome.RAN),
        Event("count", (), Outcome.SAME),
        Event("is_long", (2,), Outcome.REUSED),
    ]


def test_an_answer_that_is_always_new_is_not_compared() -> None:
    db = database(text="a b c")
    assert db.ask(twice) == 6
    db.give({"text": "x y z"})
    assert db.ask(twice) == 6
    assert [(event.function, event.outcome) for event in db.events or ()][-2:] == [
        ("large", Outcome.RAN),
        ("twice", Outcome.SAME),
    ]


def test_an_input_that_is_given_again_changes_nothing() -> None:
    db = database(text="a b c")
    db.ask(count)
    before = db.revision
    db.give({"text": "".join(["a b", " c"])})
    assert db.revision == before


def test_values_that_are_equal_and_not_the_same_are_changes() -> None:
    db = database(text="")
    for value in (1, 1.0, True, 0.0, -0.0, (1,), (1.0,), {"a": 1, "b": 2}, {"b": 2, "a": 1}):
        before = db.revision
        db.give({"value": value})
        assert db.revision == before + 1, repr(value)


def test_what_was_not_looked_at_reaches_nothing() -> None:
    db = database(is_left=True, left="l", right="r")
    assert db.ask(chosen) == "l"
    ran(db)
    db.give({"right": "R"})
    assert (db.ask(chosen), ran(db)) == ("l", [])
    db.give({"is left": False})
    assert (db.ask(chosen), ran(db)) == ("R", ["chosen"])
    db.give({"left": "L"})
    assert (db.ask(chosen), ran(db)) == ("R", [])


def test_an_input_that_nobody_gave_is_none_until_it_is_given() -> None:
    def later(db: Database) -> object:
        return db.read("later")

    db = database()
    assert db.ask(later) is None
    db.give({"later": 3})
    assert db.ask(later) == 3


def test_answers_of_no_use_lately_are_given_up_and_all_others_hold() -> None:
    db = Database(limit=20)
    for k in range(200):
        db.give({"text": "a " * k, ("gone", k): k, ("gone", k - 1): None})
        assert db.ask(is_long, k - 1) is True
        assert db.ask(is_long, k) is False
        assert len(db) < 60


def counted(db: Database) -> int:
    return db.ask(count)


def counted_and_one(db: Database) -> int:
    return db.ask(counted) + 1


def asked_once(_db: Database, number: int) -> int:
    return number


def test_what_is_in_use_keeps_all_that_it_is_made_of() -> None:
    db = Database(limit=3)
    db.give({"text": "a b"})
    assert db.ask(counted_and_one) == 3
    for k in range(60):  # long enough for what is not in use to be given up several times
        db.give({"other": k})
        for number in range(5):
            db.ask(asked_once, 10 * k + number)
        db.ask(counted_and_one)
    assert len(db) < 150  # of 300 that were asked
    db.give({"text": "a b c d"})
    assert db.ask(counted_and_one) == 5


def left_by(db: Database, number: int) -> int:
    found: int = db.read(("left", number))
    return found + 1


def handed_on(db: Database, size: int) -> int:
    """Give inputs that are made of answers, one after the other."""
    with db.version():
        for number in range(size):
            db.give({("left", number + 1): db.ask(left_by, number)})
    return db.ask(left_by, size)


def test_inputs_made_of_answers_give_up_no_answer_of_their_version() -> None:
    db = Database(limit=5)
    db.give({("left", 0): 0})
    assert handed_on(db, 50) == 51
    db.events = []
    assert handed_on(db, 50) == 51
    assert ran(db) == []


def test_a_database_for_one_state_gives_the_same_answers() -> None:
    once, db = Once(), database(text="a b c", is_left=False, left="l", right="r")
    once.give({"text": "a b c", "is left": False, "left": "l", "right": "r"})
    assert [once.ask(is_long, 2), once.ask(chosen), once.ask(count)] == [
        db.ask(is_long, 2),
        db.ask(chosen),
        db.ask(count),
    ]
    assert len(once) == 4


def test_inputs_that_are_given_within_a_question_give_up_no_answer_that_runs() -> None:
    def noise(db: Database, number: int) -> object:
        return db.read(("x", number))

    def middle(db: Database) -> object:
        db.give({"between": db.read("use")})
        return db.read("text")

    def above(db: Database) -> object:
        return db.ask(middle)

    db = Database(limit=10)
    db.give({"text": "old", "use": 0})
    db.ask(middle)
    for version in range(9):  # in which nobody asks for the one in the middle
        db.give({("x", 0): version})
        db.ask(noise, 0)
    db.give({"use": 1})
    for number in range(20):
        db.ask(noise, number)
    assert db.ask(above) == "old"
    db.give({"text": "new"})
    assert db.ask(above) == "new"
