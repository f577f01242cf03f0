# The user's entry points. Each does the set-up that it needs and is quick when nothing changed.
# The compiler cache serves the package and the release build alike, and any clone, precompiled headers too.
export CCACHE_BASEDIR := $(CURDIR)
export CCACHE_NOHASHDIR := 1
export CCACHE_SLOPPINESS := pch_defines,time_macros,include_file_mtime,include_file_ctime

.PHONY: build demo test lint sanitize sanitize-all fuzz outsiders soak same-bits abi wheel bench bench-programs bench-paper \
  site format clean

# packages of a list of packages.txt
build/.packages-%: packages.txt tools/install_packages
	@mkdir -p build
	@tools/install_packages $*
	@touch $@

# Tests and benchmarks are part of the build folder once their packages are.
have = $(shell test -e build/.packages-$(1) && echo ON || echo OFF)
configure = cmake --preset $(1) -Wno-dev -DGMCR_BUILD_TESTS=$(call have,test) -DGMCR_BUILD_BENCH=$(call have,bench) \
  >build/configure.log 2>&1 || { cat build/configure.log; exit 1; }

# the tool and the libraries, which `cmake --install build/release` installs
build: build/.packages-run
	@$(call configure,release)
	@cmake --build --preset release --target product

demo: build/.packages-run
	@$(call configure,release)
	@cmake --build --preset release --target gmcr_cli
	@examples/demo/run

test: build/.packages-test
	@$(call configure,release)
	@tools/make_venv requirements >build/venv.log 2>&1 & requirements=$$!; cmake --build --preset release || exit 1; \
	  wait $$requirements || { cat build/venv.log; exit 1; }
	@ctest --preset release -j2
	@tools/make_venv
	@build/venv/bin/python -m pytest -q -n 2 --dist loadfile tests/python

# clang-format, headers alone, ruff, mypy, clang-tidy, or those of them that GATES names
lint: build/.packages-test build/.packages-bench
	@$(call configure,release)
	@tools/make_venv
	@tools/lint $(GATES)

# the tests of the core, and the readers on what fuzzing kept, with the address and undefined behaviour sanitizers
sanitize: build/.packages-test
	@$(call configure,asan-ubsan)
	@cmake --build --preset asan-ubsan --target core_tests outside_tests
	@ctest --preset asan-ubsan -L "core|outside" -j2

# all tests but those of Open3D and of other compilers, and of what a sanitizer changes, under either kind: an hour
sanitize-all: build/.packages-test
	@for preset in asan-ubsan tsan; do cmake --preset $$preset -Wno-dev >build/configure.log 2>&1 \
	  && cmake --build --preset $$preset --target core_tests outside_tests test_io test_report test_frontend test_synthetic test_cli \
	  && ctest --preset $$preset -L "core|outside|unit" -E "KernelsOnArm|TimeLimits|CountsTheThreads" -j2 || exit 1; done

# everything that takes bytes from outside, under libFuzzer: MINUTES of each, or of the TARGETS named
fuzz: build/.packages-test
	@$(call configure,fuzz)
	@cmake --build --preset fuzz --target fuzzers
	@tools/fuzz --minutes $(or $(MINUTES),1) $(TARGETS)

# cliques against igraph and cliquer, bounds against all subsets: EFFORT times as many as in the tests
outsiders: build/.packages-test
	@$(call configure,release)
	@cmake --build --preset release --target test_clique test_proof
	@GMCR_EFFORT=$(or $(EFFORT),50) build/release/bin/test_clique --gtest_filter='Outsiders.*'
	@GMCR_EFFORT=$(or $(EFFORT),50) build/release/bin/test_proof --gtest_filter='BruteForce.*'

# problems of all kinds from 8 threads of each of 2 processes for MINUTES
soak: bench-programs
	@build/release/bin/bench_soak --minutes $(or $(MINUTES),60)

# the recorded answers by clang, and on 64-bit Arm under the emulator
same-bits: build/.packages-bench
	@tools/same_bits

# what the shared libraries offer, against that of the last release
abi: build/.packages-test
	@tools/abi

# a wheel for this machine, tried in an environment of its own
wheel: build/.packages-run
	@tools/build_wheel

bench: bench-programs
	@bench/run

bench-programs: build/.packages-bench
	@$(call configure,release)
	@cmake --build --preset release --target gmcr_cli bench_programs

bench-paper: build/.packages-bench
	@tools/make_venv
	@bench/paper/run

# the documentation as a site, in build/site/html
site: build/.packages-test
	@$(call configure,release)
	@cmake --build --preset release --target gmcr_cli
	@tools/make_venv
	@build/venv/bin/python site/build.py

format:
	@git ls-files '*.h' '*.hpp' '*.cpp' | xargs clang-format -i

clean:
	@rm -rf build out
