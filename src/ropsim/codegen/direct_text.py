"""The text of the machine code that takes arguments out of objects of Python, in LLVM's language."""

import re

from ropsim.codegen import layout

WORDS = (
    "entry",
    "takes",
    "room",
    "first_real",
    "laid_whole",
    "laid_real",
    "array_type",
    "float_descr",
    "float_type",
    "float64_type",
    "int_type",
    "int64_type",
    "number_from",
    "save",
    "restore",
    "call",
    "stopped",
    "made_from",
    "none",
    "keep",
    "drop",
)
"""What a block begins with, see `ropsim.codegen.direct.block_of`."""
REAL = -1
"""Stands for a float among what a function takes: axes of an array, 0 for a whole number."""
_NUMBERS = {"takes", "room", "first_real", "laid_whole", "laid_real"}

_TEXT = """\
define ptr @direct(ptr %self, ptr %given, i64 %count, ptr %names) {
start:
  %slot = getelementptr i8, ptr %self, i64 HEAD
  %told = load ptr, ptr %slot
  %block = getelementptr i8, ptr %told, i64 CONTENT
  <takes>
  %so_many = icmp eq i64 %count, %takes
  %unnamed = icmp eq ptr %names, null
  %usual = and i1 %so_many, %unnamed
  br i1 %usual, label %begin, label %other
begin:
  <room>
  <first_real>
  <laid_whole>
  <laid_real>
  <int_type>
  <number_from>
  %answers = alloca [2 x i64]
  %says = getelementptr i64, ptr %answers, i64 1
  %whole = alloca i64, i64 %room
  %real = getelementptr i64, ptr %whole, i64 %first_real
  %kinds = getelementptr i64, ptr %block, i64 WORDS
  %laid = or i64 %laid_whole, %laid_real
  %nothing_laid = icmp eq i64 %laid, 0
  br i1 %nothing_laid, label %next, label %lay
lay:
  %laid_from = getelementptr i64, ptr %kinds, i64 %takes
  call void @llvm.memcpy.p0.p0.i64(ptr %whole, ptr %laid_from, i64 %laid_whole, i1 false)
  %laid_real_from = getelementptr i8, ptr %laid_from, i64 %laid_whole
  call void @llvm.memcpy.p0.p0.i64(ptr %real, ptr %laid_real_from, i64 %laid_real, i1 false)
  br label %next
next:
  %k = phi i64 [0, %begin], [0, %lay], [%k_next, %taken]
  %w = phi i64 [0, %begin], [%laid_whole, %lay], [%w_next, %taken]
  %r = phi i64 [0, %begin], [%laid_real, %lay], [%r_next, %taken]
  %all = icmp eq i64 %k, %count
  br i1 %all, label %run, label %take
take:
  %given_at = getelementptr ptr, ptr %given, i64 %k
  %object = load ptr, ptr %given_at
  %kind_at = getelementptr i8, ptr %object, i64 KIND
  %kind = load ptr, ptr %kind_at
  %value_at = getelementptr i8, ptr %object, i64 HEAD
  %wanted_at = getelementptr i64, ptr %kinds, i64 %k
  %wanted = load i64, ptr %wanted_at
  %w_at = getelementptr i8, ptr %whole, i64 %w
  %r_at = getelementptr i8, ptr %real, i64 %r
  switch i64 %wanted, label %array [i64 0, label %whole_one i64 REAL, label %real_one]

array:
  <array_type>
  %is_array = icmp eq ptr %kind, %array_type
  br i1 %is_array, label %look, label %other
look:
  %axes_at = getelementptr i8, ptr %object, i64 AXES
  %axes_i = load i32, ptr %axes_at
  %axes = sext i32 %axes_i to i64
  %as_many = icmp eq i64 %axes, %wanted
  <float_descr>
  %descr_at = getelementptr i8, ptr %object, i64 DESCR
  %descr = load ptr, ptr %descr_at
  %is_float = icmp eq ptr %descr, %float_descr
  %flags_at = getelementptr i8, ptr %object, i64 FLAGS
  %flags = load i32, ptr %flags_at
  %flag = and i32 %flags, GAPLESS
  %is_whole = icmp ne i32 %flag, 0
  %fits_0 = and i1 %as_many, %is_float
  %fits = and i1 %fits_0, %is_whole
  br i1 %fits, label %place, label %other
place:
  %data_at = getelementptr i8, ptr %object, i64 DATA
  %data = load i64, ptr %data_at
  store i64 %data, ptr %w_at
  %lengths_at = getelementptr i8, ptr %object, i64 LENGTHS
  %lengths = load ptr, ptr %lengths_at
  br label %length
length:
  %axis = phi i64 [0, %place], [%behind, %length]
  %length_at = getelementptr i64, ptr %lengths, i64 %axis
  %one_length = load i64, ptr %length_at
  %behind = add i64 %axis, 1
  %length_to = getelementptr i64, ptr %w_at, i64 %behind
  store i64 %one_length, ptr %length_to
  %last = icmp eq i64 %behind, %axes
  br i1 %last, label %placed, label %length
placed:
  %bytes_0 = add i64 %axes, 1
  %bytes = shl i64 %bytes_0, 3
  %w_array = add i64 %w, %bytes
  br label %taken

real_one:
  <float_type>
  <float64_type>
  %is_one = icmp eq ptr %kind, %float_type
  %is_other = icmp eq ptr %kind, %float64_type
  %is_real = or i1 %is_one, %is_other
  br i1 %is_real, label %from_real, label %no_real
from_real:
  %value = load double, ptr %value_at
  br label %put_real
no_real:
  %is_int = icmp eq ptr %kind, %int_type
  br i1 %is_int, label %from_int, label %other
from_int:
  store i32 0, ptr %answers
  %number = call i64 %number_from(ptr %object, ptr %answers)
  %over = load i32, ptr %answers
  %in_range = icmp eq i32 %over, 0
  %as_real = sitofp i64 %number to double
  br i1 %in_range, label %put_real, label %other
put_real:
  %real_value = phi double [%value, %from_real], [%as_real, %from_int]
  store double %real_value, ptr %r_at
  %r_one = add i64 %r, 8
  br label %taken

whole_one:
  %is_whole_int = icmp eq ptr %kind, %int_type
  br i1 %is_whole_int, label %from_whole, label %no_int
from_whole:
  store i32 0, ptr %answers
  %whole_number = call i64 %number_from(ptr %object, ptr %answers)
  %over_whole = load i32, ptr %answers
  %in_whole_range = icmp eq i32 %over_whole, 0
  br i1 %in_whole_range, label %put_whole, label %other
no_int:
  <int64_type>
  %is_int64 = icmp eq ptr %kind, %int64_type
  br i1 %is_int64, label %from_int64, label %other
from_int64:
  %number_64 = load i64, ptr %value_at
  br label %put_whole
put_whole:
  %whole_value = phi i64 [%whole_number, %from_whole], [%number_64, %from_int64]
  store i64 %whole_value, ptr %w_at
  %w_one = add i64 %w, 8
  br label %taken

taken:
  %w_next = phi i64 [%w_array, %placed], [%w, %put_real], [%w_one, %put_whole]
  %r_next = phi i64 [%r, %placed], [%r_one, %put_real], [%r, %put_whole]
  %k_next = add i64 %k, 1
  br label %next

run:
  <save>
  <entry>
  <restore>
  %state = call ptr %save()
  %status = call i32 %entry(ptr %answers, ptr %says, ptr %whole, ptr %real)
  call void %restore(ptr %state)
  %well = icmp eq i32 %status, 0
  br i1 %well, label %good, label %stop
good:
  <none>
  <keep>
  call void %keep(ptr %none)
  ret ptr %none
stop:
  <made_from>
  %status_long = sext i32 %status to i64
  %told_status = call ptr %made_from(i64 %status_long)
  %no_room = icmp eq ptr %told_status, null
  br i1 %no_room, label %failed, label %raise
failed:
  ret ptr null
raise:
  <call>
  <stopped>
  <drop>
  store ptr %told_status, ptr %answers
  %raised = call ptr %call(ptr %stopped, ptr %answers, i64 1, ptr null)
  call void %drop(ptr %told_status)
  ret ptr %raised
other:
  %call_at = getelementptr i64, ptr %block, i64 CALL
  %call_other = load ptr, ptr %call_at
  %answer = call ptr %call_other(ptr %self, ptr %given, i64 %count, ptr %names)
  ret ptr %answer
}

declare void @llvm.memcpy.p0.p0.i64(ptr, ptr, i64, i1)
"""


def direct_text() -> str:
    """Return the text of `direct`, a function as `METH_FASTCALL | METH_KEYWORDS` of Python has it.

    It looks at the type of an object before it reads more of it. Where something is not what the block says,
    it calls `self` in Python with the same arguments. The interpreter lock is let go while `entry` runs.
    """
    numbers = {
        "HEAD": layout.HEAD,
        "KIND": layout.KIND,
        "CONTENT": layout.CONTENT,
        "DATA": layout.DATA,
        "AXES": layout.AXES,
        "LENGTHS": layout.LENGTHS,
        "DESCR": layout.DESCR,
        "FLAGS": layout.FLAGS,
        "GAPLESS": layout.WHOLE,
        "WORDS": len(WORDS),
        "CALL": WORDS.index("call"),
        "REAL": REAL,
    }
    text = re.sub("<([a-z_0-9]+)>", _word, _TEXT)
    return re.sub(r"\b[A-Z]+\b", lambda found: str(numbers[found[0]]), text)


def _word(found: re.Match[str]) -> str:
    """Return the lines that read a word of the block."""
    name = found[1]
    kind = "i64" if name in _NUMBERS else "ptr"
    place = f"%{name}_word = getelementptr i64, ptr %block, i64 {WORDS.index(name)}"
    return f"{place}\n  %{name} = load {kind}, ptr %{name}_word"
