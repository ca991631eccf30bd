// SPDX-License-Identifier: MIT
// The vectors on a bare Cortex-M0 under qemu: vector table, start-up, and exit by semihosting.
// Paints the stack first, and prints on stderr at the end how much of it was used.
#ifdef __arm__  // so that linters on the host skip it

#include <stddef.h>
#include <stdint.h>

#include "daemon/device/board_core/board_core.h"
#include "tests/firmware/vectors.h"

extern "C" {
extern uint32_t stack_top[];
extern uint32_t stack_bottom[];
extern uint32_t bss_start[];
extern uint32_t bss_end[];

// Functions that the compiler calls implicitly in freestanding code.
void* memset(void* to, int value, size_t count) {
  auto* bytes = static_cast<volatile uint8_t*>(to);
  for (size_t i = 0; i < count; ++i) bytes[i] = static_cast<uint8_t>(value);
  return to;
}
void* memcpy(void* to, const void* from, size_t count) {
  auto* bytes = static_cast<volatile uint8_t*>(to);
  for (size_t i = 0; i < count; ++i) bytes[i] = static_cast<const uint8_t*>(from)[i];
  return to;
}

void start();
}

namespace {

constexpr uint32_t kPaint = 0xA5A5A5A5u;

// Arm's "Semihosting for AArch32 and AArch64", release 2.0.
constexpr uint32_t kOpen = 0x01;
constexpr uint32_t kWrite = 0x05;
constexpr uint32_t kExitExtended = 0x20;
constexpr uint32_t kApplicationExit = 0x20026;

uint32_t semihosting(uint32_t operation, const void* argument) {
  register uint32_t r0 asm("r0") = operation;
  register const void* r1 asm("r1") = argument;
  asm volatile("bkpt 0xab" : "+r"(r0) : "r"(r1) : "memory");
  return r0;
}

size_t length(const char* text) {
  size_t n = 0;
  while (text[n] != 0) ++n;
  return n;
}

/// ":tt" opened for writing is stdout, opened for appending stderr.
uint32_t open_console(uint32_t mode) {
  const uint32_t arguments[] = {reinterpret_cast<uint32_t>(":tt"), mode, 3};
  return semihosting(kOpen, arguments);
}

uint32_t console;

void write(uint32_t file, const char* text) {
  const uint32_t arguments[] = {file, reinterpret_cast<uint32_t>(text), length(text)};
  semihosting(kWrite, arguments);
}

void print(const char* line) {
  write(console, line);
  write(console, "\n");
}

void write_number(uint32_t file, uint32_t value) {
  char digits[11];
  char* at = digits + 10;
  *at = 0;
  do {
    *--at = static_cast<char>('0' + value % 10);
    value /= 10;
  } while (value != 0);
  write(file, at);
}

[[noreturn]] void exit_with(uint32_t code) {
  const uint32_t arguments[] = {kApplicationExit, code};
  semihosting(kExitExtended, arguments);
  for (;;) {
  }
}

[[noreturn]] void crashed() { exit_with(70); }

void paint_stack() {
  const auto* here = static_cast<const uint32_t*>(__builtin_frame_address(0));
  // Leaves out the part of the stack that is already in use.
  for (volatile uint32_t* word = stack_bottom; word < here - 16; ++word) *word = kPaint;
}

uint32_t stack_used() {
  const volatile uint32_t* word = stack_bottom;
  while (*word == kPaint) ++word;
  return static_cast<uint32_t>(reinterpret_cast<uintptr_t>(stack_top) -
                               reinterpret_cast<uintptr_t>(word));
}

using Handler = void (*)();
[[gnu::section(".vectors"), gnu::used]] const Handler kVectors[] = {
    reinterpret_cast<Handler>(stack_top), start, crashed, crashed};

}  // namespace

void start() {
  for (uint32_t* word = bss_start; word < bss_end; ++word) *word = 0;
  paint_stack();
  console = open_console(4);
  const bool good = hedgehog::firmware::run_vectors(print);
  const uint32_t errors = open_console(8);
  write(errors, "state of the core: ");
  write_number(errors, sizeof(hedgehog::board::BoardCore));
  write(errors, " bytes; stack used by the vectors, bench included: ");
  write_number(errors, stack_used());
  write(errors, " bytes\n");
  exit_with(good ? 0 : 1);
}

#endif
