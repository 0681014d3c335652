/*  How Prolog asks its host where both are one process: by a call that the host has given to the program. */
:- module(ropsim_host, [asked/2]).

%   asked(+Request, -Reply): a text, and the term of the reply.
asked(Request, Reply) :- '$js_call'(Request, Reply).
