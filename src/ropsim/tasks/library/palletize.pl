% Palletize of the paper on the task language, Fig. 5, as it is printed, and its way back. Both go straight to the parts;
% load_pallet and unload_pallet come from above.

task(palletize(From, To, A, B), [
  doc("Empties a square pattern, as printed in Fig. 5: takes B x B parts that lie A apart, one after the other, and leaves each at the same location. Goes straight to the parts: unload_pallet comes from above."),
  params([From-location, To-location, A-length, B-int]),
  words([
    word(From, "first part", "where the part at the corner of the square lies"),
    word(To, "goal", "where each part is brought"),
    word(A, "distance", "from each part to the next one, along X and Y"),
    word(B, "parts in a row", "the square has as many rows")]),
  range([A > 0*mm, B >= 1]),
  pre([gripper(open)]),
  geo([reachable(arm, From), reachable(arm, To)]),
  body([
    load([x, y, z], From),
    repeat(B, [
      c := x,
      repeat(B, [
        call(grip(p(x, y, z))),
        call(release(To)),
        x := x + A]),
      x := c,
      y := y + A])])]).

task(depalletize(From, To, A, B), [
  doc("Fills a square pattern, the way back of Fig. 5: takes B x B parts at the same location, one after the other, and leaves them A apart in a square of B by B, turned as the first one. Goes straight to the parts: load_pallet comes from above."),
  params([From-location, To-location, A-length, B-int]),
  words([
    word(From, "supply", "where each part is taken"),
    word(To, "first place", "the corner of the square: where the first part is to lie"),
    word(A, "distance", "from each part to the next one, along X and Y"),
    word(B, "parts in a row", "the square has as many rows")]),
  range([A > 0*mm, B >= 1]),
  pre([gripper(open)]),
  geo([reachable(arm, From), reachable(arm, To)]),
  body([
    x := 0*mm,
    y := x,
    repeat(B, [
      c := x,
      repeat(B, [
        call(grip(From)),
        call(release(offset(To, p(x, y, 0)))),
        x := x + A]),
      x := c,
      y := y + A])])]).
