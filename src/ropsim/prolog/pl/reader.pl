/*  Reads a text clause by clause and goes on after a mistake. Nothing of the text is run: operators, exported
    operators and libraries take effect, because what follows could not be read without them.

    Places are numbers of characters from the begin of the text.
*/
:- module(ropsim_reader, [check_text/3, syntax_item/2, single/6, ends/3, bare/2]).
:- use_module(library(lists)).
:- use_module(library(apply)).
:- use_module(library(modules)).
:- use_module(library(error)).

%   check_text(+Text, +Known, -Reply): Reply is checked(Items, Unknown, Names).
%   Items:   error(Place, Message) | clause(From, To, Name/Arity, HeadFrom, HeadTo, Singletons) | directive(From, To)
%            | declared(Name/Arity)
%   Unknown: call(Name/Arity, From, To), of what neither the text nor Prolog nor its libraries define.
%   Own, Others: indicators of this text, and those elsewhere that begin as an unknown one does.
check_text(Text, Module, checked(Items, Unknown, Own, Others)) :-
    in_temporary_module(Scratch, true, checked_in(Scratch, Module, Text, Items, Unknown, Own-Others)).

:- public checked_in/6.
checked_in(Scratch, Module, Text, Items, Unknown, Names) :-
    setup_call_cleanup(open_string(Text, Stream),
                       read_items(Stream, Scratch, Module, Items, Calls),
                       close(Stream)),
    defined_here(Items, Here),
    include(is_unknown(Scratch, Here), Calls, Unknown),
    like_names(Unknown, Here, Names).

read_items(Stream, Scratch, Module, Items, Calls) :-
    catch(read_term(Stream, Term, [ module(Scratch), subterm_positions(Positions), variable_names(Names),
                                    singletons(Singletons), syntax_errors(error) ]),
          Error, true),
    (   nonvar(Error)
    ->  syntax_item(Error, Item),
        Items = [Item|Items1],
        (   at_end_of_stream(Stream) -> Items1 = [], Calls = []
        ;   read_items(Stream, Scratch, Module, Items1, Calls)
        )
    ;   Term == end_of_file
    ->  Items = [], Calls = []
    ;   item(Term, Positions, Names-Singletons, Scratch, Module, Found, Items, Items1),
        append(Found, Calls1, Calls),
        read_items(Stream, Scratch, Module, Items1, Calls1)
    ).

syntax_item(error(syntax_error(Message), Context), error(Place, Message)) :- !, character(Context, Place).
syntax_item(Error, _) :- throw(Error).

character(stream(_, _, _, Place), Place) :- !.
character(file(_, _, _, Place), Place) :- !.
character(string(_, Place), Place) :- !.
character(_, 0).

item((:- Directive), Positions, _, Scratch, _, [], [directive(From, To)|Rest], Tail) :-
    !,
    ends(Positions, From, To),
    ignore(catch(take_effect(Directive, Scratch), _, true)),
    findall(declared(Indicator), declared(Directive, Indicator), Declared),
    append(Declared, Tail, Rest).
item((?- _), Positions, _, _, _, [], [directive(From, To)|Tail], Tail) :- !, ends(Positions, From, To).
item(Term, Positions, Variables, Scratch, Module, Calls, [Item|Tail], Tail) :-
    ends(Positions, From, To),
    parts(Term, Positions, Head, HeadPosition, Body, BodyPosition, More),
    (   callable(Head) -> functor(Head, Name, Arity0) ; Name = '?', Arity0 = 0 ),
    Arity is Arity0 + More,
    ends(HeadPosition, HeadFrom, HeadTo),
    findall(single(Single, F, T), single(Variables, Term, Positions, Single, F, T), Singles),
    Item = clause(From, To, Name/Arity, HeadFrom, HeadTo, Singles),
    findall(Call, called(Body, BodyPosition, Scratch, Module, Call), Calls).

parts((Head0 :- Body), P0, Head, HeadPosition, Body, BodyPosition, 0) :-
    !, bare(P0, term_position(_, _, _, _, [P1, BodyPosition])), plain_head(Head0, P1, Head, HeadPosition).
parts((Head0 --> _), P0, Head, HeadPosition, true, 0-0, 2) :-
    !, bare(P0, term_position(_, _, _, _, [P1, _])), plain_head(Head0, P1, Head, HeadPosition).
parts(Head0, P0, Head, HeadPosition, true, 0-0, 0) :- plain_head(Head0, P0, Head, HeadPosition).

plain_head(Head, P, Head, P) :- var(Head), !.
plain_head((_:Head), P0, Head, P) :- bare(P0, term_position(_, _, _, _, [_, P])), !.
plain_head((Head, _), P0, Head, P) :- bare(P0, term_position(_, _, _, _, [P, _])), !.
plain_head(Head, P, Head, P).

bare(parentheses_term_position(_, _, P0), P) :- !, bare(P0, P).
bare(P, P).

ends(P0, From, To) :- arg(1, P0, From), arg(2, P0, To), !.
ends(_, 0, 0).

single(_-Singletons, Term, Positions, Name, From, To) :-
    member(Name=Variable, Singletons),
    \+ sub_atom(Name, 0, 1, _, '_'),
    once(place_of(Term, Positions, Variable, From, To)).

%   place_of(+Term, +Positions, +Variable, -From, -To): where a variable stands first.
place_of(Term, From-To, Variable, From, To) :- !, Term == Variable.
place_of(Term, parentheses_term_position(_, _, P), Variable, From, To) :- !, place_of(Term, P, Variable, From, To).
place_of({Term}, brace_term_position(_, _, P), Variable, From, To) :- !, place_of(Term, P, Variable, From, To).
place_of(Term, term_position(_, _, _, _, Ps), Variable, From, To) :-
    compound(Term), !,
    nth1(N, Ps, P), arg(N, Term, Argument),
    place_of(Argument, P, Variable, From, To).
place_of(Term, list_position(_, _, Ps, TailPosition), Variable, From, To) :-
    in_list(Ps, TailPosition, Term, Variable, From, To).

in_list([P|Ps], TailPosition, [Head|Tail], Variable, From, To) :-
    (   place_of(Head, P, Variable, From, To) ; in_list(Ps, TailPosition, Tail, Variable, From, To) ).
in_list([], P, Term, Variable, From, To) :- P \== none, place_of(Term, P, Variable, From, To).

%   called(+Body, +Positions, +Scratch, +Module, -Call): a goal of a body, or one that a goal is given to call.
called(Body, _, _, _, _) :- var(Body), !, fail.
called(Body, P0, Scratch, Module, Call) :-
    bare(P0, P),
    called_(Body, P, Scratch, Module, Call).

called_(Qualifier:Goal, term_position(_, _, _, _, [_, P]), Scratch, Module, Call) :-
    !, Qualifier == Module, called(Goal, P, Scratch, Module, Call).
called_(Goal, P, _, _, call(Name/Arity, From, To)) :-
    callable(Goal), \+ control(Goal),
    functor(Goal, Name, Arity),
    name_ends(P, From, To).
called_(Goal, term_position(_, _, _, _, Ps), Scratch, Module, Call) :-
    callable(Goal),
    (   control(Goal) -> Specification = control ; meta(Scratch, Goal, Specification) ),
    nth1(N, Ps, P), arg(N, Goal, Argument),
    (   Specification == control -> Kind = 0 ; arg(N, Specification, Kind) ),
    passed(Kind, Argument, P, Scratch, Module, Call).

passed(0, Goal, P, Scratch, Module, Call) :- called(Goal, P, Scratch, Module, Call).
passed(^, Goal, P, Scratch, Module, Call) :- within(Goal, P, Inner, InnerP), called(Inner, InnerP, Scratch, Module, Call).
passed(More, Goal, P0, _, _, call(Name/Arity, From, To)) :-
    integer(More), More > 0, callable(Goal), \+ lambda(Goal), Goal \= _:_,
    functor(Goal, Name, Arity0), Arity is Arity0 + More,
    bare(P0, P), name_ends(P, From, To).

within(Goal, P, Goal, P) :- var(Goal), !.
within(_^Goal, P0, Inner, InnerP) :- bare(P0, term_position(_, _, _, _, [_, P])), !, within(Goal, P, Inner, InnerP).
within(Goal, P, Goal, P).

lambda(_>>_).
lambda(_/_).

name_ends(term_position(_, _, From, To, _), From, To) :- !.
name_ends(P, From, To) :- ends(P, From, To).

control((_, _)).
control((_ ; _)).
control((_ -> _)).
control((_ *-> _)).
control(\+ _).
control(!).

meta(Scratch, Goal, Specification) :- catch(predicate_property(Scratch:Goal, meta_predicate(Specification)), _, fail).

%   What a directive does to the reading of what follows.
take_effect((A, B), Scratch) :- !, take_effect(A, Scratch), take_effect(B, Scratch).
take_effect(op(Priority, Type, Names), Scratch) :- !, own_operators(Names), op(Priority, Type, Scratch:Names).
take_effect(module(_, Exports), Scratch) :-
    !, forall(member(op(Priority, Type, Name), Exports), take_effect(op(Priority, Type, Name), Scratch)).
take_effect(use_module(library(Name)), Scratch) :- !, Scratch:use_module(library(Name)).
take_effect(use_module(library(Name), _), Scratch) :- !, Scratch:use_module(library(Name)).
take_effect(_, _).

own_operators(Names) :- is_list(Names), !, maplist(own_operators, Names).
own_operators(Name) :- atom(Name).

declared(Directive, _) :- var(Directive), !, fail.
declared((A, B), Indicator) :- !, ( declared(A, Indicator) ; declared(B, Indicator) ).
declared(Directive, Indicator) :-
    Directive =.. [Kind|Arguments],
    memberchk(Kind, [dynamic, discontiguous, multifile, table, thread_local]),
    member(Argument, Arguments),
    indicator(Argument, Indicator).

indicator(Term, _) :- var(Term), !, fail.
indicator((A, B), Indicator) :- !, ( indicator(A, Indicator) ; indicator(B, Indicator) ).
indicator([A|B], Indicator) :- !, ( indicator(A, Indicator) ; indicator(B, Indicator) ).
indicator(_:Term, Indicator) :- !, indicator(Term, Indicator).
indicator(Term as _, Indicator) :- !, indicator(Term, Indicator).
indicator(Name/Arity, Name/Arity) :- atom(Name), integer(Arity), !.
indicator(Name//Arity0, Name/Arity) :- atom(Name), integer(Arity0), !, Arity is Arity0 + 2.

defined_here(Items, Here) :-
    findall(Indicator-x, ( member(Item, Items), defines(Item, Indicator) ), Pairs),
    sort(Pairs, Sorted),
    list_to_assoc(Sorted, Here).

defines(clause(_, _, Indicator, _, _, _), Indicator).
defines(declared(Indicator), Indicator).

is_unknown(Scratch, Here, call(Name/Arity, _, _)) :-
    \+ get_assoc(Name/Arity, Here, _),
    functor(Head, Name, Arity),
    \+ catch(predicate_property(Scratch:Head, visible), _, fail).

like_names([], _, []-[]) :- !.
like_names(Unknown, Here, Own-Others) :-
    assoc_to_keys(Here, Own),
    findall(First, ( member(call(Name/_, _, _), Unknown), sub_atom(Name, 0, 1, _, First) ), Firsts0),
    sort(Firsts0, Firsts),
    findall(Name/Arity,
            ( member(Module, [system, lists, apply, ropsim_door]),
              current_predicate(Module:Name/Arity), sub_atom(Name, 0, 1, _, First), memberchk(First, Firsts) ),
            Others).
