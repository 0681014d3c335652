"""The language server: findings, completion and hover for programs and cell files, on standard streams."""

from ropsim.lsp.analysis.workshop import Workshop as Workshop
from ropsim.lsp.completion.offered import incomplete_word as incomplete_word
from ropsim.lsp.completion.offered import offered as offered
from ropsim.lsp.server import answer as answer
from ropsim.lsp.server import mark as mark
from ropsim.lsp.server import settle as settle
from ropsim.lsp.state import State as State
from ropsim.lsp.transport import serve as serve
