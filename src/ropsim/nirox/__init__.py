"""NIROX: the neutral model of an arm as an exchange file of ISO 10303-21."""

from ropsim.nirox.building import FurtherFrame as FurtherFrame
from ropsim.nirox.further_data import FurtherData as FurtherData
from ropsim.nirox.products.plain_writing import write_mechanism as write_mechanism
from ropsim.nirox.reading import WITHOUT_MASS as WITHOUT_MASS
from ropsim.nirox.reading import ReadNirox as ReadNirox
from ropsim.nirox.reading import nirox_places as nirox_places
from ropsim.nirox.reading import read_nirox as read_nirox
from ropsim.nirox.reading import read_valid_nirox as read_valid_nirox
from ropsim.nirox.schema_text import ConformanceClass as ConformanceClass
from ropsim.nirox.schema_text import conformance_of as conformance_of
from ropsim.nirox.schema_text import nirox_schema as nirox_schema
from ropsim.nirox.schema_text import nirox_schema_text as nirox_schema_text
from ropsim.nirox.writing import write_nirox as write_nirox
