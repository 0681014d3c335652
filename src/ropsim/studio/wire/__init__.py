"""Records that travel: between pages and server, and between server and workers."""
