% Work on parts with a tool. Cells have the outputs spindle and glue, and the input screwed_home.

task(screw(P, L, Depth), [
  doc("Drives the screw of the part at a location, until the tool says that it is home."),
  params([P-part, L-location, Depth-length = 10*mm]),
  words([
    word(P, "part", "the part that is screwed"),
    word(L, "screw", "where the screw is when it is home"),
    word(Depth, "depth", "how far the screw goes in")]),
  range([Depth >= 0*mm]),
  pre([tool(screwdriver), at(P, L)]),
  eff([+screwed(P)]),
  geo([reachable(arm, L)]),
  body([
    mov(above(L, Depth + 20*mm)),
    lin(above(L, Depth)),
    set(spindle, on),
    lin(L, [speed(10*mm/s)]),
    wait_until(screwed_home, 2*s),
    set(spindle, off),
    lin(above(L, Depth + 20*mm))])]).
goal(screwed/1).

task(dispense(P, A, B, V), [
  doc("Lays a bead on the part at a location, on the line to another one."),
  params([P-part, A-location, B-location, V-speed = 50*mm/s]),
  words([
    word(P, "part", "the part that gets the bead"),
    word(A, "begin", "where the bead begins"),
    word(B, "end", "where the bead ends"),
    word(V, "speed", "how fast the tool goes along the bead")]),
  range([V > 0*mm/s]),
  pre([tool(dispenser), at(P, A)]),
  eff([+dispensed(P)]),
  geo([reachable(arm, A), reachable(arm, B)]),
  body([
    mov(above(A, 20*mm)),
    lin(A),
    set(glue, on),
    lin(B, [speed(V), fine]),
    set(glue, off),
    lin(above(B, 20*mm))])]).
goal(dispensed/1).

task(inspect(P, L, T), [
  doc("Holds the tool over the part at a location while it is looked at."),
  params([P-part, L-location, T-time = 0.5*s]),
  words([
    word(P, "part", "the part that is looked at"),
    word(L, "place", "where the part lies"),
    word(T, "time", "how long the tool stays over it")]),
  range([T >= 0*s]),
  pre([at(P, L)]),
  eff([+inspected(P)]),
  geo([reachable(arm, L)]),
  body([mov(above(L, 100*mm)), wait(T)])]).
goal(inspected/1).

task(tool_change(Old, New, From, To), [
  doc("Puts the tool down at one place and takes another at a second. Cells have the output tool_lock."),
  params([Old-tool, New-tool, From-location, To-location]),
  words([
    word(Old, "old tool", "the one on the arm"),
    word(New, "new tool", "the one that is wanted"),
    word(From, "rack of the old tool", "where it is put down"),
    word(To, "rack of the new tool", "where it is taken")]),
  pre([tool(Old), home_of(Old, From), home_of(New, To), Old \= New, \+ held(_)]),
  eff([-tool(Old), +tool(New)]),
  geo([reachable(arm, From), reachable(arm, To)]),
  body([
    mov(above(From, 100*mm)), lin(From), set(tool_lock, off), lin(above(From, 100*mm)),
    mov(above(To, 100*mm)), lin(To), set(tool_lock, on), lin(above(To, 100*mm))])]).
given(home_of/2).
