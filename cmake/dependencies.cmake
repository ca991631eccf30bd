# SPDX-License-Identifier: MIT
# All libraries are packages of the distribution (cmake/apt/*.txt). Imported targets are SYSTEM: their warnings are ignored.

set(THREADS_PREFER_PTHREAD_FLAG ON)
find_package(Threads REQUIRED)
find_package(Boost 1.81 REQUIRED)
find_package(Eigen3 3.4 REQUIRED NO_MODULE)
find_package(nlohmann_json 3.11 REQUIRED)
find_package(fmt REQUIRED)
find_package(OpenSSL 3.0 REQUIRED)

if(HEDGEHOG_PROGRAMS)
  find_package(spdlog REQUIRED)
  find_package(CLI11 REQUIRED)
  find_package(PkgConfig REQUIRED)
  pkg_check_modules(SYSTEMD REQUIRED IMPORTED_TARGET libsystemd)
  # The core library only: the package's own CMake file also requires those of its web server and of curl.
  pkg_check_modules(PROMETHEUS REQUIRED IMPORTED_TARGET prometheus-cpp-core)
  pkg_check_modules(URING REQUIRED IMPORTED_TARGET liburing>=2.3)
  pkg_check_modules(LIBUSB REQUIRED IMPORTED_TARGET libusb-1.0>=1.0.24)
  pkg_check_modules(HIDAPI REQUIRED IMPORTED_TARGET hidapi-hidraw)
  # The physics of hedgehog-racer.
  pkg_check_modules(BULLET REQUIRED IMPORTED_TARGET bullet)
  # Sound files that hedgehogctl plays.
  pkg_check_modules(SNDFILE REQUIRED IMPORTED_TARGET sndfile)
  # hedgehog-mqtt.
  pkg_check_modules(MOSQUITTO REQUIRED IMPORTED_TARGET libmosquitto)
  # The fit of psychometric curves in hedgehog-study.
  pkg_check_modules(NLOPT REQUIRED IMPORTED_TARGET nlopt)
endif()

if(HEDGEHOG_TESTS)
  find_package(GTest REQUIRED)
  find_package(rapidcheck REQUIRED)
  find_package(benchmark REQUIRED)
endif()
