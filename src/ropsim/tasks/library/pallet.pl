% Patterns of parts on a pallet, filled and emptied from above.

task(load_pallet(P, From, To, Columns, Rows, Distance, Clear), [
  doc("Fills a pallet: takes parts one after the other at the supply and leaves them in rows on the pallet, each from above. The parts of the supply that are known lie in the rows afterwards."),
  params([P-part, From-location, To-location, Columns-int, Rows-int, Distance-length, Clear-length = 50*mm]),
  words([
    word(P, "part", "the one that waits at the supply, first of all"),
    word(From, "supply", "where each part is taken"),
    word(To, "first place", "where the first part is to lie, a corner of the pattern"),
    word(Columns, "parts in a row", "along X of the first place"),
    word(Rows, "rows", "to the left of X as the tool looks at it, against Y of the first place"),
    word(Distance, "distance", "from the middle of each part to that of the next one"),
    word(Clear, "clearance", "how far above the parts the tool comes and goes")]),
  range([Columns >= 1, Rows >= 1, Distance > 0*mm, Clear >= 0*mm]),
  pre([gripper(open), at(P, From), enough(From, Columns, Rows), vacant(To, Columns, Rows, Distance)]),
  eff([-at(P, From), +at(P, To), -free(To), +in_rows(at(P, To), Columns, Rows, Distance)]),
  geo([
    reachable(arm, From),
    in_rows(reachable(arm, To), Columns, Rows, Distance),
    in_rows(collision_free(arm, P, To), Columns, Rows, Distance)]),
  body([
    y := 0*mm,
    repeat(Rows, [
      x := 0*mm,
      repeat(Columns, [
        mov(above(From, Clear)), lin(From), close, lin(above(From, Clear)),
        mov(above(rel(To, p(x, -y, 0)), Clear)), lin(rel(To, p(x, -y, 0))), open, lin(above(rel(To, p(x, -y, 0)), Clear)),
        x := x + Distance]),
      y := y + Distance])])]).

task(unload_pallet(P, From, To, Columns, Rows, Distance, Clear), [
  doc("Empties a pallet: takes parts one after the other from its rows and leaves each at the goal, each from above. Where they lie afterwards is not known."),
  params([P-part, From-location, To-location, Columns-int, Rows-int, Distance-length, Clear-length = 50*mm]),
  words([
    word(P, "part", "the first one, at the corner of the pattern"),
    word(From, "first part", "where the first part lies, a corner of the pattern"),
    word(To, "goal", "where each part is brought"),
    word(Columns, "parts in a row", "along X of the first place"),
    word(Rows, "rows", "to the left of X as the tool looks at it, against Y of the first place"),
    word(Distance, "distance", "from the middle of each part to that of the next one"),
    word(Clear, "clearance", "how far above the parts the tool comes and goes")]),
  range([Columns >= 1, Rows >= 1, Distance > 0*mm, Clear >= 0*mm]),
  pre([gripper(open), at(P, From), filled(From, Columns, Rows, Distance)]),
  eff([-at(P, From), +free(From), -free(To), -in_rows(at(P, From), Columns, Rows, Distance)]),
  geo([in_rows(reachable(arm, From), Columns, Rows, Distance), reachable(arm, To), collision_free(arm, P, To)]),
  body([
    y := 0*mm,
    repeat(Rows, [
      x := 0*mm,
      repeat(Columns, [
        mov(above(rel(From, p(x, -y, 0)), Clear)), lin(rel(From, p(x, -y, 0))), close, lin(above(rel(From, p(x, -y, 0)), Clear)),
        mov(above(To, Clear)), lin(To), open, lin(above(To, Clear)),
        x := x + Distance]),
      y := y + Distance])])]).
