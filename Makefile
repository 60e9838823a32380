# Every recipe that people, continuous integration and the container use.

LISTEN ?= 127.0.0.1:8737
BIN ?= target/release/seamster
NPM_CI = npm ci --ignore-scripts --no-audit --no-fund

# Set LISTEN or BIN on the command line: make run LISTEN=127.0.0.1:9000

.PHONY: help run test check soak bench stability instructions table sweep fuzz smoke audit build page browser chromium valgrind
.DEFAULT_GOAL := help

help:
	@echo "make run     build, start the service on http://$(LISTEN) and open the page"
	@echo "make test    all tests (SEAMSTER_TEST_DATA: folder of real patterns, left out without it)"
	@echo "make check   format, lints, documentation"
	@echo "make bench   error against run time: a JSON line a run in target/bench.jsonl, plots in target/bench (SCENES: some only)"
	@echo "make instructions  what a scene lacks, and its report, cost, counted by valgrind (ARGS='--table FILE' writes it there)"
	@echo "make stability  stiff and extreme cases, all of them: a JSON line a case in target/stability.jsonl (CASES: some only)"
	@echo "make table   what the project makes of the real patterns in SEAMSTER_TEST_DATA, against the truth"
	@echo "make sweep   sews the real patterns in SEAMSTER_TEST_DATA: a row each, pictures in target/sweep (GARMENTS: some only; ARGS='--edge-length 0.02')"
	@echo "make fuzz    searches for inputs that break the importer and the seam check (T seconds each)"
	@echo "make soak    hours: every stability case, a circle skirt, 10 000 damaged files, fuzzing, ten runs of the queue and service tests"
	@echo "make smoke   a fresh service sews both samples, a validator reads the result"
	@echo "make audit   known faults of dependencies (needs the internet)"

## The service

build: page
	cargo build --release --locked

# The page's one dependency; it is embedded in the binary, so it comes first.
page: static/node_modules/.package-lock.json
static/node_modules/.package-lock.json: static/package-lock.json
	cd static && $(NPM_CI)
	@touch $@

run: build
	@( for i in $$(seq 100); do \
	     if SEAMSTER_LISTEN=$(LISTEN) $(BIN) health >/dev/null 2>&1; then \
	       echo "Seamster: http://$(LISTEN)"; \
	       if [ -n "$$DISPLAY$$WAYLAND_DISPLAY" ] && command -v xdg-open >/dev/null; then \
	         xdg-open http://$(LISTEN) >/dev/null 2>&1; fi; \
	       break; \
	     fi; sleep 0.1; \
	   done ) & SEAMSTER_LISTEN=$(LISTEN) exec $(BIN) serve

## Checks

check: page
	cargo fmt --all --check
	cargo clippy --locked --workspace --all-targets -- -D warnings
	RUSTDOCFLAGS="-D warnings" cargo doc --locked --workspace --no-deps

PAGE_SUITES = page suggest sheet seams panels work drafts stage fitting gallery
# These look at every size, every edge and every fault of a connection: minutes.
LONG_PAGE_SUITES = layout edges faults

# One profile for all: the browser drives the binary that the Rust tests built.
test: page browser chromium valgrind
	@if cargo nextest --version >/dev/null 2>&1; \
	  then echo cargo nextest run; cargo nextest run --locked --workspace; \
	  else echo cargo test; cargo test --locked --workspace --lib && cargo test --locked --test it && \
	    cargo test --locked --test process -- --test-threads=1; fi
	@for suite in $(PAGE_SUITES); do \
	  echo "tests/browser/$$suite.mjs"; \
	  SEAMSTER_BIN=target/debug/seamster node tests/browser/$$suite.mjs || exit 1; done

bench:
	cargo run --release --locked -p seamster-tools -- bench $(SCENES)
	cargo run --release --locked -p seamster-tools -- bench-samples | tee target/bench_samples.jsonl

instructions: page valgrind
	cargo run --release --locked -p seamster-tools -- instructions $(ARGS)

stability:
	cargo run --release --locked -p seamster-tools -- stability $(CASES)

table: page
	cargo run --locked -p seamster-tools -- truth-table $(SECTIONS)

sweep: page
	cargo run --release --locked -p seamster-tools -- sweep $(ARGS) $(GARMENTS)

fuzz: page
	cargo fuzz --version >/dev/null 2>&1 || cargo install --locked cargo-fuzz
	@for target in import seams; do \
	  mkdir -p fuzz/corpus/$$target; \
	  cargo fuzz run -s none $$target fuzz/corpus/$$target tests/corpus/$$target -- \
	    -max_total_time=$(or $(T),300) -timeout=10 || exit 1; \
	done

# What takes too long for every change.
soak: page browser chromium stability fuzz
	cargo build --locked --bin seamster
	@for suite in $(LONG_PAGE_SUITES); do \
	  echo "tests/browser/$$suite.mjs"; \
	  SEAMSTER_BIN=target/debug/seamster node tests/browser/$$suite.mjs || exit 1; done
	cargo test --release --locked --test it -- --ignored
	SEAMSTER_MUTATIONS=10000 cargo test --release --locked --test it pattern::loss
	@for run in $$(seq 10); do \
	  echo "run $$run of 10"; \
	  cargo test --locked --test it -- job:: http:: && \
	  cargo test --locked --test process -- --test-threads=1 || exit 1; \
	done

smoke: build browser
	tests/smoke.sh $(BIN)

audit:
	cargo deny check
	cd static && npm audit
	cd tests/browser && npm audit

## What the tests need

browser: tests/browser/node_modules/.package-lock.json
tests/browser/node_modules/.package-lock.json: tests/browser/package-lock.json
	cd tests/browser && $(NPM_CI)
	@touch $@

chromium:
	@for name in chromium chromium-browser google-chrome; do \
	    command -v $$name >/dev/null && exit 0; \
	  done; \
	  echo "The page's tests need chromium, which is not installed: installing Debian's."; \
	  SUDO=$$([ "$$(id -u)" = 0 ] || echo sudo); \
	  { $$SUDO apt-get update -q && $$SUDO apt-get install -qy --no-install-recommends chromium; } || \
	  { echo "chromium could not be installed. Install it by hand, then run make test again." >&2; exit 1; }

valgrind:
	@command -v valgrind >/dev/null && exit 0; \
	  echo "Instructions are counted by valgrind, which is not installed: installing Debian's."; \
	  SUDO=$$([ "$$(id -u)" = 0 ] || echo sudo); \
	  { $$SUDO apt-get update -q && $$SUDO apt-get install -qy --no-install-recommends valgrind; } || \
	  { echo "valgrind could not be installed. Install it by hand, then run make test again." >&2; exit 1; }
