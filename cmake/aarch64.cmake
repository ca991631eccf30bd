# SPDX-License-Identifier: MIT
# Debian's cross compiler for arm64, on a Debian that has arm64 as a foreign architecture and the libraries of that one only
# (arm64_root.sh). Programs that the build itself runs, for man pages and completions, run in qemu.

set(CMAKE_SYSTEM_NAME Linux)
set(CMAKE_SYSTEM_PROCESSOR aarch64)
set(CMAKE_CXX_COMPILER aarch64-linux-gnu-g++)
set(CMAKE_CROSSCOMPILING_EMULATOR qemu-aarch64-static)
# GNUInstallDirs uses Debian's folder of an architecture only without cross-compilation.
set(CMAKE_INSTALL_LIBDIR lib/aarch64-linux-gnu CACHE PATH "Libraries")
set(ENV{PKG_CONFIG_LIBDIR} /usr/lib/aarch64-linux-gnu/pkgconfig:/usr/share/pkgconfig)
