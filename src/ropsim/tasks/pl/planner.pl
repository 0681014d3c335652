/*  Finds the fewest tasks that make goals true: A* over states, geometry looked at as late as can be.

    The estimate of what is left counts disjoint action landmarks: sets of tasks, no task in two of them, of each of
    which one at least must come (a counting of goals that sees one step further; Helmert and Domshlak 2009). So it is never
    too high, and plans are shortest. What a condition of geometry has refused is learned: no task that needs it is looked
    at again, and an estimate knows when nothing is left that could make a fact.
*/
:- module(ropsim_planner, []).
:- use_module(library(lists)).
:- use_module(library(apply)).
:- use_module(library(ordsets)).
:- use_module(library(heaps)).
:- use_module(library(pairs)).

:- dynamic seen/3.             % seen(Hash, State, Steps)
:- dynamic looked/2.           % looked(Condition, yes | no)
:- dynamic landmark/3.         % landmark(Fact, Number of its makers, Needs)
:- dynamic made_by/2, meets/2. % made_by(Number, Makers); meets(Number, Numbers of sets with a task of this one)
:- dynamic template/1.         % t(Head, Parameters, Pre, Eff, Geo) of the tasks that may serve
:- dynamic fact/1.             % what could become true, if nothing ever ceased to be
:- dynamic expanded/1, refusals/1.

%   plan(+Facts, +Goals, -Reply): Reply is plan(Calls, Expanded) | none(Why, Expanded).
%   Why: nobody(Fact) | refused(Fact, Conditions) | goals_clash.
plan(Facts, Goals, Reply) :-
    forall(member(Old, [seen(_, _, _), looked(_, _), template(_), fact(_), expanded(_), refusals(_), refused_lately]),
           retractall(Old)),
    no_landmarks,
    assertz(expanded(0)), assertz(refusals(0)),
    ropsim_world:state(Facts, State),
    templates(State, Goals),
    (   unreachable(State, Goals, Why)
    ->  Result = none(Why)
    ;   constants(State, Goals, Alike),
        searched(State, Goals, Alike, Result0),
        (   Result0 = none, Alike \== [] -> retractall(seen(_, _, _)), searched(State, Goals, [], Result1) ; Result1 = Result0 ),
        explained(Result1, State, Goals, Result)
    ),
    expanded(N),
    ( Result = plan(Calls) -> Reply = plan(Calls, N) ; Result = none(Reason), Reply = none(Reason, N) ),
    forall(member(Old, [seen(_, _, _), template(_), fact(_)]), retractall(Old)),
    no_landmarks.

no_landmarks :-
    retractall(landmark(_, _, _)), retractall(made_by(_, _)), retractall(meets(_, _)),
    flag(ropsim_landmarks, _, 0).

explained(plan(Calls), _, _, plan(Calls)).
explained(dead(Why), _, _, none(Why)).
explained(none, State, Goals, none(Why)) :-
    (   unreachable(State, Goals, Found) -> Why = Found ; Why = goals_clash ).

%   templates(+State, +Goals): tasks that make, or end, what the goals or other such tasks look at, and all of whose numbers
%   somebody tells.
templates(State, Goals) :-
    findall(Name/Arity, ( member(Goal, Goals), ropsim_kb:condition(Goal, Name, Arity) ), Wanted0),
    sort(Wanted0, Wanted),
    findall(Name-t(Head, Parameters, Pre, Eff, Geo),
            ( ropsim_kb:known(Name, _, task(Head, _, Parameters, Pre, Eff, Geo, _, _, _, _)),
              \+ untold(Parameters, Pre, State) ), All),
    relevant(Wanted, [], All, State).

untold(Parameters, Pre, State) :-
    member(p(Value, Kind, none), Parameters),
    ropsim_kb:measured(Kind),
    exclude(ropsim_kb:of_pattern, Pre, Telling),    % they look at numbers and bind none
    term_variables(Telling, Told), \+ ( member(V, Told), V == Value ),
    \+ ropsim_kb:makes(Kind, 1),
    functor(Fact, Kind, 1), \+ memberchk(Fact, State), !.

relevant([], _, _, _) :- !.
relevant(Wanted, Done, All, State) :-
    ord_union(Wanted, Done, Done1),
    partition(serves(Wanted), All, Serving, Others),
    forall(member(_-Template, Serving), assertz(template(Template))),
    findall(Name/Arity, ( member(_-t(_, _, Pre, _, _), Serving), member(One, Pre), ropsim_kb:condition(One, Name, Arity) ), New0),
    findall(Name/Arity, ( member(Name1/Arity1, Wanted), functor(Head, Name1, Arity1), ropsim_kb:rule(Head, Body),
                          ropsim_kb:condition(Body, Name, Arity) ), New1),
    findall(tool/1, ( memberchk(gripper/1, Wanted), memberchk(without_gripper(_), State) ), New2),    % see ropsim_world:holds
    append([New0, New1, New2], New3), sort(New3, New4),
    ord_subtract(New4, Done1, New),
    relevant(New, Done1, Others, State).

serves(Wanted, _-t(_, _, _, Eff, _)) :-
    member(Effect, Eff), arg(1, Effect, Fact), functor(Fact, Name, Arity),
    ord_memberchk(Name/Arity, Wanted), !.

%   searched(+State, +Goals, +Alike, -Result): plan(Calls) | none | dead(Why).
searched(State, Goals, Alike, Result) :-
    (   estimate(Goals, State, H) -> empty_heap(Empty), add_to_heap(Empty, k(H, H, 0), node(State, 0, [], [], []), Heap)
    ;   empty_heap(Heap)
    ),
    search(Heap, w(State, Goals, Alike), 0, Result).

search(Heap, World, N, Result) :-
    (   get_from_heap(Heap, k(F, _, _), node(State, G, Path, Geo, Instead), Heap1)
    ->  step(F, State, G, Path, Geo, Instead, Heap1, World, N, Result)
    ;   Result = none
    ).

step(F, State, G, Path, Geo, Instead, Heap, World, N, Result) :-
    World = w(Begin, Goals, Alike),
    (   (   seen_before(State, G) ; needless(Instead) ; \+ allowed(Geo) )
    ->  ( hopeless(Begin, Goals, Why) -> Result = dead(Why) ; search(Heap, World, N, Result) )
    ;   ropsim_world:all_hold(Goals, State)
    ->  reverse(Path, Calls), Result = plan(Calls)
    ;   \+ estimate(Goals, State, _)
    ->  search(Heap, World, N, Result)
    ;   see(State, G),
        counted,
        G1 is G + 1,
        alike(Alike, State, Pairs),
        findall(Next, next(State, Goals, Pairs, G1, Next), Nexts),
        reverse(Nexts, Last),    % the first of them goes on the heap last and comes from it first
        pushed(Last, G1, F, Path, Heap, Heap1, N, N1),
        search(Heap1, World, N1, Result)
    ).

pushed([], _, _, _, Heap, Heap, N, N).
pushed([next(H, S, Head, Geo, Instead)|More], G, F0, Path, Heap0, Heap, N0, N) :-
    F is max(F0, G + H),
    N1 is N0 - 1,
    add_to_heap(Heap0, k(F, H, N1), node(S, G, [Head|Path], Geo, Instead), Heap1),
    pushed(More, G, F0, Path, Heap1, Heap, N1, N).

next(State, Goals, Pairs, G, next(H, After, Head, Geo, Instead)) :-
    template(t(Head, Parameters, Pre, Eff, Geo)),
    ropsim_world:all_hold(Pre, State),
    ropsim_world:chosen(Parameters, State),
    ground(Eff-Geo),
    \+ ( member(One, Geo), looked(One, no) ),
    ropsim_world:applied(Eff, State, After),
    After \== State,
    \+ seen_before(After, G),
    estimate(Goals, After, H),
    findall(Geo1, exchangeable(Pairs, Head, Geo, Geo1), Instead).

seen_before(State, G) :- term_hash(State, Hash), seen(Hash, State, Before), Before =< G, !.

see(State, G) :-
    term_hash(State, Hash),
    retractall(seen(Hash, State, _)),
    assertz(seen(Hash, State, G)).

counted :-
    retract(expanded(N0)), N is N0 + 1, assertz(expanded(N)),
    ( N mod 50 =:= 0 -> ropsim_door:plan_progress(N) ; true ).

%   allowed(+Geometry): each condition is asked once; a refusal changes what landmarks are left.
allowed([]).
allowed([One|More]) :-
    (   looked(One, Known) -> true
    ;   ropsim_world:looked(One) -> Known = yes, assertz(looked(One, yes))
    ;   Known = no, assertz(looked(One, no)), no_landmarks,
        retract(refusals(N0)), N is N0 + 1, assertz(refusals(N)),
        assertz(refused_lately)
    ),
    Known == yes,
    allowed(More).

:- dynamic refused_lately/0.

%   hopeless(+Begin, +Goals, -Why): after a refusal, now and then, whether the goals can still be reached at all.
hopeless(Begin, Goals, Why) :-
    retract(refused_lately),
    refusals(N), ( N =< 16 -> true ; N mod 16 =:= 0 ),
    unreachable(Begin, Goals, Why).

%   estimate(+Goals, +State, -H): fails where a fact is missing that nothing can make.
estimate(Goals, State, H) :-
    landmarks(Goals, State, [], Numbers0),
    sort(Numbers0, Numbers),
    conflicts(Numbers, Numbers, Counted),
    keysort(Counted, Sorted),
    disjoint(Sorted, [], 0, H).

%   landmarks(+Missing, +State, +Done, -Numbers): of each fact that is missing, or that all makers of a missing one
%   need: the number of its makers.
landmarks([], _, _, []).
landmarks([Fact|More], State, Done, Numbers) :-
    (   ( ord_memberchk(Fact, State) ; memberchk(Fact, Done) ; \+ ground(Fact) ; ropsim_kb:logic(Fact) ; Fact == true )
    ->  landmarks(More, State, Done, Numbers)
    ;   makers(Fact, Number, Needs),
        (   Number == derived
        ->  Numbers = Numbers1
        ;   Number \== nobody,
            Numbers = [Number|Numbers1]
        ),
        append(More, Needs, More1),
        landmarks(More1, State, [Fact|Done], Numbers1)
    ).

%   Makers that few others meet are taken first: so more of them are disjoint.
conflicts([], _, []).
conflicts([Number|More], All, [Count-m(Number, Met)|Counted]) :-
    meets(Number, Known),
    ord_intersection(Known, All, Met),
    length(Met, Count),
    conflicts(More, All, Counted).

disjoint([], _, H, H).
disjoint([_-m(Number, Met)|More], Chosen, H0, H) :-
    (   Met \== [], \+ ord_disjoint(Met, Chosen)
    ->  disjoint(More, Chosen, H0, H)
    ;   H1 is H0 + 1,
        ord_add_element(Chosen, Number, Chosen1),
        disjoint(More, Chosen1, H1, H)
    ).

%   makers(+Fact, -Number, -Needs): the tasks that make a fact, as a number, and what all of them need.
makers(Fact, Number, Needs) :- landmark(Fact, Number, Needs), !.
makers(Fact, Number, Needs) :-
    (   ropsim_kb:rule(Fact, _)
    ->  Number = derived, Needs = []
    ;   findall(Head-Pre, maker(Fact, Head, Pre), Pairs),
        pairs_keys_values(Pairs, Makers, AllNeeds),
        common(AllNeeds, Needs),
        (   Makers == [] -> Number = nobody ; numbered(Makers, Number) )
    ),
    assertz(landmark(Fact, Number, Needs)).

%   numbered(+Makers, -Number): with the numbers of all that have a task in common with them, on both sides.
numbered(Makers, Number) :-
    flag(ropsim_landmarks, Number, Number + 1),
    findall(Other, ( made_by(Other, Others), meet(Makers, Others) ), Met0),
    sort(Met0, Met),
    assertz(made_by(Number, Makers)),
    assertz(meets(Number, Met)),
    forall(member(Other, Met),
           ( retract(meets(Other, Old)), ord_add_element(Old, Number, New), assertz(meets(Other, New)) )).

meet(One, Other) :- member(Head, One), \+ \+ memberchk(Head, Other), !.

maker(Fact, Head, Ground) :-
    template(t(Head, _, Pre, Eff, Geo)),
    member(+ Fact, Eff),
    \+ ( member(One, Geo), ground(One), looked(One, no) ),
    \+ ( member(-One, Eff), One == Fact, \+ ( member(+Two, Eff), Two == Fact ) ),
    findall(One, ( member(One, Pre), ground(One), \+ ropsim_kb:logic(One), \+ ropsim_kb:rule(One, _) ), Ground0),
    sort(Ground0, Ground).

common([], []).
common([First|More], Needs) :- foldl(ord_intersection, More, First, Needs).

%   constants(+State, +Goals, -Alike): what neither goals nor tasks name; such things may be like each other.
constants(State, Goals, Alike) :-
    findall(Constant, ( member(Fact, State), compound(Fact), arg(_, Fact, Constant), atomic(Constant) ), All),
    findall(Constant, ( member(Goal, Goals), within(Goal, Constant) ), Named0),
    findall(Constant, ( template(t(_, Parameters, Pre, Eff, Geo)), within([Parameters, Pre, Eff, Geo], Constant) ), Named1),
    findall(Constant, ( ropsim_kb:rule(Head, Body), within([Head, Body], Constant) ), Named2),
    append([Named0, Named1, Named2], Named),
    sort(All, Sorted), sort(Named, Named3),
    ord_subtract(Sorted, Named3, Alike).

within(Term, Constant) :- var(Term), !, fail, Constant = _.
within(Term, Constant) :- atomic(Term), !, Constant = Term.
within(Term, Constant) :- arg(_, Term, Argument), within(Argument, Constant).

%   alike(+Constants, +State, -Pairs): Later-Earlier, of which the same holds in a state but for the name.
alike([], _, []) :- !.
alike(Constants, State, Pairs) :-
    findall(Constant-About,
            ( member(Fact, State), compound(Fact), arg(N, Fact, Constant), atomic(Constant),
              ord_memberchk(Constant, Constants), about(Fact, N, About) ),
            All),
    keysort(All, Sorted),
    group_pairs_by_key(Sorted, Groups),
    transpose_pairs(Groups, ByAbout),
    group_pairs_by_key(ByAbout, Classes),
    findall(Later-Earlier, ( member(_-Class, Classes), nextto(Earlier, Later, Class) ), Pairs).

about(Fact, N, Name-Others) :- Fact =.. [Name|Arguments], nth1(N, Arguments, _, Rest), Others = N-Rest.

%   exchangeable(+Pairs, +Head, +Geo, -Geo1): the geometry of the same with something alike instead, which leads to the same.
exchangeable(Pairs, Head, Geo, Geo1) :-
    compound(Head),
    arg(_, Head, Later), atomic(Later),
    memberchk(Later-Earlier, Pairs),
    \+ ( arg(_, Head, Other), Other == Earlier ),
    exchanged(Geo, Later, Earlier, Geo1).

%   needless(+Instead): geometry allows one of the others.
needless(Instead) :- member(Geo, Instead), allowed(Geo), !.

exchanged(Term, Later, Earlier, Earlier) :- Term == Later, !.
exchanged(Term, Later, Earlier, Changed) :-
    compound(Term), !,
    Term =.. [Name|Arguments],
    exchanged_all(Arguments, Later, Earlier, Changed0),
    Changed =.. [Name|Changed0].
exchanged(Term, _, _, Term).

exchanged_all([], _, _, []).
exchanged_all([One|More], Later, Earlier, [Changed|Others]) :-
    exchanged(One, Later, Earlier, Changed),
    exchanged_all(More, Later, Earlier, Others).

%   unreachable(+State, +Goals, -Why): even if nothing ever ceased to be true, a goal could not become true.
unreachable(State, Goals, Why) :-
    retractall(fact(_)),
    forall(member(Fact, State), assertz(fact(Fact))),
    grown,
    member(Goal, Goals),
    \+ could(Goal, 20),
    !,
    why(Goal, [], Why).

grown :-
    findall(Fact, ( made(Fact), \+ fact(Fact) ), New0),
    sort(New0, New),
    (   New == [] -> true
    ;   forall(member(Fact, New), assertz(fact(Fact))), grown
    ).

made(at(Next, Place)) :- fact(follows(Next, Part)), fact(at(Part, Place)).    % its supply brings it
made(Fact) :-
    template(t(_, Parameters, Pre, Eff, Geo)),
    could_all(Pre),
    could_choose(Parameters),
    \+ ( member(One, Geo), looked(One, no) ),
    member(+ Fact, Eff),
    ground(Fact).

could_all([]).
could_all([One|More]) :- could(One, 20), could_all(More).

could_choose([]).
could_choose([p(Value, Kind, Default)|More]) :-
    (   nonvar(Value) -> true
    ;   Default \== none -> Value = Default
    ;   functor(Fact, Kind, 1), arg(1, Fact, Value), fact(Fact)
    ),
    could_choose(More).

could(Condition, _) :- var(Condition), !, fail.
could((A, B), D) :- !, could(A, D), could(B, D).
could((A ; B), D) :- !, ( could(A, D) ; could(B, D) ).
could(\+ _, _) :- !.
could(A = B, _) :- !, A = B.
could(A \= B, _) :- !, ( ground(A-B) -> A \= B ; true ).
could(A == B, _) :- !, ( ground(A-B) -> A == B ; true ).
could(A \== B, _) :- !, ( ground(A-B) -> A \== B ; true ).
could(true, _) :- !.
could(Condition, _) :- ropsim_kb:of_pattern(Condition), !.
could(Fact, _) :- fact(Fact).
could(Fact, D) :- ropsim_kb:rule(Fact, Body), D > 0, D1 is D - 1, could(Body, D1).

%   why(+Condition, +Asked, -Why): what nobody makes, or what geometry refuses, behind a condition.
why(Condition, Asked, nobody(Condition)) :- member(One, Asked), One =@= Condition, !.
why((A, B), Asked, Why) :- !, ( \+ could(A, 20) -> why(A, Asked, Why) ; why(B, Asked, Why) ).
why(Condition, Asked, Why) :-
    (   setof(One, refuses(Condition, One), Refused)
    ->  Why = refused(Condition, Refused)
    ;   lacking(Condition, Need)
    ->  why(Need, [Condition|Asked], Why)
    ;   Why = nobody(Condition)
    ).

refuses(Fact, One) :-
    template(t(_, Parameters, Pre, Eff, Geo)),
    member(+ Fact, Eff),
    could_all(Pre), could_choose(Parameters),
    member(One, Geo), looked(One, no).

%   lacking(+Fact, -Need): what a maker of a fact needs and cannot have; rather about the same thing.
lacking(Fact, Need) :-
    findall(One, needed(Fact, One), Needs),
    (   member(Need, Needs), shared(Fact, Need) -> true
    ;   Needs = [Need|_]
    ).

needed(Fact, Need) :-
    (   template(t(_, _, Pre, Eff, _)), member(+ Fact, Eff) ; ropsim_kb:rule(Fact, Body), Pre = [Body] ),
    (   member(Need, Pre), \+ could(Need, 20)
    ;   \+ ( member(One, Pre), \+ could(One, 20) ), first_lacking(Pre, Need)
    ).

shared(Fact, Need) :- compound(Fact), arg(_, Fact, Constant), atomic(Constant), within(Need, Constant), !.

first_lacking([One|More], Need) :-
    (   could(One, 20) -> first_lacking(More, Need) ; Need = One ).
