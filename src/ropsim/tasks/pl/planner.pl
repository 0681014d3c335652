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
:- use_module(library(solution_sequences)).

most_inferences(3000000).   % so many may be made to find the fewest tasks

:- dynamic seen/3.             % seen(Hash, State, Steps)
:- dynamic looked/2.           % looked(Condition, yes | no)
:- dynamic landmark/3.         % landmark(Fact, Number of its makers, Needs)
:- dynamic made_by/2, meets/2. % made_by(Number, Makers); meets(Number, Numbers of sets with a task of this one)
:- dynamic fact/1.             % what could become true, if nothing ever ceased to be
:- dynamic expanded/1, refusals/1.

%   plan(+Facts, +Goals, -Reply): Reply is plan(Calls, How, Expanded, Inferences) | none(Why, Expanded, Inferences).
%   How: fewest | any, where it is not known whether fewer tasks would do.
%   Why: nobody(Fact) | refused(Fact, Conditions) | exclude(Goal, Goal) | goals_clash.
plan(Facts, Goals, Reply) :-
    forall(member(Old, [seen(_, _, _), looked(_, _), fact(_), expanded(_), refusals(_), refused_lately]),
           retractall(Old)),
    no_landmarks,
    statistics(inferences, Begun),
    assertz(expanded(0)), assertz(refusals(0)),
    ropsim_world:state(Facts, State),
    ropsim_templates:prepared(State, Goals),
    (   unreachable(State, Goals, Why)
    ->  Result = none(Why)
    ;   ropsim_exclusion:exclusive_pair(Goals, State, One, Other)
    ->  Result = none(exclude(One, Other))
    ;   constants(State, Goals, Alike),
        most_inferences(Most), Last is Begun + Most,
        searched(State, Goals, Alike, fewest(Last), Result0),
        (   Result0 = none, Alike \== [] -> retractall(seen(_, _, _)), searched(State, Goals, [], fewest(Last), Result1)
        ;   Result1 = Result0
        ),
        (   Result1 = weary -> retractall(seen(_, _, _)), searched(State, Goals, [], any, Result2) ; Result2 = Result1 ),
        explained(Result2, State, Goals, Result)
    ),
    ( Result1 == weary -> How = any ; How = fewest ),
    expanded(N),
    statistics(inferences, Ended), Inferences is Ended - Begun,
    ( Result = plan(Calls) -> Reply = plan(Calls, How, N, Inferences) ; Result = none(Reason), Reply = none(Reason, N, Inferences) ),
    forall(member(Old, [seen(_, _, _), fact(_)]), retractall(Old)),
    ropsim_templates:forgotten,
    no_landmarks.

no_landmarks :-
    retractall(landmark(_, _, _)), retractall(made_by(_, _)), retractall(meets(_, _)),
    flag(ropsim_landmarks, _, 0).

explained(plan(Calls), _, _, plan(Calls)).
explained(dead(Why), _, _, none(Why)).
explained(none, State, Goals, none(Why)) :-
    (   unreachable(State, Goals, Found) -> Why = Found ; Why = goals_clash ).

%   searched(+State, +Goals, +Alike, +Mode, -Result): plan(Calls) | none | dead(Why) | weary. Mode is fewest(Last): A*, up to so
%   many inferences, or any: a state with fewer landmarks left goes first, however many tasks lead to it (Richter and
%   Westphal 2010).
searched(State, Goals, Alike, Mode, Result) :-
    (   estimate(Mode, Goals, State, H) -> empty_heap(Empty), add_to_heap(Empty, k(H, H, 0), node(State, 0, [], [], [], [], State), Heap)
    ;   empty_heap(Heap)
    ),
    search(Heap, w(State, Goals, Alike, Mode), 0, Result).

search(Heap, World, N, Result) :-
    (   World = w(_, _, _, fewest(Last)), statistics(inferences, Now), Now > Last
    ->  Result = weary
    ;   get_from_heap(Heap, k(F, _, _), Node, Heap1)
    ->  step(F, Node, Heap1, World, N, Result)
    ;   Result = none
    ).

%   A node has the geometry, and the parameters left open, of the task that leads to it, and the state before that task.
step(F, node(State, G, Path, Geo, Free, Instead, Before), Heap, World, N, Result) :-
    (   \+ seen_before(State, G), \+ needless(Instead, Before), allowed(Geo), filled(Free, Before)
    ->  reached(F, State, G, Path, Heap, World, N, Result)
    ;   World = w(Begin, Goals, _, _), hopeless(Begin, Goals, Why)
    ->  Result = dead(Why)
    ;   search(Heap, World, N, Result)
    ).

reached(F, State, G, Path, Heap, World, N, Result) :-
    World = w(_, Goals, Alike, Mode),
    (   ropsim_world:all_hold(Goals, State)
    ->  reverse(Path, Calls), Result = plan(Calls)
    ;   \+ estimate(Mode, Goals, State, _)
    ->  search(Heap, World, N, Result)
    ;   see(State, G),
        counted,
        G1 is G + 1,
        alike(Alike, State, Pairs),
        findall(Next, next(Mode, State, Goals, Pairs, G1, Next), Nexts),
        reverse(Nexts, Last),    % the first of them goes on the heap last and comes from it first
        pushed(Last, s(Mode, G1, F, Path, State), Heap, Heap1, N, N1),
        search(Heap1, World, N1, Result)
    ).

pushed([], _, Heap, Heap, N, N).
pushed([next(H, S, Head, Geo, Free, Instead)|More], From, Heap0, Heap, N0, N) :-
    From = s(Mode, G, F0, Path, Before),
    ( Mode == any -> F is G + 4 * H ; F is max(F0, G + H) ),
    N1 is N0 - 1,
    add_to_heap(Heap0, k(F, H, N1), node(S, G, [Head|Path], Geo, Free, Instead, Before), Heap1),
    pushed(More, From, Heap1, Heap, N1, N).

next(Mode, State, Goals, Pairs, G, next(H, After, Head, Geo, Free, Instead)) :-
    ropsim_templates:template(t(Head, Parameters, Pre, Eff, Geo, Free)),
    distinct(Parameters, ( ropsim_world:all_hold(Pre, State), ropsim_world:chosen(Parameters, State) )),
    ground(Eff-Geo),
    \+ ( member(One, Geo), looked(One, no) ),
    ropsim_world:applied(Eff, State, After),
    After \== State,
    \+ seen_before(After, G),
    estimate(Mode, Goals, After, H),
    findall(Other, exchangeable(Pairs, Head, Geo-Free, Other), Instead).

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

%   filled(+Free, +Before): each group of open parameters has values that its conditions and geometry allow, the first ones.
filled([], _).
filled([one(Parameters, Pre, Geo)|More], Before) :-
    once(( ropsim_world:all_hold(Pre, Before), ropsim_world:chosen(Parameters, Before), ground(Geo), \+ ( member(One, Geo), looked(One, no) ), allowed(Geo) )),
    filled(More, Before).

%   hopeless(+Begin, +Goals, -Why): after a refusal, now and then, whether the goals can still be reached at all.
hopeless(Begin, Goals, Why) :-
    retract(refused_lately),
    refusals(N), ( N =< 16 -> true ; N mod 16 =:= 0 ),
    unreachable(Begin, Goals, Why).

%   estimate(+Mode, +Goals, +State, -H): fails where a fact is missing that nothing can make.
estimate(any, Goals, State, H) :-
    landmarks(Goals, State, [], Numbers),
    length(Numbers, H).
estimate(fewest(_), Goals, State, H) :-
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
    ropsim_templates:template(t(Head, _, Pre, Eff, Geo, _)),
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
    findall(Constant, ( ropsim_templates:template(t(_, Parameters, Pre, Eff, Geo, Free)), within([Parameters, Pre, Eff, Geo, Free], Constant) ), Named1),
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

%   exchangeable(+Pairs, +Head, +Asked, -Other): Geo-Free of the same with something alike instead, which leads to the same.
exchangeable(Pairs, Head, Asked, Other1) :-
    compound(Head),
    arg(_, Head, Later), atomic(Later),
    memberchk(Later-Earlier, Pairs),
    \+ ( arg(_, Head, Other), Other == Earlier ),
    exchanged(Asked, Later, Earlier, Other1).

%   needless(+Instead, +Before): geometry allows one of the others.
needless(Instead, Before) :- member(Geo-Free, Instead), allowed(Geo), \+ \+ filled(Free, Before), !.

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
    ropsim_templates:relaxed(Fact, Parameters, Pre, Geo, Groups),
    could_all(Pre),
    could_fill(Groups, Fact),
    could_choose(Parameters),
    \+ ( member(One, Geo), looked(One, no) ),
    ground(Fact).

%   could_fill(+Groups, ?Fact): values that geometry has not refused are left for all open parameters; what such a group says
%   of the fact is one solution for each.
could_fill([], _).
could_fill([one(Parameters, Pre, Geo)|More], Fact) :-
    Group = ( could_all(Pre), could_choose(Parameters), \+ ( member(One, Geo), ground(One), looked(One, no) ) ),
    (   ground(Fact) -> \+ \+ Group
    ;   term_variables(Fact, Open), term_variables(Pre-Geo, Own),
        include(ropsim_templates:is_in(Own), Open, Keys),
        findall(Keys, Group, All0), sort(All0, All), member(Keys, All)
    ),
    could_fill(More, Fact).

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
    ropsim_templates:template(t(_, Parameters, Pre, Eff, Geo, Free)),
    member(+ Fact, Eff),
    could_all(Pre), could_choose(Parameters),
    (   member(One, Geo)
    ;   member(one(Open, OpenPre, OpenGeo), Free), could_all(OpenPre), could_choose(Open), member(One, OpenGeo)
    ),
    looked(One, no).

%   lacking(+Fact, -Need): what a maker of a fact needs and cannot have; rather about the same thing.
lacking(Fact, Need) :-
    findall(One, needed(Fact, One), Needs),
    (   member(Need, Needs), shared(Fact, Need) -> true
    ;   Needs = [Need|_]
    ).

needed(Fact, Need) :-
    (   ropsim_templates:template(t(_, _, Pre, Eff, _, _)), member(+ Fact, Eff) ; ropsim_kb:rule(Fact, Body), Pre = [Body] ),
    (   member(Need, Pre), \+ could(Need, 20)
    ;   \+ ( member(One, Pre), \+ could(One, 20) ), first_lacking(Pre, Need)
    ).

shared(Fact, Need) :- compound(Fact), arg(_, Fact, Constant), atomic(Constant), within(Need, Constant), !.

first_lacking([One|More], Need) :-
    (   could(One, 20) -> first_lacking(More, Need) ; Need = One ).
