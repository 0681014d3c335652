"""The union of all statement nodes."""

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
    If,
    Jump,
    Repeat,
    Return,
    Until,
    WaitCondition,
    While,
)

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
