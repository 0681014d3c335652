"""Diagnostics of syntax, L1xx."""

from ropsim.core import Category, Severity, define

UNEXPECTED = define(
    "L101",
    "unexpected-word",
    Severity.ERROR,
    "the line goes on in a way that the statement does not allow",
    """
The statement was understood up to the marked place; there something else was expected. The message
names what was found and what is allowed.

Only this line is left out: all other lines are still compiled and checked. Every statement stands on a
line of its own; a line may be continued after an open parenthesis or a final `\\`.

```
mov part above 50 mm speed     <- a speed is missing
mov part above 50 mm speed 30 %
```
""",
    Category.SYNTAX,
)
CHARACTER = define(
    "L102",
    "unexpected-character",
    Severity.ERROR,
    "a character that no statement uses",
    """
Programs consist of ASCII letters, digits, `_` and the signs `+ - * / = < > ( ) , ; : . @ %`. Any other
character may stand in comments (after `#` or `//`) and in texts between quotes only. Text copied from a
word processor often brings typographic quotes, dashes or invisible spaces with it: type them anew.
""",
    Category.SYNTAX,
)
OPEN_TEXT = define(
    "L103",
    "unterminated-text",
    Severity.ERROR,
    "quotes are not closed on their line",
    """
A text starts and ends with a straight double quote on one line. Write `\\"` for a quote and `\\n` for a
new line inside it.

```
print "parts: ", n
```
""",
    Category.SYNTAX,
)
NUMBER_SIZE = define(
    "L104",
    "number-too-large",
    Severity.ERROR,
    "a number too large to mean anything",
    """
A number is larger than 1e12. No length, angle, time or count of a robot program is; most often a digit
or an exponent slipped in. The limit also keeps infinity and "not a number" out of all later stages.
""",
    Category.SYNTAX,
)
STATEMENT_START = define(
    "L105",
    "statement-start",
    Severity.ERROR,
    "a line starts with something that starts no statement",
    """
A statement starts with its verb (`mov`, `lin`, `open`, `repeat` …), with the name of a task, or with a
variable followed by `=`. Words such as `to`, `then` or `above` belong inside a statement and are
reserved: a variable cannot have their name.
""",
    Category.SYNTAX,
)
UNCLOSED = define(
    "L106",
    "block-not-closed",
    Severity.ERROR,
    "a block has no end",
    """
| opener | closer |
|---|---|
| any block | `end`, alone on its line |
| `task` | `endp` or `endtask` |
| `repeat` | `endr` or `until condition` |
| `if` (without a statement after `then`) | `endif` |
| `while` | `endw` |
| `for`, `for each` | `endf` |
| `with` | `endwith` |

`end` closes the innermost block that is open. Where one is missing further in, the `end` that was meant
for this block has closed an inner one; the finding shows it.

The block is taken to end where its lines stop being indented, before the first declaration, or else where the
surrounding block ends, so that everything else is still checked.
""",
    Category.SYNTAX,
)
UNOPENED = define(
    "L107",
    "block-not-opened",
    Severity.ERROR,
    "the end or the middle of a block without its beginning",
    """
`end`, `endp`, `endr`, `endif`, `endw`, `endf`, `endwith`, `until`, `else` and `elseif` belong to an opener
before them. Here no block of the right kind is open: either the opener is missing or misspelt, or this
line is one too many.
""",
    Category.SYNTAX,
)
MISPLACED = define(
    "L108",
    "misplaced-statement",
    Severity.ERROR,
    "a statement in a place where it has no meaning",
    """
Declarations (`frame`, `loc`, `tool`, `signal`, `const`, `pattern`, `units`, `program`, `classic`,
`strict`) and tasks stand outside all blocks. `break` and `continue` stand inside a loop, `return`
inside a task, `needs` and `assumes` directly after the header of a task. Only simple statements may
follow `then` and `else` on a line.
""",
    Category.SYNTAX,
)
NOT_YET = define(
    "L109",
    "not-yet-in-this-version",
    Severity.ERROR,
    "a statement of the language that this version does not compile yet",
    """
The statement is part of the task language, but this version cannot carry it out. It is refused rather
than left out silently: a program that is accepted does all that it says.
""",
    Category.SYNTAX,
)
TOO_MANY = define(
    "L110",
    "too-many-findings",
    Severity.HINT,
    "the list of findings was cut",
    """
After 200 findings the compiler stops: a text with that many is usually not a task program at all (a
picture, an archive, a file of another language). Mend the first ones and compile again.
""",
    Category.SYNTAX,
)
EMPTY = define(
    "L111",
    "empty-program",
    Severity.WARNING,
    "the program has no control statements",
    """
Nothing stands outside the tasks, so running the program moves nothing. Tasks are only carried out when
a control statement calls them:

```
task Greet(part: loc)
  mov part above 50 mm
endp

Greet infeed
```
""",
    Category.SYNTAX,
)
PROSE = define(
    "L112",
    "statement-read-as-prose",
    Severity.WARNING,
    "a line after `needs` or `assumes` looks like a misspelt statement",
    """
In a classic task the words after `needs` and `assumes` may run over several lines of prose, up to the first
statement. This line was read as such prose, but it looks like a statement whose first word is misspelt, or
like the call of a task that is not defined. Correct the word, or end the prose before it with a full stop.
""",
    Category.SYNTAX,
)
BEHIND_CONTRACT = define(
    "L120",
    "statement-behind-contract",
    Severity.ERROR,
    "a statement stands behind a contract on its line",
    """
All words on the line of `needs` and `assumes` belong to the contract. What stands behind a full stop there
and reads as a statement would never be carried out. Write it on a line of its own.

```
needs gripper open. close     <- `close` is not carried out
```
""",
    Category.SYNTAX,
)
DEPTH = define(
    "L113",
    "nested-too-deeply",
    Severity.ERROR,
    "an expression or a block nests deeper than the compiler allows",
    """
An expression may hold 100 operators and parentheses, and blocks may nest 32 deep. Split the expression
with a variable, or move the inner blocks into a task of their own.
""",
    Category.SYNTAX,
)
LINE_LENGTH = define(
    "L114",
    "text-too-long",
    Severity.ERROR,
    "a name, a line or the whole text is longer than the compiler allows",
    """
A name may have 200 characters, a line 2,000 characters and a program 200,000 lines. Longer ones are machine
output or not programs at all; split them into tasks.
""",
    Category.SYNTAX,
)
