"""Names that machine code takes from elsewhere, in the formats of all systems."""

import llvmlite.binding as llvm
import pytest

from ropsim.codegen.testing import names_from_elsewhere

SOURCE = """
target triple = "{triple}"
declare double @tanh(double)
declare double @unused(double)
declare double @llvm.sin.f64(double)
@counter = external global i64

define double @"own-name"(double %x) {{
  ret double %x
}}

define double @entry(double %x) {{
  %a = call double @tanh(double %x)
  %b = call double @llvm.sin.f64(double %a)
  %c = call double @"own-name"(double %b)
  %n = load i64, ptr @counter
  %d = sitofp i64 %n to double
  %e = fadd double %c, %d
  ret double %e
}}
"""


def _object_file(triple: str) -> bytes:
    llvm.initialize_native_target()
    llvm.initialize_native_asmprinter()
    machine = llvm.Target.from_triple(triple).create_target_machine(opt=1)
    emitted: bytes = machine.emit_object(llvm.parse_assembly(SOURCE.format(triple=triple)))
    return emitted


@pytest.mark.parametrize("system", ["unknown-linux-gnu", "apple-macosx", "pc-windows-msvc-elf"])
def test_names_of_other_code_and_data_are_found_and_own_ones_are_not(system: str) -> None:
    processor = llvm.get_process_triple().partition("-")[0]
    assert names_from_elsewhere(_object_file(f"{processor}-{system}")) == ("counter", "sin", "tanh")


def test_something_else_is_refused() -> None:
    with pytest.raises(ValueError, match="neither"):
        names_from_elsewhere(b"MZ and more")
