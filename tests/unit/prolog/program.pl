:- dynamic(d/1).
:- dynamic(cnt/1).
p(1). p(2). p(3).
q(2). q(3).
b(1,a). b(2,b). b(1,c).
weight(bolt,7). weight(nut,11). weight(pin,8). weight(clip,5). weight(ring,11).
c1(X) :- p(X), !.
c2(X) :- p(X), X > 1, !.
c2(9).
c3(X) :- ( p(X), X >= 2 -> true ; X = none ).
c4(X) :- \+ \+ X = 1.
c5(X) :- call((p(X), !)).
c5(10).
c6(X) :- p(X), (X = 2, ! ; true).
cnt(0).
d(1). d(2). d(3).
command --> [mov], place.
place --> [pallet].
place --> [table].
digits([D|T]) --> digit(D), digits(T).
digits([D]) --> digit(D).
digit(D) --> [D], { D >= 48, D =< 57 }.
anbn --> [].
anbn --> [a], anbn, [b].
ab --> ( [a] ; [b] ), !, [c].
app([],L,L).
app([H|T],L,[H|R]) :- app(T,L,R).
len([],0).
len([_|T],N) :- len(T,M), N is M+1.
loop(0) :- !.
loop(N) :- N1 is N-1, loop(N1).
