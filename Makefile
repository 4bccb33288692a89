# SPDX-License-Identifier: BSD-3-Clause
# The front door.  `make help` lists what there is; CMake does the work, in $(BUILD).
BUILD  ?= build
JOBS   ?= $(shell nproc 2>/dev/null || echo 2)
PREFIX ?= /usr/local
# More for cmake, such as FLAGS=-DLUXPIPE_PTRACE=OFF (the tools that need neither Embree nor OpenCL).
FLAGS  ?=
# Eight files of a library are compiled as one.  FLAGS=-DCMAKE_UNITY_BUILD=OFF: each by itself (CONTRIBUTING.md).
UNITY   = -DCMAKE_UNITY_BUILD=ON
# SETUP=no installs no packages; otherwise those that the goal needs and the machine lacks, said before.
SETUP  ?= yes
# ispc, which makes ptrace faster: a copy (47 MB) from Debian 13's archive into .ispc, by apt, which checks signatures.
# Not where FLAGS=-DLUXPIPE_ISPC=... says which, and never for a package: it takes an ispc that is there.
ISPC    = $(if $(and $(LANES),$(findstring ptrace,$(PARTS)),$(if $(findstring LUXPIPE_ISPC,$(FLAGS)),,y)),\
    sh scripts/ispc.sh .ispc,:)
# ARCH=arm64 (a wheel: aarch64): for ARM, on another processor, all by gcc (cmake/arm64.cmake), without ispc.
ARM     = $(filter arm64 aarch64,$(ARCH))
FOR     = $(addprefix /,$(ARM))
FETCH   = $(if $(ARM),sh scripts/arm64.sh build-arm64/root,$(ISPC) && $(OLDER))
# A wheel for x86-64 has libraries of its own, for older systems.
OLDER   = :
# Lanes that are built (lib/device): those of this machine, or both in what goes elsewhere and in the tests.
OWN     = $(if $(shell grep -sw avx512dq /proc/cpuinfo),16,8)
LANES   = $(OWN)
# clang makes ptrace's kernels a tenth faster than gcc: it compiles them where it is found and FLAGS states no compiler.
KERNELS = $(if $(findstring _CXX,$(FLAGS)),,$(addprefix -DLUXPIPE_KERNEL_CXX=,$(firstword $(foreach v,\
    clang++ $(addprefix clang++-,19 18 17 16 15 14),$(shell command -v $(v))))))
TARGETS = tools
PARTS   = tools $(if $(findstring LUXPIPE_PTRACE=OFF,$(FLAGS)),,ptrace)
CXX_FILES = $(shell git ls-files '*.cpp' '*.h')

help: ## this list
	@awk -F ':.*## ' '/^[a-z-]+:.*## / { printf "  make %-18s %s\n", $$1, $$2 }' Makefile

all: setup ## a release build of the programs in build/bin (fetches ispc from Debian 13 into .ispc: 47 MB)
	cmake -S . -B "$(BUILD)" -G Ninja --log-level=WARNING -DCMAKE_INSTALL_PREFIX="$(PREFIX)" \
	    "-DLUXPIPE_LANES=$(LANES)" $(UNITY) $(KERNELS) $(FLAGS)
	cmake --build "$(BUILD)" -j $(JOBS) --target $(TARGETS)

everything: LANES = 8;16
everything: all ## the tools, the tests, studies and benchmarks
	cmake --build "$(BUILD)" -j $(JOBS)

# Its own programs; lanes, which take as long to compile as these, only if they are there.
demo: PARTS += demo
demo: TARGETS = ptrace ptaccum vcmetrics vcregion
demo: LANES = $(shell [ ! -e "$(BUILD)/lib/device/lanes$(OWN).o" ] || echo $(OWN))
demo: all ## the office: pictures, metrics and a plot in out/
	@bash examples/demo.sh "$(BUILD)/bin" out
	@[ -n "$(LANES)" ] || echo "(By a ptrace without lanes; that of \`make all\` is 1.2 to 1.8 times faster.)"

live: all ## the office in a browser: open the printed address; ^C ends it
	@bash examples/live.sh $(BUILD)/bin

everything test-sanitize fuzz compare-radiance: PARTS += tests
test: everything ## every test that needs no GPU
	@cd "$(BUILD)" && ctest --no-tests=error --output-on-failure -j $(JOBS) -LE 'gpu|slow|slurm'

test-slow: everything ## the tests that take minutes: faults of OpenCL, packages made twice, a new option and material
	@cd "$(BUILD)" && ctest --output-on-failure -L slow

test-slurm: everything ## a job array on a Slurm cluster of this machine, where Slurm is installed (as root)
	@cd "$(BUILD)" && ctest --output-on-failure -L slurm

test-gpu: everything ## the tests for a machine with a GPU
	@cd "$(BUILD)" && ctest --output-on-failure -L gpu

test-sanitize: setup ## the tests under the address, undefined and thread sanitizers
	@bash scripts/sanitize.sh $(JOBS)

fuzz: PARTS += fuzz
fuzz: setup ## every fuzz target for SECONDS=60 each (clang); finds in out/fuzz
	@cmake -S . -B build-fuzz -G Ninja --log-level=WARNING -DCMAKE_CXX_COMPILER=clang++ -DLUXPIPE_FUZZ=ON > /dev/null
	@cmake --build build-fuzz -j $(JOBS) --target fuzz
	@bash tests/fuzz/run.sh build-fuzz/bin out/fuzz $(or $(SECONDS),60)

deb: PARTS += $(strip deb $(ARM))
deb: ISPC = :
deb: setup ## a Debian package in out/deb, the same bytes for the same sources; no ispc (ARCH=arm64: for ARM)
	@JOBS=$(JOBS) FLAGS="$(if $(ARM),,$(KERNELS)) $(FLAGS)" ARCH=$(ARM) \
	    bash scripts/deb.sh out/deb$(FOR)

test-arm64: PARTS += tests arm64
test-arm64: ARCH = arm64
test-arm64: setup ## the programs for ARM, built here; their bits and words under qemu, long (ALL=1: all recorded runs)
	@cmake -S . -B build-arm64 -G Ninja --log-level=WARNING -DCMAKE_TOOLCHAIN_FILE=cmake/arm64.cmake $(UNITY) $(FLAGS)
	@cmake --build build-arm64 -j $(JOBS) --target tools $$(sh scripts/test_arm64.sh targets)
	@bash scripts/test_arm64.sh build-arm64 $(if $(ALL),all)

test-deb: PARTS += chroot
test-deb: deb ## packages for Debian 12 and 13, each put into an empty one (debootstrap, as root), the demo run there
	@bash scripts/try_deb.sh out/deb$(FOR)/luxpipe_*.deb bookworm
	@JOBS=$(JOBS) FLAGS="$(FLAGS)" ARCH=$(ARM) bash scripts/deb_for.sh trixie out/deb$(FOR)
	@bash scripts/try_deb.sh out/deb$(FOR)/for-trixie/luxpipe_*.deb trixie

zip: PARTS = windows
zip: ISPC = :
zip: setup ## ptrace, ptaccum, vcmetrics, vcregion and vcyear for Windows, with their pages, as a .zip in out/zip
	@JOBS=$(JOBS) FLAGS="$(FLAGS)" bash scripts/zip.sh out/zip

test-windows: PARTS += tests windows wine
test-windows: all zip ## the programs of the .zip under wine: evalglare's rows, the bytes of this machine's
	@cmake --build "$(BUILD)" -j $(JOBS) --target mkstream
	@BIN="$(BUILD)/bin" bash scripts/test_windows.sh build-windows

check-macos: PARTS += wheel
check-macos: ISPC = :
check-macos: setup ## every file of lib and tools compiled for macOS, by zig's compiler; nothing is linked or run
	@bash scripts/macos.sh build-macos

wheel: PARTS += $(strip wheel $(ARM:aarch64=arm64))
wheel: OLDER = sh scripts/glibc228.sh build-glibc228/root
wheel: setup ## a Python wheel in out/wheel: the programs and `import luxpipe`; tools come from the package index
	@JOBS=$(JOBS) FLAGS="$(FLAGS)" ARCH=$(ARM) \
	    bash scripts/wheel.sh out/wheel$(FOR)

test-wheel: PARTS += chroot tests
test-wheel: wheel ## the wheel built again: same bytes; then put into empty Debians 11 to 13 (debootstrap, as root)
	@JOBS=$(JOBS) FLAGS="$(FLAGS)" ARCH=$(ARM) bash scripts/wheel.sh out/wheel-again$(FOR)
	@cmp out/wheel$(FOR)/luxpipe-*.whl out/wheel-again$(FOR)/luxpipe-*.whl && echo "built twice: the same bytes"
	@bash scripts/try_wheel.sh out/wheel$(FOR)/luxpipe-*.whl

release: ## out/release: sources, packages, wheels, sums, notes of the last commit (TRY=yes: each is tried, too; hours)
	@JOBS=$(JOBS) TRY=$(TRY) bash scripts/release.sh out/release

bench: everything ## the speed claims, measured again
	@bash bench/run.sh "$(BUILD)/bin"

coverage: all ## how often intervals hold the truth: SCENES="1000-1011 office" SEEDS=200 SIZE=48 FRAMES=74 (hours)
	@python3 studies/coverage/coverage.py -bin "$(BUILD)/bin" -out out/coverage -scenes "$(or $(SCENES),1000-1011)" \
		-seeds $(or $(SEEDS),200) -size $(or $(SIZE),48) -frames $(or $(FRAMES),74)

coverage-sensors: all ## the same of grids of sensors: SCENES="1070-1075" SEEDS=200 FRAMES=256 (hours)
	@python3 studies/coverage/sensors.py -bin "$(BUILD)/bin" -out out/sensors -scenes "$(or $(SCENES),1070-1075)" \
		-seeds $(or $(SEEDS),200) -frames $(or $(FRAMES),256)

year: all ## a year at four desks, one day a month: out/year/year.html (WEATHER=site.epw HOURS='Mo-Fr 8-18')
	@$(MAKE) -C studies/year -j $(JOBS) BIN="$(abspath $(BUILD))/bin"

certificate: all ## docs/certificate.md: what is older than lib is measured again (SIZE=128 FRAMES=17)
	@cmake --build "$(BUILD)" -j $(JOBS) --target blocks trace_rays bits_test
	@BIN="$(BUILD)/bin" bash studies/certificate/make.sh $(or $(SIZE),128) $(or $(FRAMES),17)

opencl-stacks: all ## other systems' drivers, for `certificate`: CACHE=FOLDER (debootstrap, root)
	@python3 -B studies/certificate/opencl.py -bin "$(BUILD)/bin" "$(or $(CACHE),$(HOME)/.cache/luxpipe/opencl)"

compare-radiance: all ## N=100 random scenes from SEED=1 on, by ptrace and by rtrace (where RADIANCE is)
	@cmake --build "$(BUILD)" -j $(JOBS) --target trace_rays
	@python3 tests/compare/radiance/compare.py -n $(or $(N),100) --seed $(or $(SEED),1) \
		--tracer "$(BUILD)/bin/trace_rays"

compare-evalglare: all ## N=100 rows of random pictures from SEED=1 on, by evalglare and by vcmetrics (where it is)
	@python3 tests/compare/evalglare/compare.py -n $(or $(N),100) --seed $(or $(SEED),1) \
		--vcmetrics "$(BUILD)/bin/vcmetrics"

man: ## the manual pages as HTML in out/man
	@mkdir -p out/man
	@for p in man/*.[157]; do mandoc -T html -O man=%N.%S.html $$p > out/man/$$(basename $$p).html; done
	@echo out/man/luxpipe.7.html

site: PARTS = site
site: setup ## the documentation as a site in out/site/html; its generator comes from the package index
	@bash scripts/site.sh out/site

format: ## lay out the C++ files with clang-format
	@clang-format -i $(CXX_FILES)

lint: ## checks that need no build: layout, layers, manual pages, stray paths, ghost files
	@for t in style layering pages paths; do TOP=. bash tests/docs/$$t.sh || exit 1; done

install: SETUP = no
install: all ## tools, manual pages and completions to PREFIX (/usr/local); installs no packages
	@cmake --install "$(BUILD)" --prefix "$(PREFIX)"

uninstall: ## remove what the last `make install` of this build put there
	@xargs -r -d '\n' rm -fv < "$(BUILD)/install_manifest.txt" && rm -f "$(BUILD)/install_manifest.txt"

clean: ## remove build/ and out/
	@rm -rf "$(BUILD)" build-asan build-tsan build-fuzz build-arm64 build-glibc228 build-windows \
	    build-macos out

setup:
	@[ "$(SETUP)" = no ] || sh scripts/setup.sh $(PARTS)
	@[ "$(SETUP)" = no ] || { $(FETCH); }

.PHONY: help all everything demo live test test-gpu test-slow test-slurm test-deb test-arm64 check-macos test-sanitize \
	fuzz deb wheel zip test-windows test-wheel release certificate year opencl-stacks bench coverage coverage-sensors \
	compare-radiance compare-evalglare man site format lint install uninstall clean setup
