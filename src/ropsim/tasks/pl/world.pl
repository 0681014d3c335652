/*  States of a cell as ordered sets of facts: what holds in them, what a task makes of them, what a call lacks.
    Conditions and rules are interpreted here and never called.
*/
:- module(ropsim_world, []).
:- use_module(library(lists)).
:- use_module(library(apply)).
:- use_module(library(ordsets)).
:- use_module(library(assoc)).
:- use_module(library(solution_sequences)).

:- dynamic answered/2.         % answered(Condition, yes | no) of the call that is checked

most_ways(200).                % so many ways to fill in what is not told are tried
deepest_rule(40).              % rules may lean on each other so deep

%   state(+Facts, -State): with what always holds.
state(Facts, State) :-
    findall(Fact, ropsim_kb:standing(Fact), Standing),
    append(Facts, Standing, All),
    sort(All, State).

all_hold([], _).
all_hold([One|More], State) :- holds(One, State), all_hold(More, State).

%   holds(+Condition, +State): a condition over facts, with its variables bound in every way.
holds(Condition, State) :- deepest_rule(D), holds(Condition, State, D).

holds(Condition, _, _) :- var(Condition), !, fail.
holds((A, B), State, D) :- !, holds(A, State, D), holds(B, State, D).
holds((A ; B), State, D) :- !, ( holds(A, State, D) ; holds(B, State, D) ).
holds(\+ A, State, D) :- !, \+ holds(A, State, D).
holds(A = B, _, _) :- !, A = B.
holds(A \= B, _, _) :- !, A \= B.
holds(A == B, _, _) :- !, A == B.
holds(A \== B, _, _) :- !, A \== B.
holds(true, _, _) :- !.
holds(enough(Place, Columns, Rows), State, _) :- !, \+ too_few(Place, Columns, Rows, State).
holds(vacant(First, Columns, Rows, Distance), State, _) :- !,
    \+ ( place_in(First, Columns, Rows, Distance, Place), memberchk(at(_, Place), State) ).
holds(filled(First, Columns, Rows, Distance), State, _) :- !, \+ ( place_in(First, Columns, Rows, Distance, Place), ord_memberchk(free(Place), State) ).
holds(gripper(_), State, _) :- gripperless(State, _), !, fail.
holds(Fact, State, D) :-
    (   ground(Fact), ord_memberchk(Fact, State)
    ->  true
    ;   member(Fact, State)
    ;   ropsim_kb:rule(Fact, Body), D > 0, D1 is D - 1, holds(Body, State, D1)
    ).

%   too_few(+Place, +Columns, +Rows, +State): it is known how many parts lie at a place, with those that wait behind them,
%   and they are fewer than a pattern takes. Of what is no number, and of a place of which nothing is known, nobody knows.
too_few(Place, Columns, Rows, State) :-
    integer(Columns), integer(Rows),
    left_at(Place, State, Left),
    Left < Columns * Rows.

%   left_at(+Place, +State, -Left): how many parts can be taken at a place, one after the other.
left_at(Place, State, Left) :-
    (   memberchk(at(Part, Place), State)
    ->  findall(Before-Next, member(follows(Next, Before), State), Pairs),
        sort(1, @<, Pairs, Queue), list_to_assoc(Queue, Behind),
        queue(Part, Behind, 1, Left)
    ;   ord_memberchk(free(Place), State),
        Left = 0
    ).

queue(Part, Behind0, N, Left) :-
    (   del_assoc(Part, Behind0, Next, Behind)    % so that a queue that leads to itself ends
    ->  N1 is N + 1,
        queue(Next, Behind, N1, Left)
    ;   Left = N
    ).

%   place_in(+First, +Columns, +Rows, +Distance, -Place): each place of a pattern.
place_in(First, Columns, Rows, Distance, Place) :-
    ground(First-Columns-Rows-Distance),
    ropsim_door:places_in_rows(First, Columns, Rows, Distance, Places),
    member(Place, Places).

%   unknown_in(+Pre, +State, -Unknown): of(Places, All) for each pattern of which it is not known whether parts lie at all
%   places.
unknown_in(Pre, State, Unknown) :-
    findall(of(Count, All),
            (   member(filled(First, Columns, Rows, Distance), Pre),
                findall(Place, place_in(First, Columns, Rows, Distance, Place), Places),
                exclude(lies_at(State), Places, Open),
                Open \== [], length(Open, Count), length(Places, All)
            ), Unknown).

lies_at(State, Place) :- memberchk(at(_, Place), State).

%   gripperless(+State, -Tool): a tool without a gripper is on the arm; one in the rack is neither open nor closed.
gripperless(State, Tool) :- memberchk(without_gripper(_), State), member(tool(Tool), State), ord_memberchk(without_gripper(Tool), State), !.

%   applied(+Effects, +State, -After): what no longer holds goes first, then supplies bring what follows.
applied(Effects, State, After) :-
    findall(Fact, ( member(- Fact, Effects), Fact \= in_rows(_, _, _, _) ), Gone0), sort(Gone0, Gone),
    findall(Fact, ( member(+ Fact, Effects), Fact \= in_rows(_, _, _, _) ), New0), sort(New0, New),
    ord_subtract(State, Gone, Kept),
    ord_union(Kept, New, State1),
    supplied(Gone, State, State1, State2),
    (   member(Effect, Effects), arg(1, Effect, in_rows(_, _, _, _))
    ->  in_rows(Effects, Gone, State2, State3),
        findall(Place, ( member(at(Part, Place), Gone), ord_memberchk(at(Part, Place), State) ), Places),
        foldl(settled, Places, State3, After)
    ;   After = State2
    ).

%   supplied(+Gone, +Before, +State, -After): where a part was taken at its supply the one that follows it lies.
supplied(Gone, Before, State, After) :-
    (   memberchk(follows(_, _), State), member(at(Part, Place), Gone), memberchk(follows(Next, Part), State),
        ord_memberchk(at(Part, Place), Before)
    ->  ord_subtract(State, [free(Place), follows(Next, Part)], Kept),    % in standard order
        ord_union(Kept, [at(Next, Place)], State1),
        exclude(==(at(Part, Place)), Gone, Others),
        supplied(Others, Before, State1, After)
    ;   After = State
    ).

%   settled(+Place, +State, -After): where the parts of a pattern were taken it is either free, or a part lies there.
settled(Place, State, After) :-
    (   memberchk(at(_, Place), State)
    ->  ord_subtract(State, [free(Place)], After)
    ;   ord_union(State, [free(Place)], After)
    ).

%   in_rows(+Effects, +Gone, +State, -After): what lies at the places of a pattern behind the first one, in their order.
in_rows(Effects, Gone, State, After) :-
    findall(Effect, ( member(Effect, Effects), arg(1, Effect, in_rows(_, _, _, _)) ), Patterns),
    foldl(pattern(Gone), Patterns, State, After).

pattern(Gone, Effect, State, After) :-
    arg(1, Effect, in_rows(at(Part, First), Columns, Rows, Distance)),
    (   ropsim_door:places_in_rows(First, Columns, Rows, Distance, [_|Places])
    ->  (   Effect = - _
        ->  findall(at(One, Place), ( member(Place, Places), member(at(One, Place), State) ), Taken0),
            sort(Taken0, Taken), ord_subtract(State, Taken, After)
        ;   member(at(Part, Supply), Gone)
        ->  laid(Places, Supply, State, After)
        ;   After = State
        )
    ;   After = State
    ).

%   laid(+Places, +Supply, +State, -After): the part at a supply and those behind it lie at these places, as far as they go.
laid(Places, Supply, State, After) :-
    (   memberchk(at(Part, Supply), State)
    ->  findall(Before-Next, member(follows(Next, Before), State), Pairs),
        sort(1, @<, Pairs, Queue), list_to_assoc(Queue, Behind),
        taken(Places, Part, Supply, Behind, Gone0, New0),
        sort(Gone0, Gone), sort(New0, New),
        ord_subtract(State, Gone, Kept),
        ord_union(Kept, New, After)
    ;   After = State
    ).

%   taken(+Places, +Part, +Supply, +Behind, -Gone, -New): Part is the one at the supply now.
taken([], Part, Supply, _, [], [at(Part, Supply)]).
taken([Place|Places], Part, Supply, Behind, [at(Part, Supply), free(Place)|Gone], [at(Part, Place)|New]) :-
    (   get_assoc(Part, Behind, Next)
    ->  Gone = [follows(Next, Part)|Gone1],
        taken(Places, Next, Supply, Behind, Gone1, New)
    ;   Gone = [], New = [free(Supply)]
    ).

%   chosen(+Parameters, +State): what preconditions have left open is one of its kind, or the value where none is told.
chosen([], _).
chosen([p(Value, Kind, Default)|More], State) :-
    (   nonvar(Value) -> true
    ;   Default \== none -> Value = Default
    ;   functor(Fact, Kind, 1), arg(1, Fact, Value), member(Fact, State)
    ),
    chosen(More, State).

%   looked(+Geometry): what refuses, by the functions of the host.
looked(in_rows(Condition, Columns, Rows, Distance)) :- !, ropsim_door:in_rows(Condition, Columns, Rows, Distance).
looked(Condition) :- ropsim_door:geometry(Condition).

refusal(Geo, One) :- member(One, Geo), \+ looked(One).

%   check_call(+Name, +Given, +Facts, -Report): Given are the values of all parameters, `_` where they are not told.
%   Report is done(Call, After, Unknown) | refused(Call, Geometry) | lacks(Call, Conditions, Providers) | nothing_for(Kinds).
check_call(Name, Given, Facts, Report) :-
    ropsim_kb:known(Name, _, task(Head, _, Parameters, Pre, Eff, Geo, _, Names, _, _)),
    with_places(Given, Facts, Facts1),
    state(Facts1, State),
    given(Parameters, Given),
    most_ways(Most),
    (   limit(Most, ( all_hold(Pre, State), chosen(Parameters, State) )), \+ refusal(Geo, _)
    ->  applied(Eff, State, After), unknown_in(Pre, State, Unknown), Report = done(Head, After, Unknown)
    ;   all_hold(Pre, State), chosen(Parameters, State)
    ->  findall(One, refusal(Geo, One), Refusals), Report = refused(Head, Refusals)
    ;   fewest(Pre, State, Most, Head-Names, Missing), Missing \== []
    ->  retractall(answered(_, _)),
        findall(of(Index, Provider), ( nth0(Index, Missing, One), provider(One, State, Provider) ), Providers),
        Report = lacks(Head, Missing, Providers, Names)
    ;   findall(Kind, ( member(p(Value, Kind, none), Parameters), var(Value) ), Kinds),
        Report = nothing_for(Kinds)
    ).

%   with_places(+Given, +Facts0, -Facts): a place that is given by numbers is free where nothing is known to lie there.
with_places([], Facts, Facts).
with_places([One|More], Facts0, Facts) :-
    (   given_by_numbers(One), \+ memberchk(at(_, One), Facts0)
    ->  with_places(More, [free(One)|Facts0], Facts)
    ;   with_places(More, Facts0, Facts)
    ).

given_by_numbers(One) :- nonvar(One), ( functor(One, p, _) ; One = in(_, _) ), !.

given([], []).
given([p(Value, _, _)|More], [One|Others]) :-
    ( One == '$open' -> true ; Value = One ),
    given(More, Others).

%   fewest(+Pre, +State, +Most, ?Kept, -Missing): filled in so that the fewest conditions are missing.
fewest(Pre, State, Most, Kept, Missing) :-
    findall(N-way(Kept, M), limit(Most, ( missing(Pre, State, M), length(M, N) )), Ways),
    keysort(Ways, [_-way(Kept, Missing)|_]).

missing([], _, []).
missing([One|More], State, Missing) :-
    (   holds(One, State) *-> Missing = Rest ; Missing = [One|Rest] ),
    missing(More, State, Rest).

%   provider(+Condition, +State, -Name): a task that could make what is missing: what it needs itself holds, or other
%   tasks could make that now. Of more than fifty tasks with such an effect the first ones are looked at.
provider(Condition, State, Name) :- provider(Condition, State, 1, Name).

provider(Condition0, State, Level, Name) :-
    copy_term(Condition0, Condition),
    made_so(Condition, Effect),
    limit(50, candidate(Effect, Name, Parameters, Pre)),
    \+ ropsim_templates:untold(Parameters, Pre, State),
    able(Pre, State, Level).

candidate(Effect, Name, Parameters, Pre) :-
    ropsim_kb:known(Name, _, task(_, _, Parameters, Pre, Eff, _, _, _, _, _)),
    member(Effect, Eff).

made_so(Condition, _) :- var(Condition), !, fail.
made_so(\+ Fact, - Fact) :- !, nonvar(Fact), ropsim_kb:fact(Fact).
made_so(Fact, + Fact) :- ropsim_kb:fact(Fact).

able(Pre, State, Level) :-
    most_ways(Most),
    limit(Most, missing(Pre, State, Missing0)),
    exclude(of_open_place, Missing0, Missing),
    (   Missing == [] -> true ; Level > 0, Level1 is Level - 1, all_made(Missing, State, Level1) ),
    !.

%   of_open_place(+Condition): people may tell a free place by numbers.
of_open_place(free(Place)) :- var(Place).

all_made([], _, _).
all_made([One|More], State, Level) :- could_be_made(One, State, Level), all_made(More, State, Level).

%   could_be_made(+Condition, +State, +Level): asked once for each condition of a call.
could_be_made(Condition, State, Level) :-
    (   answered(Known, Answer), Known =@= Condition
    ->  true
    ;   ( once(provider(Condition, State, Level, _)) -> Answer = yes ; Answer = no ),
        assertz(answered(Condition, Answer))
    ),
    Answer == yes.
