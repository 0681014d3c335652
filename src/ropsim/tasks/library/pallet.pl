% Patterns of parts on a pallet, filled and emptied from above.

task(load_pallet(From, To, Columns, Rows, Distance, Clear), [
  doc("Fills a pallet: takes parts one after the other at the supply and leaves them in rows on the pallet, each from above."),
  params([From-location, To-location, Columns-int, Rows-int, Distance-length, Clear-length = 50*mm]),
  words([
    word(From, "supply", "where each part is taken"),
    word(To, "first place", "where the first part is to lie, a corner of the pattern"),
    word(Columns, "parts in a row", "along X"),
    word(Rows, "rows", "along Y"),
    word(Distance, "distance", "from the middle of each part to that of the next one"),
    word(Clear, "clearance", "how far above the parts the tool comes and goes")]),
  range([Columns >= 1, Rows >= 1, Distance > 0*mm, Clear >= 0*mm]),
  pre([gripper(open)]),
  geo([reachable(arm, From), reachable(arm, To)]),
  body([
    y := 0*mm,
    repeat(Rows, [
      x := 0*mm,
      repeat(Columns, [
        mov(above(From, Clear)), lin(From), close, lin(above(From, Clear)),
        mov(above(offset(To, p(x, y, 0)), Clear)), lin(offset(To, p(x, y, 0))), open, lin(above(offset(To, p(x, y, 0)), Clear)),
        x := x + Distance]),
      y := y + Distance])])]).

task(unload_pallet(From, To, Columns, Rows, Distance, Clear), [
  doc("Empties a pallet: takes parts one after the other from its rows and leaves each at the goal, each from above."),
  params([From-location, To-location, Columns-int, Rows-int, Distance-length, Clear-length = 50*mm]),
  words([
    word(From, "first part", "where the first part lies, a corner of the pattern"),
    word(To, "goal", "where each part is brought"),
    word(Columns, "parts in a row", "along X"),
    word(Rows, "rows", "along Y"),
    word(Distance, "distance", "from the middle of each part to that of the next one"),
    word(Clear, "clearance", "how far above the parts the tool comes and goes")]),
  range([Columns >= 1, Rows >= 1, Distance > 0*mm, Clear >= 0*mm]),
  pre([gripper(open)]),
  geo([reachable(arm, From), reachable(arm, To)]),
  body([
    y := 0*mm,
    repeat(Rows, [
      x := 0*mm,
      repeat(Columns, [
        mov(above(offset(From, p(x, y, 0)), Clear)), lin(offset(From, p(x, y, 0))), close, lin(above(offset(From, p(x, y, 0)), Clear)),
        mov(above(To, Clear)), lin(To), open, lin(above(To, Clear)),
        x := x + Distance]),
      y := y + Distance])])]).
