"""The browser studio: a web process that serves the pages, and worker processes that compute for it.

`ropsim.studio.server` is entered by the command `ropsim studio` only; this front imports nothing, because the
worker processes come through it too and shall not load a web server.
"""
