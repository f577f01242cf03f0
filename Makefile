# The user's entry points. Each does the set-up that it needs and is quick when nothing changed.
# The compiler cache serves the package and the release build alike, and any clone, precompiled headers too.
export CCACHE_BASEDIR := $(CURDIR)
export CCACHE_NOHASHDIR := 1
export CCACHE_SLOPPINESS := pch_defines,time_macros,include_file_mtime,include_file_ctime

.PHONY: configure build demo test lint sanitize bench bench-paper site clean format

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

# the tests of the core with the address and undefined behaviour sanitizers
sanitize: build/.packages
	@cmake --preset asan-ubsan -Wno-dev >build/configure.log 2>&1 || { cat build/configure.log; exit 1; }
	@cmake --build --preset asan-ubsan --target core_tests
	@ctest --preset asan-ubsan -L core -j2

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
