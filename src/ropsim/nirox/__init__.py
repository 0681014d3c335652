"""NIROX: the neutral model of an arm as an exchange file of ISO 10303-21."""

from ropsim.nirox.schema_text import nirox_schema as nirox_schema
from ropsim.nirox.schema_text import nirox_schema_text as nirox_schema_text
from ropsim.nirox.writing import write_nirox as write_nirox
