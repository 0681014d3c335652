"""Terms and texts of Prolog: records, reading, writing and predicates."""
