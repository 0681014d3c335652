/*  Reads the texts of a knowledge base as data. Nothing of a text is ever called or defined: a task is a term, a
    fact is a term, and a rule is a term that `holds/2` of world.pl interprets over the facts of a state.

    The host puts the texts as facts ropsim_kb_texts:text(Index, Text); places are numbers of characters.
*/
:- module(ropsim_kb, []).
:- use_module(library(lists)).
:- use_module(library(apply)).

:- dynamic known/3.            % known(Name, Arity, task(Head, Doc, Parameters, Pre, Eff, Geo, Body, Names, Words, Ranges))
:- dynamic place/4.            % place(Name, Text, From, To)
:- dynamic has_read/0.
:- dynamic standing/1, rule/2.
:- dynamic makes/2, reads/2.   % Name, Arity of facts that effects make, that conditions read
:- dynamic later/1.            % what is looked at when all texts have been read
:- dynamic found/5.            % found(Text, From, To, Code, Arguments)

deepest(60).                   % so deep a clause may be nested

%   read_base(-Replies, -Findings): reply(Text, Items) for the findings that the engine words, found/5 for ours.
read_base(Replies, Findings) :-
    forall(member(Old, [has_read/0, known/3, place/4, standing/1, rule/2, makes/2, reads/2, later/1, found/5]),
           emptied(Old)),
    findall(reply(Text, Items), ( ropsim_kb_texts:text(Text, String), read_text(Text, String, Items), Items \== [] ), Replies),
    forall(later(Goal), looked_at(Goal)),
    assertz(has_read),
    findall(found(Text, From, To, Code, Arguments), found(Text, From, To, Code, Arguments), Findings).

emptied(Name/Arity) :- functor(Head, Name, Arity), retractall(Head).

%   read_text(+Text, +String, -Items): closed by hand, as setup_call_cleanup takes longer in WebAssembly than all reading.
read_text(Text, String, Items) :-
    open_string(String, Stream),
    ( catch(items(Stream, Text, Items), Error, true) -> Ended = true ; Ended = fail ),
    close(Stream),
    ( nonvar(Error) -> throw(Error) ; call(Ended) ).

items(Stream, Text, Items) :-
    catch(read_term(Stream, Term, [ module(ropsim_kb_words), subterm_positions(Positions), variable_names(Names),
                                    singletons(Singletons), syntax_errors(error) ]),
          Error, true),
    (   nonvar(Error)
    ->  ropsim_reader:syntax_item(Error, Item),
        Items = [Item|Rest],
        (   at_end_of_stream(Stream) -> Rest = [] ; items(Stream, Text, Rest) )
    ;   Term == end_of_file
    ->  Items = []
    ;   single_items(Singletons, Names, Term, Positions, Items, Rest),
        clause_read(Term, Positions, Names, Text),
        items(Stream, Text, Rest)
    ).

single_items([], _, _, _, Items, Items) :- !.
single_items(Singletons, Names, Term, Positions, [clause(0, 0, '?'/0, 0, 0, Singles)|Rest], Rest) :-
    findall(single(Name, From, To), ropsim_reader:single(Names-Singletons, Term, Positions, Name, From, To), Singles).

found_at(Text, P, Code, Arguments) :- ropsim_reader:ends(P, From, To), assertz(found(Text, From, To, Code, Arguments)).

%   clause_read(+Term, +Positions, +Names, +Text): one clause, alone.
clause_read(Term, P, _, Text) :- \+ shallow(Term), !, found_at(Text, P, deep, []).
clause_read((:- Directive), P, _, Text) :- !, directive(Directive, P, Text).
clause_read((?- _), P, _, Text) :- !, found_at(Text, P, directive, []).
clause_read((_ --> _), P, _, Text) :- !, found_at(Text, P, no_clause, []).
clause_read((Head :- Body), P, _, Text) :- !, rule_read(Head, Body, P, Text).
clause_read(task(Head, Properties), P, Names, Text) :- !, task_read(Head, Properties, P, Names, Text).
clause_read(Term, P, _, Text) :- functor(Term, task, _), !, found_at(Text, P, form, [arguments]).
clause_read(Fact, P, _, Text) :- fact(Fact), !, ( ground(Fact) -> keep_fact(Fact) ; found_at(Text, P, open_fact, []) ).
clause_read(_, P, _, Text) :- found_at(Text, P, no_clause, []).

%   shallow(+Term): a list counts as one term around its elements.
shallow(Term) :- deepest(Deepest), shallow(Term, Deepest).

shallow(Term, _) :- \+ compound(Term), !.
shallow(Term, D) :- D > 0, D1 is D - 1, ( is_list(Term) -> shallow_list(Term, D1) ; functor(Term, _, N), shallow_arguments(N, Term, D1) ).

shallow_list([], _).
shallow_list([One|More], D) :- ( compound(One) -> shallow(One, D) ; true ), shallow_list(More, D).

shallow_arguments(N, Term, D) :-
    (   N =:= 0 -> true
    ;   arg(N, Term, One), ( compound(One) -> shallow(One, D) ; true ),
        N1 is N - 1, shallow_arguments(N1, Term, D)
    ).

directive(Directive, P, Text) :- ( nonvar(Directive), Directive = module(_, _) -> true ; found_at(Text, P, directive, []) ).

fact(Fact) :- callable(Fact), \+ logic(Fact).

logic((_, _)).
logic((_ ; _)).
logic(\+ _).
logic(_ = _).
logic(_ \= _).
logic(_ == _).
logic(_ \== _).
logic(Condition) :- of_pattern(Condition).

%   of_pattern(+Condition): it is about the parts of a pattern; facts tell whether it holds, and none is of its name.
of_pattern(Condition) :- nonvar(Condition), pattern(Condition).

pattern(enough(_, _, _)).
pattern(filled(_, _, _, _)).
pattern(vacant(_, _, _, _)).

keep_fact(goal(Name/Arity)) :- !, note(reads, Name, Arity).     % people ask for such facts
keep_fact(given(Name/Arity)) :- !, note(makes, Name, Arity).    % cells have such facts
keep_fact(Fact) :-
    functor(Fact, Name, Arity),
    assertz(standing(Fact)),
    note(makes, Name, Arity).

note(Kind, Name, Arity) :- Term =.. [Kind, Name, Arity], ( catch(call(Term), _, fail) -> true ; assertz(Term) ).

rule_read(Head, Body, P, Text) :-
    (   fact(Head), \+ functor(Head, task, _)
    ->  functor(Head, Name, Arity),
        note(makes, Name, Arity),
        forall(condition(Body, Name1, Arity1), note(reads, Name1, Arity1)),
        assertz(rule(Head, Body))
    ;   found_at(Text, P, no_rule, [])
    ).

%   condition(+Body, -Name, -Arity): a fact that a condition looks at.
condition(Body, _, _) :- var(Body), !, fail.
condition((A, B), Name, Arity) :- !, ( condition(A, Name, Arity) ; condition(B, Name, Arity) ).
condition((A ; B), Name, Arity) :- !, ( condition(A, Name, Arity) ; condition(B, Name, Arity) ).
condition(\+ A, Name, Arity) :- !, condition(A, Name, Arity).
condition(A, Name, 2) :- of_pattern(A), !, member(Name, [at, follows]).
condition(A, Name, Arity) :- fact(A), A \== true, functor(A, Name, Arity).

%   task_read: the parts of a task, each with its place; a task with an error of form is left out.
task_read(Head, Properties, P0, Names, Text) :-
    ropsim_reader:bare(P0, P),
    arguments(P, [HeadP, PropertiesP]),
    (   \+ callable(Head)
    ->  found_at(Text, HeadP, form, [head])
    ;   \+ is_list(Properties)
    ->  found_at(Text, PropertiesP, form, [properties])
    ;   functor(Head, Name, Arity),
        nb_setval(ropsim_wrong, no),
        properties(Properties, PropertiesP, Text, Parts),
        part(doc, Parts, Doc, _), part(params, Parts, Params, ParamsP), part(pre, Parts, Pre, PreP),
        part(eff, Parts, Eff, EffP), part(geo, Parts, Geo, GeoP), part(body, Parts, Body, BodyP),
        part(words, Parts, Words, WordsP), part(range, Parts, Ranges, RangesP),
        head_read(Head, HeadP, Text),
        parameters_read(Head, HeadP, Params, ParamsP, Text, Parameters),
        term_variables(Parameters, Known),
        each(Words, WordsP, word_read(Known, Text)),
        each(Ranges, RangesP, range_read(Parameters, Text)),
        each(Pre, PreP, pre_read(Known, Text)),
        each(Eff, EffP, eff_read(Known, Text)),
        each(Geo, GeoP, geo_read(Known, Text)),
        statements_read(Body, BodyP, s(Known, Text, Name)),
        ropsim_reader:ends(P, From, To),
        (   nb_getval(ropsim_wrong, yes)
        ->  true
        ;   assertz(later(clash(Name, Arity, Text, HeadP))),
            keep_task(Name, Arity, task(Head, Doc, Parameters, Pre, Eff, Geo, Body, Names, Words, Ranges),
                      place(Name, Text, From, To))
        )
    ).

keep_task(Name, Arity, Task, Place) :-
    (   place(Name, Old, _, _), Place = place(_, New, _, _), layer(Old, Layer), layer(New, Layer)
    ->  true
    ;   retractall(known(Name, _, _)), retractall(place(Name, _, _, _)),
        assertz(known(Name, Arity, Task)), assertz(Place)
    ).

%   layer(+Text, -Layer): by the number of a text (layer.py). Texts come in the order of their numbers, so that tasks of the
%   user take the place of built-in ones, and tasks of the project that of both.
layer(Text, Layer) :- ( Text >= 0 -> Layer = project ; Text >= -1000000 -> Layer = user ; Layer = library ).

wrong(Text, P, Code, Arguments) :- nb_setval(ropsim_wrong, yes), found_at(Text, P, Code, Arguments).

arguments(P0, Ps) :- ropsim_reader:bare(P0, term_position(_, _, _, _, Ps)).

%   each(+List, +Positions, :Goal): Goal(Element, Position) for each element; a place that is not known is the list's.
:- meta_predicate each(+, +, 2).
each([], _, _).
each([One|More], P0, Goal) :-
    (   ropsim_reader:bare(P0, list_position(From, To, [P|Ps], Tail))
    ->  Rest = list_position(From, To, Ps, Tail)
    ;   P = P0, Rest = P0
    ),
    call(Goal, One, P),
    each(More, Rest, Goal).

properties(Properties, P, Text, Parts) :- properties(Properties, P, Text, [], Parts).

properties([], _, _, Parts, Parts).
properties([One|More], P0, Text, Parts0, Parts) :-
    (   ropsim_reader:bare(P0, list_position(From, To, [P|Ps], Tail))
    ->  Rest = list_position(From, To, Ps, Tail)
    ;   P = P0, Rest = P0
    ),
    (   nonvar(One), One =.. [Name, Value], property(Name, Sort), sort_of(Sort, Value)
    ->  ( memberchk(part(Name, _, _), Parts0) -> wrong(Text, P, form, [twice, Name]) ; true ),
        ( arguments(P, [ValueP]) -> true ; ValueP = P ),
        Parts1 = [part(Name, Value, ValueP)|Parts0]
    ;   nonvar(One), functor(One, Name, _), atom(Name)
    ->  wrong(Text, P, property, [Name]), Parts1 = Parts0
    ;   wrong(Text, P, form, [property]), Parts1 = Parts0
    ),
    properties(More, Rest, Text, Parts1, Parts).

property(doc, text).
property(params, list).
property(words, list).
property(range, list).
property(pre, list).
property(eff, list).
property(geo, list).
property(body, list).

sort_of(text, Value) :- ( string(Value) ; atom(Value) ), !.
sort_of(list, Value) :- is_list(Value).

part(Name, Parts, Value, P) :- memberchk(part(Name, Value, P), Parts), !.
part(doc, _, "", 0-0) :- !.
part(_, _, [], 0-0).

%   The head: a name that is no word of statements, and variables that differ.
head_read(Head, P, Text) :-
    Head =.. [Name|Arguments],
    (   shape(Name, _, _) -> wrong(Text, P, word, [Name]) ; true ),
    (   is_set_of_variables(Arguments) -> true ; wrong(Text, P, form, [head_arguments, Name]) ).

is_set_of_variables(Arguments) :-
    maplist(var, Arguments),
    term_variables(Arguments, Variables),
    length(Arguments, N),
    length(Variables, N).

%   parameters_read: p(Variable, Kind, Default) for each argument of the head, in its order; Default is none or a value.
parameters_read(Head, HeadP, Params, ParamsP, Text, Parameters) :-
    Head =.. [Name|Arguments],
    each(Params, ParamsP, parameter_read(Arguments, Text)),
    maplist(parameter_of(Params, Name, HeadP, Text), Arguments, Parameters).

parameter_read(Arguments, Text, One, P) :-
    (   parameter(One, Variable, Kind, _), var(Variable)
    ->  (   \+ ( member(V, Arguments), V == Variable ) -> wrong(Text, P, no_argument, []) ; true ),
        (   atom(Kind), kind(Kind, _) -> true ; wrong(Text, P, kind, [Kind]) )
    ;   wrong(Text, P, parameter, [])
    ).

parameter(One, _, _, _) :- var(One), !, fail.
parameter(V-Kind = Default, V, Kind, Default) :- !.
parameter(V-Kind, V, Kind, none).

parameter_of(Params, Name, HeadP, Text, Argument, p(Argument, Kind, Default)) :-
    (   member(One, Params), parameter(One, V, Kind, Default), V == Argument
    ->  true
    ;   Kind = number, Default = none,
        (   var(Argument) -> wrong(Text, HeadP, untyped, [Name]) ; true )
    ).

%   word_read, range_read: what people call a parameter and know of it, and between which bounds its values are.
word_read(Known, Text, One, P) :-
    (   word(One, V, Word, Sentence), var(V), string(Word), Word \== "", string(Sentence)
    ->  bound(V, Known, Text, P)
    ;   wrong(Text, P, form, [of_word])
    ).

word(One, _, _, _) :- var(One), !, fail.
word(word(V, Word), V, Word, "").
word(word(V, Word, Sentence), V, Word, Sentence).

range_read(Parameters, Text, One, P) :-
    (   nonvar(One), One =.. [Sign, V, Bound], memberchk(Sign, [>=, =<, >, <]), var(V), a_number(Bound),
        member(p(Known, Kind, _), Parameters), Known == V, measured(Kind)
    ->  true
    ;   wrong(Text, P, form, [of_range])
    ).

a_number(Bound) :- var(Bound), !, fail.
a_number(Bound) :- number(Bound), !.
a_number(N * Unit) :- number(N), !, unit(Unit).
a_number(N * Unit / Per) :- number(N), unit(Unit), unit(Per).

unit(Unit) :- atom(Unit).

measured(Kind) :- memberchk(Kind, [num, int, length, angle, time, speed, accel, force]).

%   kind(Kind, Where): whether task text passes it, or it is told by the state.
kind(part, state).
kind(tool, state).
kind(device, state).
kind(thing, state).
kind(location, text).
kind(num, text).
kind(int, text).
kind(bool, text).
kind(str, text).
kind(length, text).
kind(angle, text).
kind(time, text).
kind(speed, text).
kind(accel, text).
kind(force, text).
kind(joints, text).

%   Conditions and effects: known variables only; an anonymous one stands for anything where something is read.
pre_read(_, Text, One, P) :-
    (   var(One) -> wrong(Text, P, condition, []) ; true ),
    forall(condition(One, Name, Arity), ( note(reads, Name, Arity), assertz(later(nobody_makes(Name, Arity, Text, P))) )).

eff_read(Known, Text, One, P) :-
    (   effect(One, Sign, Fact0), effect_fact(Fact0, Fact)
    ->  bound(Fact0, Known, Text, P),
        functor(Fact, Name, Arity),
        (   Sign == + -> note(makes, Name, Arity), assertz(later(nobody_reads(Name, Arity, Text, P))) ; true )
    ;   wrong(Text, P, effect, [])
    ).

%   effect_fact(+Effect, -Fact): in_rows(at(P, L), Columns, Rows, Distance) is about the parts at all places of a pattern.
effect_fact(Effect, Fact) :- functor(Effect, in_rows, _), !, Effect = in_rows(Fact, C, R, D), maplist(var, [C, R, D]), nonvar(Fact), Fact = at(_, _).
effect_fact(Fact, Fact) :- fact(Fact).

effect(One, _, _) :- var(One), !, fail.
effect(+ Fact, +, Fact) :- nonvar(Fact).
effect(- Fact, -, Fact) :- nonvar(Fact).

geo_read(Known, Text, One, P) :-
    (   nonvar(One), One = in_rows(Inner, Columns, Rows, Distance), callable(Inner), Inner \= in_rows(_, _, _, _), maplist(var, [Columns, Rows, Distance])
    ->  bound([Columns, Rows, Distance], Known, Text, P),
        geo_read(Known, Text, Inner, P)
    ;   callable(One), functor(One, Name, Arity), geometry(Name, Arity), asks_of_places(One, Arity)
    ->  bound(One, Known, Text, P)
    ;   callable(One)
    ->  functor(One, Name, Arity), wrong(Text, P, geometry, [Name/Arity])
    ;   wrong(Text, P, geometry, ['?'/0])
    ).

%   in_rows(Condition, Columns, Rows, Distance) is a condition at each place of a pattern that begins at its location.
%   asks_of_places(+Condition, +Arity): its first argument is the name of a robot, its last can be a location.
asks_of_places(Condition, Arity) :-
    arg(1, Condition, Robot), atom(Robot),
    arg(Arity, Condition, Location),
    ( var(Location) ; atom(Location) ; functor(Location, p, _) ; Location = in(_, _) ),
    !.

%   geometry(?Name, ?Arity): as the host tells (tasks/conditions), a robot first and a location last.
geometry(Name, Arity) :- ropsim_kb_geometry:condition(Name, Arity).

bound(Term, Known, Text, P) :-
    term_variables(Term, Variables),
    (   member(V, Variables), \+ ( member(K, Known), K == V ) -> wrong(Text, P, unbound, []) ; true ).

%   The body: statements of the task language as terms.
statements_read(Statements, P, S) :- each(Statements, P, statement_read(S)).

statement_read(S, One, P) :-
    S = s(Known, Text, Own),
    (   var(One)
    ->  wrong(Text, P, statement, ['_'])
    ;   One = call(Called), callable(Called)
    ->  bound(Called, Known, Text, P),
        functor(Called, Name, Arity),
        assertz(later(called(Own, Name, Arity, Text, P)))
    ;   One =.. [Name|Arguments], length(Arguments, Arity), shape(Name, Arity, Inner)
    ->  (   Inner == [] -> bound(One, Known, Text, P) ; inner_read(Inner, Arguments, P, S) )
    ;   callable(One)
    ->  functor(One, Name, Arity), wrong(Text, P, statement, [Name/Arity])
    ;   wrong(Text, P, statement, ['?'])
    ).

%   inner_read(+Inner, +Arguments, ...): which arguments of a statement are lists of statements.
inner_read(Inner, Arguments, P, S) :-
    S = s(Known, Text, _),
    forall(nth1(N, Arguments, Argument),
           (   memberchk(N, Inner)
           ->  ( is_list(Argument) -> inner_place(P, N, InnerP), statements_read(Argument, InnerP, S)
               ; wrong(Text, P, statement, [block]) )
           ;   bound(Argument, Known, Text, P)
           )).

inner_place(P, N, InnerP) :- arguments(P, Ps), nth1(N, Ps, InnerP), !.
inner_place(P, _, P).

%   shape(Name, Arity, Inner): the statements; Inner says which arguments are lists of statements.
shape(mov, 1, []).
shape(mov, 2, []).
shape(lin, 1, []).
shape(lin, 2, []).
shape(circ, 2, []).
shape(circ, 3, []).
shape(spline, 2, []).
shape(spline, 3, []).
shape(open, 0, []).
shape(open, 1, []).
shape(close, 0, []).
shape(close, 1, []).
shape(wait, 1, []).
shape(wait_until, 1, []).
shape(wait_until, 2, []).
shape(set, 1, []).
shape(set, 2, []).
shape(load, 2, []).
shape(call, 1, []).
shape(:=, 2, []).
shape(print, 1, []).
shape(stop, 0, []).
shape(stop, 1, []).
shape(break, 0, []).
shape(continue, 0, []).
shape(repeat, 1, [1]).
shape(repeat, 2, [2]).
shape(repeat_until, 2, [2]).
shape(repeat_until, 3, [3]).
shape(if, 2, [2]).
shape(if, 3, [2, 3]).
shape(while, 2, [2]).
shape(for, 4, [4]).
shape(for, 5, [5]).
shape(for_each, 3, [3]).
shape(with, 2, [2]).

%   looked_at(+What): what only all texts together tell.
looked_at(clash(Name, _, Text, P)) :-
    place(Name, First, From, To),
    (   First == Text, ropsim_reader:ends(P, HeadFrom, _), HeadFrom >= From, HeadFrom =< To
    ->  true
    ;   layer(First, Layer), layer(Text, Layer)
    ->  found_at(Text, P, clash, [Name, First, From, To])
    ;   First > Text, later(clash(Name, _, First, HeadP))
    ->  layer(Text, Behind), found_at(First, HeadP, hides, [Name, Behind])
    ;   true
    ).
looked_at(called(Own, Name, Arity, Text, P)) :-
    (   Own == Name
    ->  found_at(Text, P, itself, [Name])
    ;   known(Name, _, task(_, _, Parameters, _, _, _, _, _, _, _))
    ->  include(passed, Parameters, Passed),
        include(needed, Passed, Needed),
        length(Passed, Most), length(Needed, Least),
        (   Arity >= Least, Arity =< Most -> true ; found_at(Text, P, arity, [Name, Arity, Least, Most]) )
    ;   found_at(Text, P, unknown_task, [Name])
    ).
looked_at(nobody_makes(Name, Arity, Text, P)) :-
    (   makes(Name, Arity) -> true
    ;   world(Name, Arity) -> true
    ;   found_at(Text, P, nobody_makes, [Name/Arity])
    ).
looked_at(nobody_reads(Name, Arity, Text, P)) :-
    (   reads(Name, Arity) -> true
    ;   world(Name, Arity) -> true
    ;   found_at(Text, P, nobody_reads, [Name/Arity])
    ).

passed(p(_, Kind, _)) :- kind(Kind, text).
needed(p(_, _, none)).

%   world(Name, Arity): facts that cells give and people ask for.
world(at, 2).
world(free, 1).
world(held, 1).
world(gripper, 1).
world(tool, 1).
world(without_gripper, 1).
world(follows, 2).
world(part, 1).
world(location, 1).
world(device, 1).

%   ready: the texts have been read; a Prolog that took the place of another one reads them again.
ready :- has_read, !.
ready :- read_base(_, _).

%   heads(-Heads): h(Name, Text, From, To) for each task.
heads(Heads) :-
    findall(h(Name, Text, From, To), ( known(Name, _, _), place(Name, Text, From, To) ), Heads).

%   tasks(+Names, -Tasks): told(Name, Arity, Task) for those that there are.
tasks(Names, Tasks) :-
    findall(told(Name, Arity, Task), ( member(Name, Names), known(Name, Arity, Task) ), Tasks).

%   clause_places(+Name, -Found): clause(From, HeadFrom, HeadTo, ListFrom, ListTo, Properties) with place(Name, From, To)
%   for each property, as the text of the task has them; the clause is read again for it.
clause_places(Name, Found) :-
    place(Name, Text, From, _),
    ropsim_kb_texts:text(Text, String),
    clause_at(String, From, Found).

%   clause_at(+String, +From, -Found): the same for the task that begins at a place of a string.
clause_at(String, From, Found) :-
    sub_string(String, From, _, 0, Rest),
    setup_call_cleanup(open_string(Rest, Stream),
                       read_term(Stream, task(_, Properties), [module(ropsim_kb_words), subterm_positions(P0)]),
                       close(Stream)),
    ropsim_reader:bare(P0, P),
    arguments(P, [HeadP, ListP]),
    shifted(From, HeadP, HeadFrom, HeadTo),
    shifted(From, ListP, ListFrom, ListTo),
    ( ropsim_reader:bare(ListP, list_position(_, _, Ps, _)) -> true ; Ps = [] ),
    maplist(property_place(From), Properties, Ps, Places),
    Found = clause(From, HeadFrom, HeadTo, ListFrom, ListTo, Places).

%   always(-Found): Name/Arity of what rules give, and facts that hold in every state.
always(Found) :-
    findall(Name/Arity, ( ( standing(Fact) ; rule(Fact, _) ), functor(Fact, Name, Arity) ), All),
    sort(All, Found).

%   term_place(+Name, +Part, +Path, -Found): found(From, To) of a term of the text of a task, which is read again for it.
%   Part is a property, or the sign of effects, of which the first number of the path counts those of that sign only. The
%   path has numbers of elements and arguments in turn, from 0.
term_place(Name, Part, Path, found(From, To)) :-
    place(Name, Text, Begin, _),
    ropsim_kb_texts:text(Text, String),
    sub_string(String, Begin, _, 0, Rest),
    setup_call_cleanup(open_string(Rest, Stream),
                       read_term(Stream, task(_, Properties), [module(ropsim_kb_words), subterm_positions(P0)]),
                       close(Stream)),
    arguments(P0, [_, ListP]),
    ( memberchk(Part, [+, -]) -> Property = eff ; Property = Part ),
    nth0(N, Properties, One), functor(One, Property, 1), !,
    element(ListP, N, PropertyP), arguments(PropertyP, [ValueP]),
    (   Property == eff
    ->  Path = [Number], arg(1, One, Effects),
        findall(Index, ( nth0(Index, Effects, Effect), functor(Effect, Part, 1) ), Indexes),
        nth0(Number, Indexes, Index0), element(ValueP, Index0, P)
    ;   follow(Path, ValueP, P)
    ),
    shifted(Begin, P, From, To).

follow([], P, P).
follow([N], P0, P) :- !, element(P0, N, P).
follow([N, M|Path], P0, P) :- element(P0, N, P1), arguments(P1, Ps), nth0(M, Ps, P2), follow(Path, P2, P).

element(P0, N, P) :- ropsim_reader:bare(P0, list_position(_, _, Ps, _)), nth0(N, Ps, P).

property_place(Start, Property, P, place(Name, From, To)) :- functor(Property, Name, _), shifted(Start, P, From, To).

shifted(Start, P, From, To) :- ropsim_reader:ends(P, From0, To0), From is Start + From0, To is Start + To0.

%   terms_read(+Texts, -Found): for each text what is wrong with it as one term of a list; empty where nothing is.
terms_read(Texts, Found) :- maplist(term_fault, Texts, Found).

term_fault(Text, Fault) :-
    string_concat("[", Text, Opened),
    string_concat(Opened, "]", Listed),
    catch(( term_string(List, Listed, [module(ropsim_kb_words)]),
            ( is_list(List), length(List, 1) -> Fault = "" ; Fault = "this is not one term" ) ),
          _, Fault = "this is no term").
