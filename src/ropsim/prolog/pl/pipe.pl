/*  The requests of engine.pl over a pipe, for a Prolog that is a process of its own.

    A frame is a line with a word, a name and a number of characters, and then so many characters. The host
    sends `ask Name Count`, `next - 0`, `cut - 0` and `answer - Count`; it gets `more - Count`, `last - Count`,
    `end - 0`, `done - 0` (after a cut) and `call - Count`. Goals lie on each other: while one waits to be asked
    for its next reply, or waits for an answer of the host, others may be asked and ended.
*/
:- module(ropsim_host, [asked/2, serve/0]).

most_characters(8388608).

:- dynamic pipe/2.
:- nb_setval(ropsim_working, false).

%   serve: answer until the host closes its end; what goals print goes into the file `printed`.
serve :-
    stream_property(In, alias(user_input)),
    stream_property(Out, alias(user_output)),
    set_stream(In, encoding(utf8)),
    set_stream(Out, encoding(utf8)),
    set_stream(In, newline(posix)),
    set_stream(Out, newline(posix)),
    set_stream(In, tty(false)),
    open('printed', append, Printed, [encoding(utf8), buffer(false)]),
    open_string("", Nothing),
    assertz(pipe(In, Out)),
    set_stream(Printed, alias(user_output)),
    set_stream(Printed, alias(user_error)),
    set_stream(Nothing, alias(user_input)),
    set_output(Printed),
    set_input(Nothing),
    send(end, ""),
    waited(ended),
    halt.

%   waited(-What): what the host sends that is no question; questions are answered meanwhile.
waited(What) :-
    repeat,
    command(Command),
    (   Command = ask(Name, Text)
    ->  ( answered(Name, Text) -> true ; true ),
        fail
    ;   What = Command
    ),
    !.

answered(Name, Text) :-
    term_string(Request, Text),
    Goal =.. [Name, Request, Reply],
    (   catch(followed(ropsim_engine:Goal, Last), Error, ( uncaught(Error, Reply), Last = true )),
        (   Last == true
        ->  working(false),
            reply(last, Reply),
            !
        ;   reply(more, Reply),
            waited(Word),
            Word \== next,
            !,
            working(false),
            send(done, "")
        )
    ;   working(false),
        send(end, "")
    ).

%   followed(:Goal, -Last): each solution; Last is true where there are no more.
followed(Goal, Last) :-
    working(true),
    call_cleanup(Goal, Last = true),
    (   working(false)
    ;   working(true),
        fail
    ).

%   While no goal runs the host is not asked whether to go on: it does not listen then.
working(Whether) :- nb_setval(ropsim_working, Whether).

uncaught(Error, Text) :-
    format(string(Words), "~q", [Error]),
    format(string(Text), "uncaught(~q)", [Words]).

reply(Word, Text) :-
    string_length(Text, Count),
    most_characters(Most),
    (   Count > Most -> send(long, Count) ; send(Word, Text) ).

%   asked(+Request, -Reply): a text for the host, and the term of its reply.
asked(tick, go) :- nb_getval(ropsim_working, false), !.
asked(Request, Reply) :-
    working(false),
    send(call, Request),
    waited(answer(Text)),
    working(true),
    term_string(Reply, Text).

command(Command) :-
    pipe(In, _),
    read_string(In, "\n", "", Separator, Line),
    (   Separator == -1
    ->  Command = ended
    ;   split_string(Line, " ", "", [Word, Name, Digits]),
        number_string(Count, Digits),
        read_string(In, Count, Text),
        command_of(Word, Name, Text, Command)
    ).

command_of("ask", Name, Text, ask(Atom, Text)) :- atom_string(Atom, Name).
command_of("next", _, _, next).
command_of("cut", _, _, cut).
command_of("answer", _, Text, answer(Text)).

send(Word, Text) :-
    pipe(_, Out),
    string_length(Text, Count),
    format(Out, "~w - ~d~n~w", [Word, Count, Text]),
    flush_output(Out).
