% Palletize of the paper on the task language, Fig. 5, as it is printed but for its A and B, which are Distance and
% Count, and its way back. Both go straight to the parts; load_pallet and unload_pallet come from above.

task(palletize(From, To, Distance, Count), [
  doc("Empties a square pattern, as printed in Fig. 5: takes the parts of its rows one after the other and leaves each at the goal. Rows lie along X and Y of the base. Goes straight to the parts: unload_pallet comes from above."),
  params([From-location, To-location, Distance-length, Count-int]),
  words([
    word(From, "first part", "where the part at the corner of the square is taken, from where X and Y of the base lead to the others"),
    word(To, "goal", "where each part is left, one after the other"),
    word(Distance, "distance", "from each part to the next one"),
    word(Count, "parts in a row", "the square has as many rows")]),
  range([Distance > 0*mm, Count >= 1]),
  pre([gripper(open)]),
  geo([reachable(arm, From), reachable(arm, To)]),
  body([
    load([x, y, z], From),
    repeat(Count, [
      c := x,
      repeat(Count, [
        call(grip(p(x, y, z))),
        call(release(To)),
        x := x + Distance]),
      x := c,
      y := y + Distance])])]).

task(depalletize(From, To, Distance, Count), [
  doc("Fills a square pattern, the way back of Fig. 5: takes parts one after the other at the supply and leaves them in rows, turned as the first one. Rows lie along X and Y of the first place. Goes straight to the parts: load_pallet comes from above."),
  params([From-location, To-location, Distance-length, Count-int]),
  words([
    word(From, "supply", "where each part is taken"),
    word(To, "first place", "the corner of the square: where the first part is to lie"),
    word(Distance, "distance", "from each part to the next one"),
    word(Count, "parts in a row", "the square has as many rows")]),
  range([Distance > 0*mm, Count >= 1]),
  pre([gripper(open), enough(From, Count, Count), vacant(To, Count, Count, Distance)]),
  geo([reachable(arm, From), in_rows(reachable(arm, To), Count, Count, Distance)]),
  body([
    x := 0*mm,
    y := x,
    repeat(Count, [
      c := x,
      repeat(Count, [
        call(grip(From)),
        call(release(rel(To, p(x, -y, 0)))),
        x := x + Distance]),
      x := c,
      y := y + Distance])])]).
