# Everything that the project does, each target from a fresh clone: Python >= 3.11 with venv, and
# GNU make, are all it needs. Stamps are written last, so that an interrupted run starts again
# where it was.

PYTHON ?= python3

VENV := .venv
BIN := $(VENV)/bin
ENV := $(VENV)/.installed
LOWEST := .venv-lowest
ENV_LOWEST := $(LOWEST)/.installed
PEERS := .venv-peers
ENV_PEERS := $(PEERS)/.installed
PYTEST := $(BIN)/python -m pytest -n 2

# A derivation is a percent-format script; other modules beside it are what derivations share.
SCRIPTS := $(sort $(shell grep -l '^# %%' derivations/*.py 2>/dev/null))
DERIVATIONS := $(SCRIPTS:derivations/%.py=%)
STAMPS := $(DERIVATIONS:%=build/%.stamp)
SHARED := $(filter-out $(SCRIPTS),$(sort $(wildcard derivations/*.py)))
ENGINE := $(sort $(wildcard src/mmsgen/*.py src/mmsgen/*/*.py))

# Figures are drawn without a display.
export MPLBACKEND := Agg

# Derivations are made two at a time; where one fails, the others are made all the same.
JOBS ?= 2
MAKEFLAGS += --jobs=$(JOBS) --keep-going

.DEFAULT_GOAL := all
.DELETE_ON_ERROR:
.SUFFIXES:
.SECONDEXPANSION:
.PHONY: all check test test-all bench peers lint env clean distclean help FORCE
.PHONY: $(DERIVATIONS:%=check-%)

all: $(STAMPS)  ## derive, emit, certify, execute the notebooks: only what changed (the default)
	@:

check: $(DERIVATIONS:%=check-%)  ## fail when the committed output differs from fresh output
	@:

$(DERIVATIONS:%=check-%): check-%: $(ENV)
	$(BIN)/python -m mmsgen make --check $*

test: $(ENV)  ## the tests, with ruff and mypy among them
	$(PYTEST)

test-all: $(ENV) $(ENV_LOWEST)  ## also the slow tests, longer random ones, the lowest versions, check
	$(PYTEST) -m "slow or not slow" --hypothesis-profile=long
	$(LOWEST)/bin/python -m pytest -n 2 -m "not slow and not pinned"
	$(MAKE) check

bench: $(ENV)  ## the benchmarks; they state numbers and fail on none
	$(BIN)/python -m pytest benchmarks -o python_files="bench_*.py" --benchmark-only

peers: $(ENV) $(ENV_PEERS)  ## beside oscilate and asymptotics on their own examples: up to an hour
	$(BIN)/python benchmarks/peers/measure.py
	$(BIN)/python benchmarks/peers/table.py

lint: $(ENV)  ## ruff and mypy alone
	$(BIN)/python -m ruff check .
	$(BIN)/python -m mypy

env: $(ENV)  ## only the environment, in .venv

clean:  ## remove what can be made again, except the environments and the committed output
	rm -rf build dist .benchmarks .hypothesis .mypy_cache .pytest_cache .ruff_cache
	find src tests derivations generated benchmarks -name __pycache__ -prune -exec rm -rf {} +

distclean: clean  ## clean, and remove the environments
	rm -rf $(VENV) $(LOWEST) $(PEERS)

help:  ## list the targets
	@sed -n 's/^\([a-z-]*\):[^#]*## \(.*\)/  make \1\t\2/p' $(firstword $(MAKEFILE_LIST)) | expand -t 18
	@echo "Another interpreter: make PYTHON=python3.12"

# A stamp lists the files that its derivation emitted; one that has gone missing brings it back.
emitted = derivations/$1.ipynb $(wildcard generated/mms_functions/$1/*.py generated/mms_functions/$1/*.json)
gone = $(filter-out $(wildcard $(file <build/$1.stamp)),$(file <build/$1.stamp))

build/%.stamp: derivations/%.py $(SHARED) $(ENGINE) $(ENV) $$(wildcard $$(call emitted,$$*)) $$(if $$(call gone,$$*),FORCE)
	@mkdir -p build
	$(BIN)/python -m mmsgen make $*
	@ls derivations/$*.ipynb generated/mms_functions/$*/*.py generated/mms_functions/$*/*.json 2>/dev/null | tr '\n' ' ' > $@.new
	@mv $@.new $@

FORCE:

# An environment that works is brought up to date; anything else is made anew.
define make_venv
	@$(PYTHON) -c 'import sys; sys.exit(sys.version_info < (3, 11))' 2>/dev/null || { \
	  echo "mmsgen needs Python 3.11 or later, and '$(PYTHON)' is" \
	    "$$($(PYTHON) --version 2>&1 | head -n 1): make PYTHON=python3.12" >&2; exit 1; }
	@$(PYTHON) -c 'import ensurepip, venv' 2>/dev/null || { \
	  echo "'$(PYTHON)' has no venv: install it (on Debian: the package python3-venv)" >&2; exit 1; }
	@test "$$($1/bin/python -m pip --version 2>/dev/null | sed 's/.*(//')" = \
	  "$$($(PYTHON) -c 'import sys; print("python %d.%d)" % sys.version_info[:2])')" \
	  || $(PYTHON) -m venv --clear $1
endef

INSTALL := -m pip install --quiet --disable-pip-version-check

$(ENV): pyproject.toml constraints.txt
	$(call make_venv,$(VENV))
	$(BIN)/python $(INSTALL) -c constraints.txt hatchling
	$(BIN)/python $(INSTALL) -c constraints.txt --no-build-isolation -e ".[dev]"
	@touch $@

$(ENV_LOWEST): pyproject.toml constraints.txt constraints-lowest.txt
	$(call make_venv,$(LOWEST))
	$(LOWEST)/bin/python $(INSTALL) -c constraints-lowest.txt hatchling
	$(LOWEST)/bin/python $(INSTALL) -c constraints-lowest.txt --no-build-isolation \
	  -e ".[plot,notebook,cli,test]"
	@touch $@

$(ENV_PEERS): benchmarks/peers/requirements.txt
	$(call make_venv,$(PEERS))
	$(PEERS)/bin/python $(INSTALL) -r benchmarks/peers/requirements.txt
	@touch $@
