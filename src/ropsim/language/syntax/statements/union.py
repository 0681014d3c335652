"""The union of all statement nodes, and the two lines that hold another one; positions as in `nodes`."""

from ropsim.core import frozen_dataclass
from ropsim.language.syntax.nodes import Node
from ropsim.language.syntax.statements.acting import (
    Assign,
    Call,
    Gripper,
    Load,
    Motion,
    Print,
    SetMode,
    SetSignal,
    Stop,
    WaitTime,
    With,
)
from ropsim.language.syntax.statements.declared import (
    ConstantDeclaration,
    ContractClause,
    FrameDeclaration,
    LocationDeclaration,
    Mode,
    PatternDeclaration,
    ProgramHeader,
    SignalDeclaration,
    TaskHeader,
    ToolDeclaration,
    Units,
    VariableDeclaration,
)
from ropsim.language.syntax.statements.steering import (
    Broken,
    Closer,
    Else,
    ElseIf,
    For,
    ForEach,
    Jump,
    Repeat,
    Return,
    Until,
    While,
)


@frozen_dataclass
class WaitCondition:
    """`wait until condition [timeout t [else statement]]`."""

    condition: Node
    timeout: Node | None
    otherwise: "Statement | None"
    start: int
    end: int


@frozen_dataclass
class If:
    """`if condition [then]`; with a statement after `then` it is complete in one line."""

    condition: Node
    body: "Statement | None"
    start: int
    end: int


Statement = (
    Broken
    | ProgramHeader
    | Units
    | Mode
    | FrameDeclaration
    | LocationDeclaration
    | ToolDeclaration
    | SignalDeclaration
    | ConstantDeclaration
    | VariableDeclaration
    | PatternDeclaration
    | TaskHeader
    | ContractClause
    | Closer
    | Until
    | Motion
    | Gripper
    | Load
    | SetSignal
    | SetMode
    | With
    | WaitTime
    | WaitCondition
    | If
    | ElseIf
    | Else
    | While
    | Repeat
    | For
    | ForEach
    | Jump
    | Return
    | Stop
    | Print
    | Call
    | Assign
)
