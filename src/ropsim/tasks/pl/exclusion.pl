/*  Goals that exclude each other, by sets of facts of which one at most is true. */
:- module(ropsim_exclusion, []).
:- use_module(library(lists)).
:- use_module(library(apply)).

%   exclusive_pair(+Goals, +State, -One, -Other): two goals that cannot both be true after any tasks. A set of facts of which
%   one at most is true, and stays so, shows it (a lifted invariant; Helmert 2009): it begins with both goals, and takes
%   in what tasks end when they make one of its facts.
exclusive_pair(Goals, State, One, Other) :-
    append(_, [One|Later], Goals),
    member(Other, Later),
    One \== Other,
    \+ ropsim_kb:rule(One, _), \+ ropsim_kb:rule(Other, _),
    first_set(One, Other, Set),
    invariant(Set, State, 3),
    !.

%   first_set(+One, +Other, -Set): both goals as patterns. What they have in common stays, all else may be anything; or
%   only they themselves.
first_set(One, Other, [One, Other]) :- functor(One, Name, _), \+ functor(Other, Name, _).
first_set(One, Other, Set) :-
    One =.. [Name|Values], Other =.. [Name1|Values1],
    include(in_both(Values1), Values, Common),
    maplist(kept(Common), Values, Open), maplist(kept(Common), Values1, Open1),
    Pattern =.. [Name|Open], Pattern1 =.. [Name1|Open1],
    (   Pattern =@= Pattern1 -> Set = [Pattern] ; Set = [Pattern, Pattern1] ).

in_both(Others, Value) :- memberchk(Value, Others).

kept(Common, Value, Open) :- ( memberchk(Value, Common) -> Open = Value ; true ).

%   invariant(+Set, +State, +Depth): one fact of the set at most is true, now and after any task.
invariant(Set, State, Depth) :-
    findall(Fact, ( member(Fact, State), matches(Set, Fact) ), Facts),
    ( Facts = [] ; Facts = [_] ), !,
    \+ ( memberchk(follows(_, _), State), member(at(Part, _), Set), var(Part) ),    % a supply brings parts to a place
    \+ ( of_place(Set), ropsim_templates:template(t(_, _, _, Eff, _, _)), member(Effect, Eff), arg(1, Effect, in_rows(_, _, _, _)) ),
    (   unbalanced(Set, State, Ended)
    ->  Depth > 0,
        Depth1 is Depth - 1,
        member(More, Ended),
        \+ ( member(Known, Set), Known =@= More ),
        invariant([More|Set], State, Depth1)
    ;   true
    ).

of_place(Set) :- member(Pattern, Set), ( Pattern = at(_, _) ; Pattern = free(_) ), !.

matches(Set, Fact) :- member(Pattern, Set), subsumes_term(Pattern, Fact), !.

%   unbalanced(+Set, +State, -Ended): a task makes a fact of the set and ends none; Ended are patterns of what it ends. None
%   where it makes two.
unbalanced(Set, State, Ended) :-
    step_of(State, Pre, Eff),
    member(+ Fact, Eff),
    member(Pattern, Set), copy_term(Pattern, Fact),
    (   member(+ Second, Eff), Second \== Fact, member(Pattern1, Set), \+ Second \= Pattern1
    ->  Ended = []
    ;   findall(Gone, ( member(- Gone, Eff), member(Needed, Pre), Needed == Gone ), All),
        \+ ( member(Gone, All), matches(Set, Gone) ),
        keys(Set, Keys),
        findall(Open, ( member(Gone, All), opened(Gone, Keys, Open) ), Ended)
    ), !.

%   step_of(+State, -Pre, -Eff): of a task, or of a supply that brings the part that follows.
step_of(_, Pre, Eff) :- ropsim_templates:template(t(_, _, Pre, Eff, _, _)).
step_of(State, [follows(Next, Part), at(Part, Place)], [- follows(Next, Part), + at(Next, Place)]) :-
    memberchk(follows(_, _), State).

keys(Set, Keys) :- findall(Key, ( member(Pattern, Set), arg(_, Pattern, Key), nonvar(Key) ), Keys0), sort(Keys0, Keys).

opened(Fact, Keys, Open) :- Fact =.. [Name|Values], maplist(kept_key(Keys), Values, Opened), Open =.. [Name|Opened].

kept_key(Keys, Value, Open) :- ( nonvar(Value), ( memberchk(Value, Keys) ; Keys == [] ) -> Open = Value ; true ).
