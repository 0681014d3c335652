from ropsim.icr import OPCODES, Type
from ropsim.icr.machine.geometry import GEOMETRY
from ropsim.icr.machine.handlers import HANDLERS
from ropsim.icr.machine.operations import OPERATIONS

DECIDED_BY_LOADER = {"LOAD", "STORE", "GETC", "SETC", "FMT"}


def test_codes_are_unique_and_ascend() -> None:
    codes = [opcode.code for opcode in OPCODES.values()]
    assert codes == sorted(set(codes))


def test_codes_once_released_stay() -> None:
    frozen = {"HALT": 0x0001, "PUSH": 0x0101, "ADD.I": 0x0201, "JMP": 0x0301, "MKVEC": 0x0401}
    frozen |= {"FRAME": 0x0501, "MOVE.PTP.J": 0x0601, "IN": 0x0701, "MODAL.SAVE": 0x0520, "CAT": 0x070B}
    assert {name: OPCODES[name].code for name in frozen} == frozen


def test_every_opcode_is_carried_out_in_exactly_one_place() -> None:
    places = [*HANDLERS, *GEOMETRY, *OPERATIONS, *DECIDED_BY_LOADER]
    assert sorted(places) == sorted(OPCODES)


def test_stack_effects_are_read_from_the_table() -> None:
    opcode = OPCODES["MKORI.ZYX"]
    assert (opcode.pops, opcode.pushes) == ((Type.REAL,) * 3, (Type.ORI,))
    assert OPCODES["CALL"].pops is None


def test_capabilities_are_those_that_the_diagnostic_page_names() -> None:
    names = {opcode.capability for opcode in OPCODES.values()} - {""}
    assert names == {
        "CIRC",
        "CLOCK",
        "CONFIG",
        "EXT",
        "FREE",
        "GRIP",
        "GUARD",
        "IO",
        "JNT",
        "LIN",
        "MSG",
        "POSE",
        "PTP",
        "SPLINE",
        "TRACK",
        "TRIG",
        "ZONE",
    }


def test_flow_ends_at_five_instructions() -> None:
    assert {name for name, one in OPCODES.items() if one.ends_flow} == {"HALT", "TRAP", "JMP", "RET", "STOP"}
