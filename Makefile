# make demo   a furnished flat in demo/ (installs into .venv first)
# make test   the whole check
# make test-all   the same with many more random cases, moments and repetitions
# make test-learn   training with PyTorch (installs the extra learn), not part of the check
# make site   the documents and the library as web pages in site/ (installs the extra docs)
# make install   installs into .venv and compiles for all kinds of scenes
# Needs Python 3.11 or newer and make; nothing else.

PYTHON ?= python3
BIN := .venv/bin
# Bytecode is written by what runs first: of all that is installed that would take 20 seconds.
INSTALL = $(BIN)/python -m pip install --quiet --disable-pip-version-check --no-compile --editable
EXTRAS := solve peers bim dxf pdf gis svg docs usd mujoco cluster
comma := ,
space := $(subst ,, )

.PHONY: demo install site test test-all test-learn types tests clean

demo: .venv/installed
	$(BIN)/scenewright arrange sample:home-flat -o demo/home.glb -o demo/home.svg -o demo/home.png -o demo/home.json || [ $$? -eq 1 ]

install: .venv/installed
	$(BIN)/scenewright warm

# The types are checked beside the tests, which run on all cores, at most eight.
test: .venv/checked
	$(BIN)/ruff check .
	$(BIN)/ruff format --check .
	@$(MAKE) --no-print-directory -j2 types tests

test-all: export SCENEWRIGHT_THOROUGH = 1
test-all: test

test-learn: .venv/checked
	$(INSTALL) '.[learn]'
	$(BIN)/pytest learn_tests

types:
	$(BIN)/mypy

tests: .venv/warmed
	$(BIN)/pytest -n auto --maxprocesses 8 --dist worksteal

site: .venv/installed
	$(INSTALL) '.[docs]'
	$(BIN)/python -m sphinx -q -W --keep-going -b html docs site

clean:
	rm -rf .venv demo site build dist .mypy_cache .ruff_cache .pytest_cache .hypothesis

# An interrupted installation leaves no stamp and is done again.
.venv/made: pyproject.toml
	$(PYTHON) -c 'import sys; sys.exit("Scenewright needs Python 3.11 or newer; this is " + sys.version.split()[0] + "; try make PYTHON=python3.12" if sys.version_info < (3, 11) else 0)'
	test -x $(BIN)/python || $(PYTHON) -m venv .venv
	touch $@

.venv/installed: .venv/made
	$(INSTALL) .
	touch $@

# Compiled once, before every worker would compile the same; later on only what was edited is.
.venv/warmed: .venv/checked
	$(BIN)/scenewright warm
	touch $@

# All at once takes a quarter of the time; one after another where one cannot be installed.
.venv/checked: .venv/made
	$(INSTALL) '.[dev,$(subst $(space),$(comma),$(EXTRAS))]' || { $(INSTALL) '.[dev]'; \
	for extra in $(EXTRAS); do \
	  $(INSTALL) ".[$$extra]" \
	    || echo "The extra $$extra cannot be installed here: its tests are skipped, as pytest's summary says."; \
	done; }
	touch $@
