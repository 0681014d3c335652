"""Schemas of ISO 10303-11 (EXPRESS), in the part that is needed, and instances checked against them."""

from ropsim.express.population import Population as Population
from ropsim.express.population import plain as plain
from ropsim.express.reader import read_schema as read_schema
from ropsim.express.schema import Schema as Schema
from ropsim.express.validation import validate as validate
