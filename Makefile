# SPDX-License-Identifier: MIT
# The menu. What it does stands in CMakePresets.json and cmake/.

.DEFAULT_GOAL := help
.PHONY: help deps run demo test test-all check bench asan tsan fuzz faults guards firmware clean

JOBS ?= $(shell nproc)
ARGS ?=
FUZZ_SECONDS ?= 20
export JOBS

BUILD_DEPS := build/.packages-build
TEST_DEPS := $(BUILD_DEPS) build/.packages-test

help:
	@echo 'make run        the daemon on a simulated ball (ARGS="--speed 10" adds options)'
	@echo 'make demo       a 40-second tour in this terminal, on a daemon of its own'
	@echo 'make test       build and run the tests (the first time: minutes)'
	@echo 'make test-all   everything: sanitizers, linters, fuzzers, fault campaigns (most of an hour)'
	@echo 'make check      clang-format, clang-tidy, shellcheck'
	@echo 'make asan       the tests under AddressSanitizer and UBSan'
	@echo 'make tsan       the tests under ThreadSanitizer'
	@echo 'make fuzz       each fuzzer for FUZZ_SECONDS=20'
	@echo 'make faults     the fault campaigns at full length'
	@echo 'make guards     each safety guard taken out once: a test must go red'
	@echo 'make firmware   the board core for a Cortex-M0+: its size, its worst stack'
	@echo 'make bench      the benchmarks'
	@echo 'make deps       install what is missing (Debian, Ubuntu: apt)'
	@echo 'make clean      remove build/'

build/.packages-%: cmake/apt/%.txt cmake/bootstrap.sh
	@mkdir -p build
	@cmake/bootstrap.sh $*
	@touch $@

deps: $(TEST_DEPS)

.PHONY: release
release: $(BUILD_DEPS)
	@cmake --preset release >build/release.log || { cat build/release.log; exit 1; }
	@cmake --build --preset release

run: release
	build/release/daemon/hedgehogd --simulate $(ARGS)

demo: release
	@build/release/clients/ctl/hedgehogctl demo --private $(ARGS)

test: $(TEST_DEPS)
	cmake --preset dev
	cmake --build --preset dev
	ctest --preset dev -j $(JOBS)

SANITIZER_OPTIONS ?= -DHEDGEHOG_ONE_THREAD_TESTS=ON
asan tsan: $(TEST_DEPS)
	cmake --preset $@ $(SANITIZER_OPTIONS)
	cmake --build --preset $@
	ctest --preset $@ -j $(JOBS)

fuzz: $(TEST_DEPS)
	cmake --preset fuzz -DHEDGEHOG_FUZZ_SECONDS=$(FUZZ_SECONDS)
	cmake --build --preset fuzz
	ctest --preset fuzz -j $(JOBS)

check: $(TEST_DEPS)
	cmake --preset tidy
	cmake/check.sh

.PHONY: campaigns
campaigns: $(TEST_DEPS)
	cmake --preset bench
	cmake --build --preset bench --target campaigns

faults: campaigns
	@set -e; for program in build/bench/tests/campaign/campaign_*; do echo "$$program"; "$$program"; done

firmware: $(TEST_DEPS) build/.packages-firmware
	@tests/firmware/build.sh build/firmware
	cmake --preset dev
	cmake --build --preset dev --target firmware_vectors
	tests/firmware/compare.sh build/dev/tests/firmware/firmware_vectors build/firmware/vectors.elf

.PHONY: faults-ci
faults-ci: campaigns
	ctest --preset campaign -j $(JOBS)

guards: $(TEST_DEPS)
	tests/guards/remove_guards.sh $(ARGS)

bench: $(TEST_DEPS)
	cmake --preset bench
	cmake --build --preset bench --target benchmarks
	@set -e; for program in build/bench/tests/bench/bench_*; do "$$program" --benchmark_min_time=0.2; done

# One after the other: each uses every core.
test-all: $(TEST_DEPS)
	$(MAKE) check
	$(MAKE) firmware
	$(MAKE) faults-ci
	$(MAKE) fuzz
	$(MAKE) asan
	$(MAKE) tsan SANITIZER_OPTIONS=-DHEDGEHOG_ONE_THREAD_TESTS=OFF

clean:
	rm -rf build
