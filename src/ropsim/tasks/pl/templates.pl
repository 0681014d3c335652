/*  The tasks that may serve goals, as far as the goals need them: found from the goals back through effects and conditions.
    What no such task or goal reads is left out, and what no effect names is not grounded.
*/
:- module(ropsim_templates, []).
:- use_module(library(lists)).
:- use_module(library(apply)).
:- use_module(library(ordsets)).
:- use_module(library(pairs)).

:- dynamic raw/1.              % t(Head, Parameters, Pre, Eff, Geo) of the tasks that may serve
:- dynamic template/1.         % t(Head, Parameters, Pre, Eff, Geo, Free) of these, as far as the goals need them; see reduced/3
:- dynamic relaxed/5.          % see relaxed_of/2

forgotten :- retractall(raw(_)), retractall(template(_)), retractall(relaxed(_, _, _, _, _)).

%   prepared(+State, +Goals): template/1 and relaxed/5 of tasks that make, or end, what the goals or other such tasks look at, and all of whose numbers
%   somebody tells.
prepared(State, Goals) :-
    forgotten,
    findall(Name/Arity, ( member(Goal, Goals), ropsim_kb:condition(Goal, Name, Arity) ), Wanted0),
    sort(Wanted0, Wanted),
    findall(Name-t(Head, Parameters, Pre, Eff, Geo),
            ( ropsim_kb:known(Name, _, task(Head, _, Parameters, Pre, Eff, Geo, _, _, _, _)),
              \+ untold(Parameters, Pre, State) ), All),
    relevant(Wanted, [], All, State, Read),
    forall(retract(raw(Template)),
           ( reduced(Template, Read, Reduced), assertz(template(Reduced)),
             forall(relaxed_of(Reduced, Relaxed), assertz(Relaxed)) )).

%   reduced(+Template, +Read, -Reduced): without effects that nothing reads, and with the parameters set apart that effects
%   do not name. These are not grounded: values that conditions and geometry allow are as good as all others. Free is a list
%   of one(Parameters, Pre, Geo), of which no two have such a parameter in common; in Pre1 their variables are others.
reduced(t(Head, Parameters, Pre, Eff0, Geo0), Read, t(Head, Bound, Pre1, Eff, Geo, Free)) :-
    include(is_read(Read), Eff0, Eff),
    term_variables(Eff, Seen),
    partition(open_parameter(Seen), Parameters, Open, Bound),
    term_variables(Bound, Kept),
    copy_term(Kept-Pre, Kept-Pre1),
    exclude(about_any(Open), Geo0, Geo),
    grouped(Open, Pre, Geo0, Free).

%   relaxed_of(+Template, -Relaxed): relaxed(Fact, Bound, Pre, Geo, Groups) for each fact that a task makes. Groups have the
%   parameters that this fact does not name: whether the task can make it is asked of each group alone.
relaxed_of(t(_, Parameters, Pre, Eff, Geo0, Free), relaxed(Fact, Bound, Pre1, Geo, Groups)) :-
    member(+ Fact, Eff),
    term_variables(Fact, Seen),
    partition(open_parameter(Seen), Parameters, Open, Bound),
    exclude(about_any(Open), Pre, Pre1),
    exclude(about_any(Open), Geo0, Geo),
    grouped(Open, Pre, Geo0, Groups0),
    append(Groups0, Free, Groups).

%   grouped(+Open, +Pre, +Geo, -Groups): one(Parameters, Pre, Geo) of the conditions about open parameters.
grouped(Open, Pre, Geo0, Free) :-
    findall(pre, member(_, Pre), PreTags), findall(geo, member(_, Geo0), GeoTags),
    pairs_keys_values(Tagged0, PreTags, Pre), pairs_keys_values(Tagged1, GeoTags, Geo0),
    append(Tagged0, Tagged1, Tagged),
    include(about_any(Open), Tagged, OpenTagged),
    maplist(group_of, Open, Own),
    reverse(OpenTagged, Backwards),    % so that conditions keep their order
    foldl(joined, Backwards, Own, Groups),
    maplist(with_parts, Groups, Free).

group_of(Parameter, g([Parameter], [])).

%   joined(+Condition, +Groups0, -Groups): the groups whose parameters it names are one.
joined(Condition, Groups0, [g(Parameters, [Condition|Conditions])|Apart]) :-
    partition(named_in(Condition), Groups0, Met, Apart),
    foldl(merged, Met, g([], []), g(Parameters, Conditions)).

named_in(Condition, g(Parameters, _)) :- about_any(Parameters, Condition).

merged(g(Ps, Cs), g(Ps0, Cs0), g(Ps1, Cs1)) :- append(Ps0, Ps, Ps1), append(Cs0, Cs, Cs1).

with_parts(g(Parameters, Tagged), one(Parameters, Pre, Geo)) :-
    of_tag(pre, Tagged, Pre), of_tag(geo, Tagged, Geo).

of_tag(_, [], []).
of_tag(Tag, [Tag0-One|More], All) :- ( Tag0 == Tag -> All = [One|Rest] ; All = Rest ), of_tag(Tag, More, Rest).

is_in(Variables, Variable) :- member(V, Variables), V == Variable, !.

is_read(Read, Effect) :-
    arg(1, Effect, Fact), functor(Fact, Name, Arity),
    ( ord_memberchk(Name/Arity, Read) ; world_reads(Name, Arity) ), !.

%   world_reads(?Name, ?Arity): ropsim_world looks at these facts whatever tasks say.
world_reads(at, 2).
world_reads(free, 1).
world_reads(follows, 2).
world_reads(held, 1).
world_reads(gripper, 1).
world_reads(without_gripper, 1).
world_reads(in_rows, 4).
world_reads(Kind, 1) :- ropsim_kb:kind(Kind, _).

open_parameter(Seen, p(Value, _, none)) :- var(Value), \+ ( member(V, Seen), V == Value ).

about_any(Open, Condition) :- term_variables(Condition, Variables), member(p(Value, _, _), Open), member(V, Variables), V == Value, !.

untold(Parameters, Pre, State) :-
    member(p(Value, Kind, none), Parameters),
    ropsim_kb:measured(Kind),
    exclude(ropsim_kb:of_pattern, Pre, Telling),    % they look at numbers and bind none
    term_variables(Telling, Told), \+ ( member(V, Told), V == Value ),
    \+ ropsim_kb:makes(Kind, 1),
    functor(Fact, Kind, 1), \+ memberchk(Fact, State), !.

%   relevant(+Wanted, +Done, +All, +State, -Read): Read are the names of all facts that goals and these tasks look at.
relevant([], Read, _, _, Read) :- !.
relevant(Wanted, Done, All, State, Read) :-
    ord_union(Wanted, Done, Done1),
    partition(serves(Wanted), All, Serving, Others),
    forall(member(_-Template, Serving), assertz(raw(Template))),
    findall(Name/Arity, ( member(_-t(_, _, Pre, _, _), Serving), member(One, Pre), ropsim_kb:condition(One, Name, Arity) ), New0),
    findall(Name/Arity, ( member(Name1/Arity1, Wanted), functor(Head, Name1, Arity1), ropsim_kb:rule(Head, Body),
                          ropsim_kb:condition(Body, Name, Arity) ), New1),
    findall(tool/1, ( memberchk(gripper/1, Wanted), memberchk(without_gripper(_), State) ), New2),    % see ropsim_world:holds
    append([New0, New1, New2], New3), sort(New3, New4),
    ord_subtract(New4, Done1, New),
    relevant(New, Done1, Others, State, Read).

serves(Wanted, _-t(_, _, _, Eff, _)) :-
    member(Effect, Eff), arg(1, Effect, Fact), functor(Fact, Name, Arity),
    ord_memberchk(Name/Arity, Wanted), !.
