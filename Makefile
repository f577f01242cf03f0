# The user's entry points. Each does the set-up that it needs and is quick when nothing changed.
# The compiler cache serves the package and the release build alike, and any clone, precompiled headers too.
export CCACHE_BASEDIR := $(CURDIR)
export CCACHE_NOHASHDIR := 1
export CCACHE_SLOPPINESS := pch_defines,time_macros,include_file_mtime,include_file_ctime

.PHONY: configure build demo test lint sanitize sanitize-all fuzz outsiders soak bench bench-paper site clean format

build: configure
	@cmake --build --preset release

configure: build/.packages
	@cmake --preset release -Wno-dev >build/configure.log 2>&1 || { cat build/configure.log; exit 1; }

build/.packages: packages.txt tools/install_packages
	@mkdir -p build
	@tools/install_packages
	@touch $@

demo: configure
	@cmake --build --preset release --target gmcr_cli
	@examples/demo/run

test: build
	@ctest --preset release -j2
	@tools/make_venv
	@build/venv/bin/python -m pytest -q tests/python

# clang-format, headers alone, ruff, mypy, clang-tidy, or those of them that GATES names
lint: build
	@tools/make_venv
	@tools/lint $(GATES)

# the tests of the core, and the readers on what fuzzing kept, with the address and undefined behaviour sanitizers
sanitize: build/.packages
	@cmake --preset asan-ubsan -Wno-dev >build/configure.log 2>&1 || { cat build/configure.log; exit 1; }
	@cmake --build --preset asan-ubsan --target core_tests outside_tests
	@ctest --preset asan-ubsan -L "core|outside" -j2

# all tests but those of Open3D and of other compilers, under either kind of sanitizers: hours
sanitize-all: build/.packages
	@for preset in asan-ubsan tsan; do cmake --preset $$preset -Wno-dev >build/configure.log 2>&1 \
	  && cmake --build --preset $$preset --target core_tests outside_tests test_io test_report test_frontend test_synthetic test_cli \
	  && ctest --preset $$preset -L "core|outside|unit" -j2 || exit 1; done

# everything that takes bytes from outside, under libFuzzer: MINUTES of each, or of the TARGETS named
fuzz: build/.packages
	@cmake --preset fuzz -Wno-dev >build/configure.log 2>&1 || { cat build/configure.log; exit 1; }
	@cmake --build --preset fuzz --target fuzzers
	@tools/fuzz --minutes $(or $(MINUTES),1) $(TARGETS)

# cliques against igraph and cliquer, bounds against all subsets: EFFORT times as many as in the tests
outsiders: build
	@GMCR_EFFORT=$(or $(EFFORT),50) build/release/bin/test_clique --gtest_filter='Outsiders.*'
	@GMCR_EFFORT=$(or $(EFFORT),50) build/release/bin/test_proof --gtest_filter='BruteForce.*'

# problems of all kinds from 8 threads of each of 2 processes for MINUTES
soak: build
	@build/release/bin/bench_soak --minutes $(or $(MINUTES),60)

bench: build
	@bench/run

bench-paper: build/.packages
	@tools/make_venv
	@bench/paper/run

# the documentation as a site, in build/site/html
site: configure
	@cmake --build --preset release --target gmcr_cli
	@tools/make_venv
	@build/venv/bin/python site/build.py

format:
	@git ls-files '*.hpp' '*.cpp' | xargs clang-format -i

clean:
	@rm -rf build out
