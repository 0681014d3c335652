"""Child processes of the web process: workers, language servers, makers of projects."""
