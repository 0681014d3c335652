/*  What the host asks of Prolog. Every predicate that it calls has a request, a ground term, and answers with
    the canonical text of a reply, so that no operator, flag or module of a knowledge base changes what it reads.
*/
:- module(ropsim_engine, []).
:- use_module(host).
:- use_module(reader).
:- use_module(library(sandbox)).
:- use_module(library(lists)).
:- use_module(library(apply)).
:- use_module(library(error)).
:- user:use_module(library(lists)).
:- user:use_module(library(apply)).

%   canonical(+Term, -Text): the text has no operators and keeps nothing of attributed variables but their names.
canonical(Term, Text) :-
    (   acyclic_term(Term) -> true ; type_error(acyclic_term, cyclic) ),
    Options = [quoted(true), ignore_ops(true), brace_terms(false), attributes(ignore), numbervars(false)],
    format(string(Text), '~W', [Term, Options]).

%   solve(+goal(Text, Module, Guard, Inferences), -Reply): a reply for each solution, or one for the error.
solve(Request, Text) :-
    catch(solution(Request, Reply), Error, told(Error, Reply)),
    catch(canonical(Reply, Text), Error, ( told(Error, Told), canonical(Told, Text) )).

solution(goal(GoalText, Module, Guard, Inferences), answer(Bindings)) :-
    term_string(Goal, GoalText, [variable_names(Bindings), module(Module)]),
    run(Inferences, Guard, Module:Goal).

run(none, Guard, Goal) :- !, guarded(Guard, Goal).
run(Inferences, Guard, Goal) :-
    call_with_inference_limit(guarded(Guard, Goal), Inferences, Result),
    (   Result == inference_limit_exceeded -> throw(ropsim_stop(inferences)) ; true ).

guarded(open, Goal) :- call(Goal).
guarded(safe, Goal) :- safe_call(Goal).

told(ropsim_stop(Why), stopped(Why)) :- !.
told(Error, error(Kept, Text)) :-
    (   Error = error(Formal, _) -> Kept = error(Formal) ; Kept = ball(Error) ),
    catch(message_text(Error, Text), _, Text = "").

message_text(Error, Text) :-
    message_to_codes_(Error, Lines),
    with_output_to(string(Text), print_message_lines(current_output, '', Lines)).

message_to_codes_(error(Formal, Context), Lines) :-
    (   nonvar(Context), Context = context(_, Message), nonvar(Message) -> Kept = context(_, Message) ; true ),
    !,
    phrase('$messages':translate_message(error(Formal, Kept)), Lines).
message_to_codes_(Error, Lines) :-
    phrase('$messages':translate_message(Error), Lines).

%   Time: the host is asked after so many inferences whether to go on (flag `heartbeat`).
:- multifile prolog:heartbeat/0.
:- set_prolog_flag(heartbeat, 20000).
prolog:heartbeat :-
    asked(tick, Answer),
    (   Answer == go -> true ; throw(ropsim_stop(Answer)) ).

%   Messages are kept while a text is loaded and thrown away otherwise: nothing is printed.
:- dynamic message/4.
:- multifile user:message_hook/3.
:- dynamic user:message_hook/3.
user:message_hook(Term, Kind, Lines) :- ropsim_engine:keep_message(Term, Kind, Lines).

keep_message(Term, Kind, Lines) :-
    memberchk(Kind, [error, warning]),
    !,
    with_output_to(string(Text), print_message_lines(current_output, '', Lines)),
    place(Term, Line),
    sort_of(Term, Sort),
    assertz(message(Kind, Line, Sort, Text)).
keep_message(_, _, _).

place(error(_, file(_, Line, _, _)), Line) :- integer(Line), !.
place(error(_, stream(_, Line, _, _)), Line) :- integer(Line), !.
place(_, Line) :-
    prolog_load_context(term_position, Position),
    stream_position_data(line_count, Position, Line),
    !.
place(_, 0).

sort_of(error(Formal, _), Sort) :- nonvar(Formal), !, functor(Formal, Sort, _).
sort_of(Term, Sort) :- nonvar(Term), !, functor(Term, Sort, _).
sort_of(_, other).

%   reply(:Goal, ?Reply, -Text): the text of the reply of a goal that has one, or of its error.
:- meta_predicate reply(0, ?, -).
reply(Goal, Reply, Text) :-
    catch(( Goal -> true ; throw(ropsim_no_reply) ), Error, told(Error, Told)),
    (   nonvar(Told) -> canonical(Told, Text) ; canonical(Reply, Text) ).

%   The condition of `:- if(Condition)` is a goal that runs while a text is read, and the sandbox knows nothing of it.
:- wrap_predicate('$expand':'$eval_if'(Condition), ropsim, Wrapped, ropsim_engine:looked_through(Condition, Wrapped)).

looked_through(Condition, Wrapped) :-
    (   current_prolog_flag(sandboxed_load, true)
    ->  '$current_source_module'(Module), safe_goal(Module:Condition)
    ;   true
    ),
    call(Wrapped).

%   check(+check(Text, Module), -Reply): what is wrong with a text, see reader.pl.
check(check(String, Module), Text) :- reply(check_text(String, Module, Reply), Reply, Text).

%   load(+load(Path, Module, Guard), -Reply): reply loaded(Module, Messages).
load(load(Path, Default, Guard), Text) :- reply(load_text(Path, Default, Guard, Reply), Reply, Text).

load_text(Path, Default, Guard, loaded(Module, Messages)) :-
    retractall(message(_, _, _, _)),
    catch(load_in(Path, Default, Guard, Module), Error, note_failure(Error, Default, Module)),
    findall(message(Kind, Line, Sort, Words), retract(message(Kind, Line, Sort, Words)), Messages).

note_failure(ropsim_stop(Why), _, _) :- !, throw(ropsim_stop(Why)).
note_failure(Error, Module, Module) :- print_message(error, Error).

load_in(Path, Default, Guard, Module) :-
    declared_module(Path, Default, Module),
    free_module(Module, Path),
    (   Guard == safe -> Sandboxed = true ; Sandboxed = false ),
    load_files(Module:Path, [sandboxed(Sandboxed), imports([]), silent(true), if(true)]),
    forall(own_predicate(Module, Name, Arity), Module:export(Module:Name/Arity)).

%   What a text defines may be called from everywhere; what it calls is looked through all the same.
own_predicate(Module, Name, Arity) :-
    current_predicate(Module:Name/Arity),
    functor(Head, Name, Arity),
    \+ predicate_property(Module:Head, imported_from(_)).

declared_module(Path, Default, Module) :-
    setup_call_cleanup(open(Path, read, Stream),
                       catch(read_term(Stream, First, []), _, First = none),
                       close(Stream)),
    (   nonvar(First), First = (:- module(Name, _)), atom(Name) -> Module = Name ; Module = Default ).

%   A text never gets a module that something else has: not the system's, not another text's.
:- dynamic owner/2, released/1.
free_module(Module, Path) :- owner(Module, Path), !.
free_module(Module, Path) :-
    \+ owner(Module, _),
    (   current_module(Module), \+ released(Module) -> unused(Module) ; true ),
    !,
    assertz(owner(Module, Path)).
free_module(Module, _) :- permission_error(load, module, Module).

unused(Module) :-
    \+ memberchk(Module, [user, prolog, ropsim_door]),
    module_property(Module, class(user)),
    \+ module_property(Module, file(_)),
    \+ own_predicate(Module, _, _).

%   forget(+Path, -Reply): the text is gone, with all that it defined.
forget(Path, Text) :- reply(forgotten(Path), done, Text).

forgotten(Path) :-
    (   retract(owner(Module, Path)) -> assertz(released(Module)), empty(Module) ; true ),
    unload_file(Path).

%   Unloading alone leaves clauses of a text that was loaded twice where calls still find them.
empty(Module) :-
    findall(Name/Arity, own_predicate(Module, Name, Arity), Own),
    forall(member(Name/Arity, Own), emptied(Module, Name, Arity)).

emptied(Module, Name, Arity) :-
    functor(Head, Name, Arity),
    (   predicate_property(Module:Head, dynamic) -> retractall(Module:Head) ; abolish(Module:Name, Arity) ).

%   put_facts(+facts(Module, Facts), -done): these facts, and no others, are what the host knows in a module.
:- dynamic given/3.
put_facts(facts(Module, Facts), Text) :- reply(give(Module, Facts), done, Text).

give(Module, Facts) :-
    must_be(list(callable), Facts),
    (   owner(Module, Owner), Owner == host -> true ; free_module(Module, host) ),
    forall(retract(given(Module, Name, Arity)), ( functor(Old, Name, Arity), retractall(Module:Old) )),
    forall(member(Fact, Facts), put_fact(Module, Fact)).

put_fact(Module, Fact) :-
    functor(Fact, Name, Arity),
    (   given(Module, Name, Arity)
    ->  true
    ;   assertz(given(Module, Name, Arity)),
        dynamic(Module:Name/Arity),
        Module:export(Module:Name/Arity)
    ),
    assertz(Module:Fact).

%   open_door(+Path, -done): the host has written which of its functions are predicates of all modules.
open_door(Path, Text) :- reply(opened_door(Path), done, Text).

opened_door(Path) :-
    retractall(message(_, _, _, _)),
    load_files(user:Path, [if(true), silent(true)]),
    (   retract(message(error, _, _, Words)) -> throw(ropsim_door(Words)) ; true ).

ask_once(Name, Inputs) :-
    canonical(test(Name, Inputs), Request),
    asked(Request, Reply),
    answered(Reply).

answered(yes).
answered(throw(Error)) :- throw(Error).

ask(Name, Inputs, Outputs) :-
    canonical(open(Name, Inputs), Request),
    setup_call_cleanup(asked(Request, Opened),
                       opened(Opened, Outputs),
                       shut(Opened)).

opened(throw(Error), _) :- throw(Error).
opened(handle(Handle), Outputs) :-
    repeat,
    canonical(next(Handle), Request),
    asked(Request, Reply),
    (   Reply = sol(Found) -> Outputs = Found
    ;   Reply == end -> !, fail
    ;   Reply = throw(Error), throw(Error)
    ).

shut(handle(Handle)) :- !, canonical(close(Handle), Request), asked(Request, _).
shut(_).
