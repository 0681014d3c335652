"""The web server: who may enter, pages, sockets, start and end."""
