% Palletize of the paper on the task language, Fig. 5, and its way back.

task(palletize(From, To, A, B), [
  doc("Takes B x B parts that lie A apart, one after the other, and leaves each at the same location."),
  params([From-location, To-location, A-length, B-int]),
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
  doc("Takes B x B parts at the same location, one after the other, and leaves them A apart in a square of B by B, turned as the first one."),
  params([From-location, To-location, A-length, B-int]),
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
