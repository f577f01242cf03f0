# The user's entry points. Each does the set-up that it needs and is quick when nothing changed.
# The compiler cache serves the package and the release build alike.
export CCACHE_BASEDIR := $(CURDIR)
export CCACHE_NOHASHDIR := 1

.PHONY: build demo test bench bench-paper clean format

build: build/.packages
	@cmake --preset release -Wno-dev >build/configure.log 2>&1 || { cat build/configure.log; exit 1; }
	@cmake --build --preset release

build/.packages: packages.txt tools/install_packages
	@mkdir -p build
	@tools/install_packages
	@touch $@

demo: build
	@examples/demo/run

test: build
	@ctest --preset release -j2
	@tools/make_venv
	@build/venv/bin/python -m pytest -q tests/python

bench: build
	@bench/run

bench-paper: build/.packages
	@tools/make_venv
	@bench/paper/run

format:
	@git ls-files '*.hpp' '*.cpp' | xargs clang-format -i

clean:
	@rm -rf build out
