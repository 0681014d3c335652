# Plain POSIX make. Everything lives in .venv, which `sh tools/venv.sh` keeps up to date.
# make PYTHON=/path/to/python3 <target> chooses the interpreter (3.11 or newer).
# make BIN=.venv/Scripts <target> is for Windows, where Python puts the commands of .venv there.

BIN = .venv/bin
VENV = PYTHON='$(PYTHON)' VENV_BIN='$(BIN)' sh tools/venv.sh
DEMO = examples/palletizing
# A worker for each core (tests/conftest.py), at most four; tests of a module stay together, in the order of tests/conftest.py.
SIDE_BY_SIDE = -n auto --maxprocesses 4 --dist loadfile --no-loadscope-reorder $(PLAIN)
# Parts of pytest that no test uses and each test would pass through.
PLAIN = -p no:benchmark -p no:anyio -p no:logging -p no:legacypath
# Hundreds of processes are started: modules that are compiled once save each of them half of its start.
KEEP_COMPILED = PYTHONDONTWRITEBYTECODE=

help:
	@echo 'make demo    compile, plan, simulate and report the palletizing cell ($(DEMO))'
	@echo 'make test    run the tests, without the slow ones'
	@echo 'make test-rest  run the slow tests, such as walks in a browser and kills'
	@echo 'make test-all   run all tests, each law on 25 times as many examples'
	@echo 'make check   lint, format, types, import contracts, spelling, generated pages; the pages of the studio'
	@echo 'make bench   run the benchmarks'
	@echo 'make docs    write the generated pages, tables and types'
	@echo 'make pictures  take the pictures of README and docs (needs Chromium)'
	@echo 'make clean   remove .venv, node_modules, caches, build and example output'

demo:
	@$(VENV)
	$(BIN)/ropsim run $(DEMO) --report $(DEMO)/out/report.html

test:
	@$(VENV) test
	$(KEEP_COMPILED) $(BIN)/python -m pytest $(SIDE_BY_SIDE) -m 'not slow'

test-rest:
	@$(VENV) test
	$(KEEP_COMPILED) $(BIN)/python -m pytest $(SIDE_BY_SIDE) -m slow

test-all:
	@$(VENV) test
	$(KEEP_COMPILED) $(BIN)/python -m pytest $(SIDE_BY_SIDE) --hypothesis-profile long

# `make --jobs=2 check` checks types beside the rest, which takes as long.
check: types style pages frontend

check-tools:
	@$(VENV) test check

types: check-tools
	$(BIN)/mypy

style: check-tools
	$(BIN)/ruff check .
	$(BIN)/ruff format --check .
	$(BIN)/lint-imports
	$(BIN)/codespell

pages: check-tools
	$(BIN)/python tools/diagnostic_pages.py --check
	$(BIN)/python tools/icr_table.py --check
	$(BIN)/python tools/import_table.py --check
	$(BIN)/python -m tools.robot_library --check
	$(BIN)/python -m tools.robot_page --check
	$(BIN)/python -m tools.part_page --check
	$(BIN)/python tools/wire_types.py --check
	$(BIN)/python tools/block_words.py --check
	$(BIN)/python tools/pack_fixture.py --check
	$(BIN)/python tools/plain_english.py --check

frontend: check-tools
	$(BIN)/python -m tools.frontend

bench:
	@$(VENV) test
	$(BIN)/python -m pytest benchmarks

docs:
	@$(VENV)
	$(BIN)/python tools/diagnostic_pages.py
	$(BIN)/python tools/icr_table.py
	$(BIN)/python tools/import_table.py
	$(BIN)/python -m tools.robot_library
	$(BIN)/python -m tools.robot_page
	$(BIN)/python -m tools.part_page
	$(BIN)/python tools/wire_types.py
	$(BIN)/python tools/block_words.py

pictures:
	@$(VENV) test
	$(BIN)/python tools/readme_picture.py
	PYTHONPATH=tests $(BIN)/python -m tools.studio_pictures

clean:
	rm -rf .venv build dist .pytest_cache .mypy_cache .ruff_cache .import_linter_cache .hypothesis
	rm -rf .benchmarks examples/*/out frontend/node_modules frontend/dist src/ropsim/static src/ropsim/prolog/data
	find src tests tools benchmarks -name __pycache__ -type d -prune -exec rm -rf '{}' +

.PHONY: help demo test test-rest test-all check check-tools types style pages frontend bench docs pictures clean
