# SPDX-License-Identifier: MIT
# The menu. What it does stands in CMakePresets.json and cmake/.

.DEFAULT_GOAL := help
.PHONY: help deps run race demo test deb test-deb test-web test-sdk test-openrpc test-json-rpc test-bids test-monitoring test-mqtt test-install test-usb test-all check bench asan tsan fuzz faults guards mutations coverage firmware stress clean

JOBS ?= $(shell nproc)
ARGS ?=
FUZZ_SECONDS ?= 20
# Limit of a guest's processor time; those of test-usb take 700 s together on a slow machine.
VM_SECONDS ?= 1800
export JOBS

# Takes the time of a command when HEDGEHOG_STAGES names a file.
STAGE := cmake/stage.sh

BUILD_DEPS := build/.packages-build
TEST_DEPS := $(BUILD_DEPS) build/.packages-test

help:
	@echo 'make run        the daemon on a simulated ball (ARGS="--speed 10" adds options)'
	@echo 'make race       the racing game, beside make run or alone; its page is http://127.0.0.1:7585'
	@echo 'make tools      hedgehogctl, for the ball of make run'
	@echo 'make release    all programs as they ship'
	@echo 'make install    what make release built, below PREFIX=/usr/local (and DESTDIR)'
	@echo 'make demo       a 40-second tour in this terminal, on a daemon of its own'
	@echo 'make test       build and run the tests (the first time: minutes)'
	@echo 'make test-web   the pages in a browser without a screen'
	@echo 'make test-sdk   the client libraries against a simulated daemon, and the table of who passes what'
	@echo 'make test-openrpc  the machine-readable protocol with OpenRPC'"'"'s own tools'
	@echo 'make test-json-rpc  the daemon with JSON-RPC clients and JSON documents that others wrote'
	@echo 'make test-bids  a study'"'"'s export before the BIDS validator'
	@echo 'make test-all   what ships, guards, fault campaigns, and one of three parts, by the day: lint, pages, USB, sanitizers'
	@echo 'make test-all PARTS="1 2 3"  all of it (more than an hour)'
	@echo 'make test-install  what ships, installed, and a game compiled against it'
	@echo 'make deb        Debian packages in build/deb; make test-deb tries them in a fresh Debian (BEFORE=FOLDER: upgraded from those)'
	@echo 'make test-deb-upgrade  upgraded from the packages of the commit before, built for it (REV=COMMIT: of that one), also under systemd'
	@echo 'make test-deb-reproducible  compiled again in another folder: equal packages'
	@echo 'make deb-arm64  the same for a Raspberry Pi, cross-compiled, in build/deb-arm64; make test-deb-arm64 tries them in an emulated Debian'
	@echo 'make test-service  the packages under systemd, in an emulated machine'
	@echo 'make test-release  the release script (cmake/release.sh), in a clone'
	@echo 'make test-mqtt  the ball at Debian'"'"'s MQTT broker'
	@echo 'make fleet DAEMONS=50 MINUTES=10  simulated daemons, an MQTT broker and Prometheus: what they cost'
	@echo 'make test-discovery  balls announced and found on a network, by Debian'"'"'s Avahi'
	@echo 'make test-monitoring  the alert rules and the dashboard in Prometheus'
	@echo 'make test-usb   real USB and HID: the daemon in a machine with Debian'"'"'s kernel, on emulated devices'
	@echo 'make check      clang-format, shellcheck, clang-tidy; each file compiled by itself'
	@echo 'make asan       the tests under AddressSanitizer and UBSan'
	@echo 'make tsan       under ThreadSanitizer, the tests in which threads meet'
	@echo 'make fuzz       each fuzzer for FUZZ_SECONDS=20'
	@echo 'make soak       random clients, kills and full disks against the daemon under AddressSanitizer (ARGS="--seconds 1200 --seed 7")'
	@echo 'make faults     the fault campaigns at full length'
	@echo 'make rehearsal  a study of ten simulated people under twenty kills (REHEARSAL=whole: 5 s circles)'
	@echo 'make guards     each safety guard taken out once: a test must go red'
	@echo 'make mutations  safety code with one operator, constant or statement wrong: a test must go red (ARGS=--changed: your lines)'
	@echo 'make coverage   every line of board core, limiter and watchdog is executed by the tests'
	@echo 'make firmware   the reference board'"'"'s image in build/firmware, on an emulated RP2040 with a simulated ball'
	@echo 'make firmware-play HOURS=1  a game on that emulated board; make firmware-frames FRAMES=1048576 compares it with the host'"'"'s'
	@echo 'make firmware-rehearsal  a ball brought up on it, calibrate --thermal included (half an hour of its time); SEED=N: another ball'
	@echo 'make firmware-calibrated CALIBRATION=my-board.h  the image for a board of your own, with its measured figures'
	@echo 'make firmware-guards  each guard of that image taken out once: a test must go red'
	@echo 'make reference-board  the electrical rules of the driver board (firmware/board)'
	@echo 'make bench      the daemon beside reference programs, as one table (also build/bench.json), after benchmarks of its functions'
	@echo 'make tls-latency  round trips and new connections over TLS, also of WebSocket, beside TCP'
	@echo 'make bench-compare REV=main  this tree beside another revision, in the same rounds'
	@echo 'make instructions  instructions of three requests and a tick, within 2 % of what is written; make instructions-write writes them'
	@echo 'make stress     the tests of CI ROUNDS=5 times on a busy machine, each time another of the three parts (up to an hour a round)'
	@echo 'make deps       install what is missing (Debian, Ubuntu: apt)'
	@echo 'make clean      remove build/'

# make run and make race may start at once, in two terminals: what both need is made once. Packages, pages and programs
# have locks of their own, so that pages are bundled while programs are compiled.
LOCK_PACKAGES := flock build/.lock-packages
LOCK_PAGES := flock build/.lock-pages
LOCK_RUN := flock build/.lock-run
LOCK_RELEASE := flock build/.lock-release

# Targets that are made side by side share these builds: each is configured once (ninja does it again when a list of
# files changes) and built by one ninja at a time.
CONFIGURED_DEV := build/dev/build.ninja
CONFIGURED_BENCH := build/bench/build.ninja
LOCK_DEV := flock build/.lock-dev
LOCK_BENCH := flock build/.lock-bench
BUILD_DEV := cmake --build --preset dev
BUILD_BENCH := cmake --build --preset bench

build/.packages-%: cmake/apt/%.txt cmake/bootstrap.sh
	@mkdir -p build
	@$(LOCK_PACKAGES) cmake/bootstrap.sh $*
	@touch $@

deps: $(TEST_DEPS)

# Programs that are started at once: what they need and no more, in batches, so that a newcomer does not wait for long.
BUILD_RUN := $(LOCK_RUN) cmake --build --preset run
.PHONY: run-configured
run-configured: $(BUILD_DEPS)
	@$(LOCK_RUN) cmake --preset run >build/run.log || { cat build/run.log; exit 1; }

# What ships: each file by itself.
.PHONY: release
release: $(BUILD_DEPS) pages
	@$(LOCK_RELEASE) cmake --preset release >build/release.log || { cat build/release.log; exit 1; }
	@$(LOCK_RELEASE) cmake --build --preset release
	@mkdir -p build/release/share && cp -rT $(PAGES) build/release/share/hedgehog

# What `make release` built, below PREFIX (of a package's root DESTDIR). Builds nothing: root installs, others build.
PREFIX ?= /usr/local
INSTALLED ?= build/release
.PHONY: install
install:
	@[ -x $(INSTALLED)/daemon/hedgehogd ] || { echo 'make: nothing to install: make release' >&2; exit 1; }
	@DESTDIR='$(DESTDIR)' cmake --install $(INSTALLED) --prefix '$(PREFIX)'

# hedgehogctl plays on what `make run` started: make tools, in another terminal.
.PHONY: tools
tools: run-configured
	@echo 'make: building hedgehogctl'
	@$(BUILD_RUN) --target hedgehogctl

# node and npm from apt, unless there are some already (of another source, perhaps).
build/.packages-dashboard: cmake/apt/dashboard.txt cmake/bootstrap.sh
	@mkdir -p build
	@{ command -v node && command -v npm; } >/dev/null || $(LOCK_PACKAGES) cmake/bootstrap.sh dashboard
	@touch $@

PAGES := build/run/share/hedgehog
DASHBOARD := $(PAGES)/www
# What build.sh of both pages calls.
BUNDLER := cmake/bundle.sh cmake/compress.sh cmake/npm.sh
DASHBOARD_SOURCES := $(wildcard clients/dashboard/*.* clients/dashboard/src/*) $(BUNDLER)
$(DASHBOARD)/index.html: $(DASHBOARD_SOURCES) build/.packages-dashboard
	@$(LOCK_PAGES) clients/dashboard/build.sh $(DASHBOARD)
	@touch $@

.PHONY: dashboard
dashboard: $(DASHBOARD)/index.html

# The page of the racing game, with the dashboard's packages.
RACER := $(PAGES)/racer
RACER_SOURCES := $(wildcard clients/racer/page/*.* clients/racer/page/src/*) $(BUNDLER) \
  clients/dashboard/package-lock.json clients/dashboard/icon.svg
$(RACER)/index.html: $(RACER_SOURCES) build/.packages-dashboard
	@$(LOCK_PAGES) clients/racer/page/build.sh $(RACER)
	@touch $@

.PHONY: racer-page
racer-page: $(RACER)/index.html

# Programs are worth having without their pages: npm may be out of reach.
.PHONY: pages dashboard-tried racer-page-tried hedgehogd-built hedgehog-racer-built
pages: dashboard-tried racer-page-tried
	@mkdir -p $(PAGES)
dashboard-tried racer-page-tried: %-tried:
	@$(MAKE) --no-print-directory $* >build/$*.log 2>&1 || \
	  { tail -n 3 build/$*.log; echo 'make: no $* this time (build/$*.log); the programs work without it'; } >&2
hedgehogd-built hedgehog-racer-built: %-built: run-configured
	@echo 'make: building $*'
	@$(BUILD_RUN) --target $*

race: run-configured
	@$(MAKE) --no-print-directory -j 2 hedgehog-racer-built racer-page-tried
	build/run/clients/racer/hedgehog-racer $(ARGS)

run: run-configured
	@$(MAKE) --no-print-directory -j 2 hedgehogd-built dashboard-tried
	build/run/daemon/hedgehogd --simulate $(ARGS)

test-web: dashboard racer-page build/.packages-web $(CONFIGURED_DEV)
	@$(LOCK_DEV) $(BUILD_DEV) --target hedgehogd hedgehogctl hedgehog-racer hedgehog-study hedgehog-design
	@mkdir -p build/dev/share/hedgehog
	@ln -sfn $(CURDIR)/$(DASHBOARD) build/dev/share/hedgehog/www
	@ln -sfn $(CURDIR)/$(RACER) build/dev/share/hedgehog/racer
	@$(STAGE) 'tests web' tests/web/run.sh build/dev

# The client libraries of all languages.
test-sdk: dashboard racer-page $(CONFIGURED_DEV) build/.packages-dashboard build/.packages-web build/.packages-csharp build/.packages-godot \
  build/.packages-python
	@$(LOCK_DEV) $(BUILD_DEV) --target hedgehogd hedgehogctl cpp_conformance cpp_racer cpp_session slow_names
	@$(STAGE) 'tests sdk' tests/sdk/run.sh build/dev

test-openrpc: build/.packages-dashboard
	@$(STAGE) 'tests openrpc' tests/openrpc/run.sh

test-json-rpc: $(CONFIGURED_DEV) build/.packages-dashboard build/.packages-json_rpc
	@$(LOCK_DEV) $(BUILD_DEV) --target hedgehogd json_readers
	@$(STAGE) 'tests json-rpc' tests/json_rpc/run.sh build/dev

# Alert rules and dashboard in Debian's Prometheus.
test-monitoring: build/.packages-monitoring $(CONFIGURED_DEV)
	@$(LOCK_DEV) $(BUILD_DEV) --target hedgehogd
	@$(STAGE) 'tests monitoring' tests/monitoring/run.sh build/dev

# Part of it in network namespaces (root, or sudo without password).
test-mqtt: build/.packages-mqtt $(CONFIGURED_DEV)
	@$(LOCK_DEV) $(BUILD_DEV) --target test_mqtt mqtt_fleet
	@$(STAGE) 'tests mqtt' tests/mqtt/run.sh build/dev

# Announced and found by Debian's Avahi, in a network namespace (root, or sudo without password).
.PHONY: test-discovery
test-discovery: build/.packages-discovery build/.packages-dashboard $(CONFIGURED_DEV)
	@$(LOCK_DEV) $(BUILD_DEV) --target hedgehogd hedgehogctl announce
	@$(STAGE) 'tests discovery' tests/discovery/run.sh build/dev

test-bids: build/.packages-dashboard $(CONFIGURED_DEV)
	@$(LOCK_DEV) $(BUILD_DEV) --target hedgehogd hedgehog-study
	@$(STAGE) 'tests bids' tests/bids/run.sh build/dev

demo: run-configured
	@echo 'make: building hedgehogd and hedgehogctl'
	@$(BUILD_RUN) --target hedgehogd hedgehogctl
	@build/run/clients/ctl/hedgehogctl demo --private $(ARGS)

build/%/build.ninja: CMakePresets.json $(TEST_DEPS)
	cmake --preset $*
	@touch $@

.PHONY: dev
dev: $(CONFIGURED_DEV)
	@$(LOCK_DEV) $(STAGE) 'build dev' $(BUILD_DEV)

test: dev
	tests/run.sh dev

# Their tests, and the end-to-end tests of dev on their programs.
.PHONY: asan-tests tsan-tests asan-programs tsan-programs
asan tsan: %: %-tests %-programs
asan-tests tsan-tests asan-programs tsan-programs: dev
	cmake --preset $(firstword $(subst -, ,$@))
	@$(STAGE) 'build $(firstword $(subst -, ,$@))' cmake --build --preset $(firstword $(subst -, ,$@))
	tests/run.sh $(subst -, ,$@)

fuzz: $(TEST_DEPS)
	cmake --preset asan -DHEDGEHOG_FUZZ_SECONDS=$(FUZZ_SECONDS)
	@$(STAGE) 'build fuzzers' cmake --build --preset asan --target fuzzers
	@$(STAGE) 'fuzz' ctest --preset fuzz -j $(JOBS)

# The clients are those of dev. ARGS: tests/soak/README.md. Ten minutes, if it does not say otherwise.
.PHONY: soak
soak: $(CONFIGURED_DEV) build/asan/build.ninja
	@$(LOCK_DEV) $(BUILD_DEV) --target soak
	@$(STAGE) 'build asan daemon' cmake --build --preset asan --target hedgehogd
	@HEDGEHOG_PROGRAMS=$(CURDIR)/build/asan HEDGEHOG_SPEED_LIMIT=4 UBSAN_OPTIONS=print_stacktrace=1 \
	  ASAN_OPTIONS=detect_stack_use_after_return=1:handle_abort=1 $(STAGE) soak build/dev/tests/soak $(ARGS)

CHECKS ?= format shell tidy alone
check: $(TEST_DEPS)
	@set -e; for one in $(CHECKS); do $(STAGE) "check $$one" cmake/check.sh "$$one"; done

faults: $(CONFIGURED_BENCH)
	$(LOCK_BENCH) $(BUILD_BENCH) --target campaigns
	@set -e; for program in build/bench/tests/campaign/campaign_*; do echo "$$program"; "$$program"; done

FIRMWARE_IMAGE := build/dev/firmware/firmware_image
firmware: $(CONFIGURED_DEV) build/.packages-firmware build/.packages-dashboard
	@$(LOCK_DEV) $(BUILD_DEV) --target firmware_image firmware_plant firmware_vectors hedgehogd hedgehogctl
	@$(LOCK_DEV) $(STAGE) 'build firmware' firmware/build.sh build/firmware $(FIRMWARE_IMAGE)
	@build/dev/clients/ctl/hedgehogctl board flash --check build/firmware/hedgehog-board.uf2
	@$(STAGE) 'build vectors' tests/firmware/build.sh build/firmware
	@$(STAGE) 'tests reproducible' tests/firmware/reproducible.sh build/firmware $(FIRMWARE_IMAGE)
	@$(STAGE) 'tests vectors' tests/firmware/compare.sh build/dev/tests/firmware/firmware_vectors build/firmware/vectors.elf
	@$(STAGE) 'tests firmware' tests/firmware/emulated/run.sh build/firmware/hedgehog-board.elf \
	  build/dev/tests/firmware/firmware_plant build/npm/firmware build/dev

# Each guard of the image taken out once: a test must go red. ARGS: --third, or a word of its name or hazard.
.PHONY: firmware-guards
firmware-guards: $(CONFIGURED_DEV) build/.packages-firmware build/.packages-dashboard
	@$(LOCK_DEV) $(BUILD_DEV) --target firmware_image firmware_plant hedgehogd
	@$(LOCK_DEV) firmware/build.sh build/firmware $(FIRMWARE_IMAGE) >/dev/null
	@$(STAGE) 'firmware guards' tests/firmware/emulated/run.sh build/firmware/hedgehog-board.elf build/dev/tests/firmware/firmware_plant \
	  build/npm/firmware build/dev guards $(FIRMWARE_IMAGE) $(ARGS)

# Play for HOURS of device time, which a quiet machine computes twice as fast, and FRAMES of telemetry compared with the
# host's board core.
HOURS ?= 1
FRAMES ?= 1048576
.PHONY: firmware-built firmware-play firmware-frames
firmware-built: $(CONFIGURED_DEV) build/.packages-firmware build/.packages-dashboard
	@$(LOCK_DEV) $(BUILD_DEV) --target firmware_image firmware_plant hedgehogd hedgehogctl
	@$(LOCK_DEV) firmware/build.sh build/firmware $(FIRMWARE_IMAGE) >/dev/null
EMULATED := tests/firmware/emulated/run.sh build/firmware/hedgehog-board.elf build/dev/tests/firmware/firmware_plant build/npm/firmware build/dev
firmware-play: firmware-built
	@$(STAGE) 'firmware play' $(EMULATED) play $$(awk 'BEGIN { print 60 * $(HOURS) }')
firmware-frames: firmware-built
	@HEDGEHOG_FIRMWARE_TICKS=$(FRAMES) $(STAGE) 'firmware frames' $(EMULATED) test timing 'frames are those'

# The guides for bringing up board and ball, with half an hour of `calibrate --thermal`.
.PHONY: firmware-rehearsal
firmware-rehearsal: firmware-built
	@HEDGEHOG_FIRMWARE_REHEARSAL=thermal HEDGEHOG_FIRMWARE_SEED=$(SEED) HEDGEHOG_FIRMWARE_TICKS=1000000 $(STAGE) 'firmware rehearsal' $(EMULATED) test rehearsal

# The image for a board whose figures have been measured (firmware/board/bring-up.md, step 6), and what it reads.
CALIBRATION ?= firmware/calibration.h
.PHONY: firmware-calibrated
firmware-calibrated: $(CONFIGURED_DEV) build/.packages-firmware build/.packages-dashboard
	@$(LOCK_DEV) $(BUILD_DEV) --target firmware_image firmware_plant
	@$(LOCK_DEV) firmware/build.sh build/firmware/calibrated $(FIRMWARE_IMAGE) $(CALIBRATION)
	@HEDGEHOG_FIRMWARE_CALIBRATION=$(abspath $(CALIBRATION)) $(STAGE) 'tests calibration' tests/firmware/emulated/run.sh \
	  build/firmware/calibrated/hedgehog-board.elf build/dev/tests/firmware/firmware_plant build/npm/firmware build/dev test calibration
	@echo 'make: build/firmware/calibrated/hedgehog-board.uf2 is for the board with the figures of $(CALIBRATION)'

# The rules of the driver board's netlist, and whether each finds what breaks it. Node has them all; no npm.
.PHONY: reference-board
firmware: reference-board
reference-board: build/.packages-dashboard
	@node firmware/board/board.mjs check
	@$(STAGE) 'tests reference-board' node --test tests/firmware_board/

# The guest runs what ships: an emulated processor has no time for code that is not optimised. The firmware's image is not that of
# `make firmware` and `make firmware-guards`, which may run beside it.
USB_IMAGE := build/firmware/usb
test-usb: shipped $(CONFIGURED_DEV) build/.packages-vm build/.packages-firmware build/.packages-dashboard
	@$(LOCK_DEV) $(STAGE) 'build test_usb' $(BUILD_DEV) --target test_usb firmware_image firmware_plant
	@$(LOCK_DEV) firmware/build.sh $(USB_IMAGE) $(FIRMWARE_IMAGE) >/dev/null
	@HEDGEHOG_FIRMWARE_ELF=$(CURDIR)/$(USB_IMAGE)/hedgehog-board.elf HEDGEHOG_PROGRAMS=$(CURDIR)/build/bench $(STAGE) 'tests usb' tests/vm/test.sh -t $(VM_SECONDS) build/dev/tests/vm/test_usb

# All programs as they ship, with campaigns.
.PHONY: shipped
shipped: $(CONFIGURED_BENCH)
	@$(LOCK_BENCH) $(STAGE) 'build shipped' $(BUILD_BENCH) --target programs campaigns

# With their pages. Of two stages that run side by side the second one copies no file again (-u) that the first one may be reading.
.PHONY: shipped-pages
shipped-pages: shipped dashboard racer-page
	@$(LOCK_BENCH) sh -c 'mkdir -p build/bench/share && cp -ruT $(PAGES) build/bench/share/hedgehog'

# Some of the end-to-end tests of dev on them.
.PHONY: test-shipped
test-shipped: shipped dev
	tests/run.sh bench

.PHONY: faults-ci
faults-ci: shipped
	@$(STAGE) 'fault campaigns' ctest --preset campaign -j $(JOBS)

# What ships in a prefix of its own, and the C++ program of clients/cpp.md compiled against it.
.PHONY: test-install
test-install: shipped-pages
	@$(STAGE) 'tests install' tests/install/run.sh build/bench

# Debian packages of what `make release` built, or `make shipped`: PACKED=build/bench.
PACKED ?= build/release
deb: build/.packages-deb
	@$(MAKE) --no-print-directory $(if $(filter build/bench,$(PACKED)),shipped-pages,release)
	@$(STAGE) 'build deb' cmake/deb.sh $(PACKED) build/deb

# Installed, used, upgraded and purged in a fresh system below build/; packed a second time, with equal bytes.
# BEFORE, of test-service too: the folder of the packages that the upgrade comes from, of another commit (make deb there).
BEFORE ?=
test-deb: deb
	@$(STAGE) 'tests reproducible' tests/deb/reproducible.sh $(PACKED) build/deb
	@$(STAGE) 'tests deb' tests/deb/run.sh build/deb $(BEFORE)

# Upgraded from the packages of REV, made in a worktree of its own: another build of what ships; in a fresh Debian, and under systemd. Not
# in CI.
.PHONY: test-deb-upgrade
test-deb-upgrade: REV = HEAD~1
test-deb-upgrade: deb build/.packages-vm build/.packages-discovery
	@$(STAGE) 'build deb before' cmake/deb_revision.sh $(REV) $(CURDIR)/build/before $(PACKED)
	@$(STAGE) 'tests deb upgrade' tests/deb/run.sh build/deb build/before/build/deb
	@VM_SECONDS=$(VM_SECONDS) $(STAGE) 'tests service upgrade' tests/vm/service.sh build/deb $(PACKED)/emulator/hedgehog-usbip build/before/build/deb

# What is committed, compiled again in another folder: equal bytes. Not in CI.
.PHONY: test-deb-reproducible
test-deb-reproducible: deb
	@$(STAGE) 'tests deb reproducible' tests/deb/compiled_again.sh $(PACKED) build/deb

# Packages for arm64, cross-compiled in a fresh Debian below build/, in batches, and tried in a fresh Debian for arm64 in which
# every program is emulated. Not in make test-all: CI is long enough.
ARM64_QEMU := build/qemu-aarch64-static
ARM64_ROOT := build/cross-arm64.tar
$(ARM64_QEMU): cmake/qemu_arm64.sh
	@mkdir -p build
	@cmake/qemu_arm64.sh $@
$(ARM64_ROOT): cmake/arm64_root.sh cmake/fresh_debian.sh cmake/apt/deb_arm64.txt debian/control $(ARM64_QEMU) build/.packages-deb
	@$(STAGE) 'root arm64' cmake/arm64_root.sh $(ARM64_QEMU) $@
.PHONY: deb-arm64 test-deb-arm64
deb-arm64: $(ARM64_ROOT) pages
	@JOBS=$(JOBS) $(STAGE) 'build deb arm64' cmake/deb_arm64.sh $(ARM64_ROOT) $(PAGES) build/deb-arm64
test-deb-arm64: deb-arm64 run-configured
	@$(BUILD_RUN) --target hedgehogd hedgehogctl hedgehog-design
	@$(STAGE) 'tests deb arm64' tests/deb/run.sh build/deb-arm64 $(BEFORE)

# The packages under systemd, in the emulated machine: upgraded, killed, hung, reloaded, stopped, started by udev, purged.
.PHONY: test-service
test-service: deb build/.packages-vm build/.packages-discovery
	@VM_SECONDS=$(VM_SECONDS) $(STAGE) 'tests service' tests/vm/service.sh build/deb $(PACKED)/emulator/hedgehog-usbip $(BEFORE)

# Simulated daemons with an MQTT broker and Prometheus: processor time, memory, what is lost. Not in CI.
DAEMONS ?= 50
MINUTES ?= 10
.PHONY: fleet
fleet: shipped build/.packages-mqtt build/.packages-monitoring
	@tests/fleet/fleet.py build/bench $(DAEMONS) $$(awk 'BEGIN { print 60 * $(MINUTES) }')

# The release script in a clone.
.PHONY: test-release
test-release: build/.packages-deb $(BUILD_DEPS)
	@$(STAGE) 'tests release' tests/release/run.sh

# Ten simulated people through the three experiments, runner and daemon killed twenty times.
.PHONY: rehearsal
REHEARSAL ?= short
rehearsal: $(CONFIGURED_DEV)
	@$(LOCK_DEV) $(BUILD_DEV) --target test_e2e
	HEDGEHOG_STUDY_REHEARSAL=$(REHEARSAL) $(STAGE) rehearsal build/dev/tests/test_e2e --gtest_filter='Kills.*'

guards: dev
	@$(STAGE) guards tests/guards/remove_guards.sh $(ARGS)

mutations: dev
	@$(STAGE) mutations tests/mutations/mutate.sh $(ARGS)

coverage: dev
	@$(STAGE) coverage tests/mutations/coverage.sh

# Functions first, then the daemon beside reference programs: ten minutes at most. ARGS: tests/bench/README.md.
BENCH := build/bench/tests/bench
bench: $(CONFIGURED_BENCH) build/.packages-bench build/.packages-stress
	@$(LOCK_BENCH) $(BUILD_BENCH) --target benchmarks
	@rm -rf build/bench-functions && mkdir build/bench-functions
	@set -e; begun=$$(date +%s); for program in $(BENCH)/bench_*; do \
	  "$$program" --benchmark_min_time=0.2 --benchmark_out=build/bench-functions/$${program##*/bench_}.json; done; \
	$(BENCH)/rounds --out build/bench.json --functions build/bench-functions --commit "$$(git describe --always --dirty 2>/dev/null)" \
	  $(if $(findstring --limit,$(ARGS)),,--limit $$((570 - $$(date +%s) + begun))) $(ARGS)

# This tree's build beside that of revision REV.
REV ?= HEAD
.PHONY: bench-compare
bench-compare: $(CONFIGURED_BENCH) build/.packages-bench build/.packages-stress
	@$(LOCK_BENCH) $(BUILD_BENCH) --target rounds
	@tests/bench/compare.sh $(REV) $(ARGS)

.PHONY: tls-latency
tls-latency: shipped
	@tests/bench/tls_latency.py build/bench

# Instructions a request and a tick, against tests/bench/instructions/instructions.json.
.PHONY: instructions instructions-write
instructions: $(CONFIGURED_BENCH) build/.packages-bench
	@$(LOCK_BENCH) $(BUILD_BENCH) --target instructions
	@$(STAGE) 'instructions' tests/bench/instructions/check.sh $(BENCH)/instructions
instructions-write: $(CONFIGURED_BENCH) build/.packages-bench
	@$(LOCK_BENCH) $(BUILD_BENCH) --target instructions
	@tests/bench/instructions/check.sh $(BENCH)/instructions --write

# What waits most of the time goes on beside what computes; its output comes when it has ended. A stage that fails keeps
# none of the others from being tried; in CI one that would begin too late is not begun.
# What takes longest is divided into three parts, of which each day has one: PARTS=2 is another, PARTS="1 2 3" is everything.
# Every second time a part comes before most of the daily stages, so that a slow machine has no time for other ones.
# The emulated machines of test-usb and test-service are never side by side: each needs a processor.
ifndef PARTS
PARTS := $(shell expr $$(date +%s) / 86400 % 3 + 1)
endif
export PARTS
CHECKING := mutations-in-ci coverage
CHECKING_2 := tidy-in-ci
CHECKING_3 := alone-in-ci
COMPUTING := shipped instructions faults-ci guards-in-ci firmware-guards-in-ci
COMPUTING_1 := asan-tests asan-programs fuzz-in-ci
COMPUTING_3 := tsan-tests tsan-programs
WAITING_1 := test-sdk
WAITING_2 := test-usb
WAITING_3 := 'test-deb test-service PACKED=build/bench'
BESIDE := test-openrpc test-json-rpc
BESIDE_1 := test-bids test-monitoring test-mqtt test-discovery test-release test-web
BESIDE_2 := rehearsal test-shipped
BESIDE_3 := test-install
PART_FIRST := $(filter 1,$(shell expr $$(date +%s) / 86400 / 3 % 2))
parts_of = $(if $(filter-out 1 2 3,$(PARTS)),$(error PARTS is $(PARTS): 1, 2, 3 or several of them))$(foreach part,$(PARTS),$($1_$(part)))
stages_of = $(if $(PART_FIRST),$(call parts_of,$1) $($1),$($1) $(call parts_of,$1))
PACKAGES := build test firmware json_rpc bench
PACKAGES_1 := web csharp godot python monitoring mqtt discovery deb
PACKAGES_2 := vm
PACKAGES_3 := vm deb discovery
.PHONY: packages-in-ci computing computing-tests waiting beside waiting-and-beside
.PHONY: tidy-in-ci alone-in-ci fuzz-in-ci guards-in-ci firmware-guards-in-ci mutations-in-ci
.PHONY: part-of-the-day
part-of-the-day:
	@echo $(PARTS)
# What the stages of the day install, before the first one; node and npm are installed where they are missing.
packages-in-ci:
	@$(STAGE) packages cmake/bootstrap.sh $(call stages_of,PACKAGES)
computing:
	@cmake/each_target.sh firmware $(call stages_of,CHECKING) $(call stages_of,COMPUTING)
# Without linters, coverage and mutants, whose results say nothing about a busy machine.
computing-tests:
	@cmake/each_target.sh firmware $(call stages_of,COMPUTING)
waiting:
	@cmake/each_target.sh $(call stages_of,WAITING)
beside:
	@cmake/each_target.sh $(call stages_of,BESIDE)
waiting-and-beside:
	@tests/side_by_side.sh beside waiting

tidy-in-ci:
	@$(MAKE) --no-print-directory check CHECKS=tidy-product
alone-in-ci:
	@$(MAKE) --no-print-directory check CHECKS=alone-third
fuzz-in-ci:
	@$(MAKE) --no-print-directory fuzz FUZZ_SECONDS=10
guards-in-ci firmware-guards-in-ci: %-in-ci:
	@$(MAKE) --no-print-directory $* ARGS=--third
mutations-in-ci:
	@$(MAKE) --no-print-directory mutations ARGS=--changed

# What is quick and fails often comes first. The pages are bundled before two lanes need them.
test-all: $(TEST_DEPS)
	$(MAKE) check CHECKS='format shell'
	$(MAKE) $(CONFIGURED_DEV) $(CONFIGURED_BENCH)
	-$(MAKE) dashboard racer-page
	tests/side_by_side.sh waiting-and-beside computing

# The tests of CI again and again on a machine that has no time for them.
ROUNDS ?= 5
FIRST ?= 1
stress: build/.packages-stress
	tests/stress.sh $(ROUNDS) $(FIRST)

clean:
	rm -rf build
