"""Findings about knowledge bases and the engine that reads them."""

from ropsim.core import Category, Severity, define

CLAUSE_SYNTAX = define(
    "P101",
    "clause-syntax",
    Severity.ERROR,
    "a clause of a knowledge base cannot be read",
    """
A clause is not Prolog: a comma, an operator or a bracket is missing or too many, or a quote is not closed.
Where a bracket is missing the mark stands where it is expected, and its partner is named; else where reading
stopped: what is wrong is there or just before. Reading goes on with the next
clause, so one run shows all of them. A text with such a clause is not loaded.

```prolog
part(bolt) part(nut).     % a full stop is missing between two facts
params([P-part, L-).      % something is missing after the minus
```

The end of a clause is a full stop and then a blank or the end of the line. Text in single quotes is one
name.
""",
)

UNKNOWN_PREDICATE = define(
    "P102",
    "unknown-predicate",
    Severity.WARNING,
    "a clause calls a predicate that nobody defines",
    """
A goal in the body of a clause has a name and a number of arguments that neither this text defines nor
Prolog, its libraries and the functions of ropsim. Calling it ends with an error. Mostly it is a slip of the
pen, or an argument too many or too few: `at/2` and `at/3` are different predicates. What is added while the
program runs is declared:

```prolog
:- dynamic held/1.
```
""",
)

SINGLETON = define(
    "P103",
    "singleton-variable",
    Severity.WARNING,
    "a variable occurs only once in its clause",
    """
A variable that stands in one place only carries nothing from there to anywhere: often another one has been
meant. Where it is meant so, its name begins with an underline, as in `_Part`.
""",
)

SCATTERED = define(
    "P104",
    "scattered-clauses",
    Severity.WARNING,
    "clauses of one predicate do not stand together",
    """
Between two clauses of a predicate stands one of another. Mostly the name of one of them is misspelt. Where
it is meant so, it is declared with `:- discontiguous name/arity.`
""",
)

NOT_LOADED = define(
    "P105",
    "knowledge-base-not-loaded",
    Severity.ERROR,
    "Prolog refuses a part of a knowledge base",
    """
A clause or a directive was refused while the text was loaded, and the text is not loaded at all. Texts that
are not trusted may define predicates of their own module, use libraries and declare; they may not start
programs, open files, change settings of the engine or define what belongs to others.
""",
)

LOAD_WARNING = define(
    "P106",
    "knowledge-base-warning",
    Severity.WARNING,
    "Prolog has something to say about a knowledge base",
    """
The text is loaded. What Prolog says is shown as it says it.
""",
)

GOAL_SYNTAX = define(
    "P110",
    "goal-syntax",
    Severity.ERROR,
    "a goal cannot be read",
    """
A goal is a term of Prolog, without a full stop: `task(grip(P, L), Properties)`.
""",
)

GOAL_ERROR = define(
    "P111",
    "goal-error",
    Severity.ERROR,
    "a goal ended with an error",
    """
Prolog ended a goal with an error that nothing in it catches, such as a number that is none, a predicate
that nobody defines or an error of a function that the goal calls.
""",
)

GOAL_UNSAFE = define(
    "P112",
    "goal-not-allowed",
    Severity.ERROR,
    "a goal reaches what a text that is not trusted may not do",
    """
As soon as one text that is not trusted is in the engine, every goal is looked through before it runs. It is
refused where it can reach files, programs, settings or calls that are only known while it runs. The message
names what it reached.
""",
)

TIME_LIMIT = define(
    "P113",
    "goal-time-limit",
    Severity.ERROR,
    "a goal takes longer than it may",
    """
A goal or the loading of a text took longer than its limit and was stopped. The engine goes on; what the
text or the goal did meanwhile may be undone. Often a recursion does not end: the clause that ends it is
missing or comes too late.
""",
    Category.OUT_OF_TIME,
)

INFERENCE_LIMIT = define(
    "P114",
    "goal-inference-limit",
    Severity.ERROR,
    "a goal takes more inferences than it may",
    """
A goal was stopped after the number of inferences that it was given. The same goal takes the same number on
every machine.
""",
)

CANCELLED = define(
    "P115",
    "goal-cancelled",
    Severity.ERROR,
    "a goal was cancelled",
    """
Somebody asked to stop what the engine did.
""",
)

CRASHED = define(
    "P116",
    "engine-crashed",
    Severity.ERROR,
    "Prolog ended in the middle of a goal",
    """
Prolog had no memory or no stack left, or ended itself. A new one takes its place: texts, facts and
functions are there again, what goals have asserted is not. A term that is nested hundreds of thousands deep
is a usual cause.
""",
    Category.ENGINE_LOST,
)

ANSWER_TOO_LARGE = define(
    "P117",
    "answer-too-large",
    Severity.ERROR,
    "an answer of Prolog cannot be taken over",
    """
An answer has more text than is taken over (8 MiB), an integer of more than 4300 digits, goes round in a
circle or holds a value that no term of Python stands for, such as a dict.
""",
    Category.ENGINE_LOST,
)

WRONG_USE = define(
    "P118",
    "engine-misused",
    Severity.ERROR,
    "an engine was used in a way that it does not allow",
    """
An engine belongs to the thread that used it first; other threads make one of their own and may only cancel.
Solutions of a goal cannot be asked for once the engine has been closed, another goal that was asked before
has gone on, or Prolog has crashed.
""",
    Category.ENGINE_LOST,
)

ENGINE_FILES_MISSING = define(
    "P120",
    "prolog-files-missing",
    Severity.ERROR,
    "SWI-Prolog is not there",
    """
Knowledge bases are read by SWI-Prolog, whose files are carried by every installation. In a checkout they
are fetched together with what the pages of the studio need: `make demo`, `make test` or `python
hatch_build.py` do that. With `ROPSIM_SKIP_FRONTEND=1` they are left out.
""",
    Category.DAMAGED,
)

ENGINE_FILES_CHANGED = define(
    "P121",
    "prolog-files-changed",
    Severity.ERROR,
    "the files of SWI-Prolog are others than ropsim knows",
    """
The files of SWI-Prolog were replaced or damaged. Install ropsim again; in a checkout `python
hatch_build.py` fetches them.
""",
    Category.DAMAGED,
)

NO_NATIVE_PROLOG = define(
    "P122",
    "no-native-prolog",
    Severity.ERROR,
    "this machine has no command `swipl`",
    """
`Engine(prolog=Prolog.NATIVE)` uses the SWI-Prolog of this machine, 9.0 or newer, which
has to be on the search path. Without it, use the Prolog of the package, which does the same,
more slowly.
""",
    Category.USAGE,
)

NOT_FOR_NATIVE = define(
    "P123",
    "stranger-in-native-prolog",
    Severity.ERROR,
    "a text that is not trusted was to be loaded into the native Prolog",
    """
The Prolog of the package is shut off from the machine; the command `swipl` can read files and start
programs. So only trusted texts are loaded into it (`Trust.OWN`). Knowledge bases of tasks are never loaded
but read as data, with either Prolog.
""",
)
