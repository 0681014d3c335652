"""Arms of six or seven turning joints of any geometry, by elimination."""
