"""Files of runs: recording files, inputs, packs, and findings as documents."""

from ropsim.records.diagnostic_json import diagnostic_document as diagnostic_document
from ropsim.records.diagnostics import InputsError as InputsError
from ropsim.records.diagnostics import RecordingFileError as RecordingFileError
from ropsim.records.file import read_recording as read_recording
from ropsim.records.file import recording_bytes as recording_bytes
from ropsim.records.file import write_recording as write_recording
from ropsim.records.inputs import inputs_of as inputs_of
from ropsim.records.inputs import inputs_text as inputs_text
from ropsim.records.inputs import read_inputs as read_inputs
from ropsim.records.inputs import with_inputs as with_inputs
from ropsim.records.pack_file import pack_bytes as pack_bytes
from ropsim.records.plain_values import numeric as numeric
from ropsim.records.plain_values import readable as readable
