// SPDX-License-Identifier: MIT
#include "emulator/firmware/uart.h"

#include <stdexcept>

#if defined(__x86_64__) || defined(__i386__)
#include <sys/io.h>

#include <cerrno>
#include <system_error>
#endif

namespace hedgehog::emulator {

#if defined(__x86_64__) || defined(__i386__)
namespace {

using device::Byte;

// Registers of a 16550A.
constexpr unsigned short kData = 0x3E8;
constexpr unsigned short kInterruptEnable = kData + 1;
constexpr unsigned short kFifoControl = kData + 2;
constexpr unsigned short kLineControl = kData + 3;
constexpr unsigned short kModemControl = kData + 4;
constexpr unsigned short kLineStatus = kData + 5;
constexpr unsigned short kScratch = kData + 7;
constexpr unsigned long kRegisters = 8;

constexpr Byte kEightBits = 0x03;
/// FIFOs on and empty; the trigger level of 14 bytes is also what qemu sends at once.
constexpr Byte kFifos = 0xC7;
constexpr Byte kReady = 0x03;  // DTR, RTS
constexpr Byte kReceived = 0x01;
constexpr Byte kTransmitterEmpty = 0x20;
constexpr std::size_t kFifoBytes = 16;
constexpr int kMaxTransmitPolls = 10'000'000;
constexpr Byte kPattern = 0x5A;
/// Between two polls. Each takes one instruction of the guest, and qemu about a microsecond, in
/// which its other thread can fill the FIFO. Without them an exchange takes 450 us of the guest's
/// time, with them 20 us.
constexpr int kPauses = 10;

void wait_until_empty() {
  for (int polls = 0; (::inb(kLineStatus) & kTransmitterEmpty) == 0; ++polls)
    if (polls == kMaxTransmitPolls) throw std::runtime_error("the serial port transmits nothing");
}

}  // namespace

Uart::Uart() {
  if (::ioperm(kData, kRegisters, 1) != 0)
    throw std::system_error(errno, std::generic_category(), "I/O ports");
  ::outb(kPattern, kScratch);
  if (::inb(kScratch) != kPattern)
    throw std::runtime_error("no third serial port; tests/vm/firmware.sh runs a machine with one");
  ::outb(0, kInterruptEnable);
  ::outb(kEightBits, kLineControl);
  ::outb(kFifos, kFifoControl);
  ::outb(kReady, kModemControl);
  while (poll()) {
  }
}

void Uart::write(std::span<const Byte> bytes) {
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    if (i % kFifoBytes == 0) wait_until_empty();
    ::outb(bytes[i], kData);
  }
}

std::optional<Byte> Uart::poll() {
  if ((::inb(kLineStatus) & kReceived) == 0) {
    for (int i = 0; i < kPauses; ++i) __builtin_ia32_pause();
    return std::nullopt;
  }
  return ::inb(kData);
}
#else
Uart::Uart() { throw std::runtime_error("this processor has no I/O ports"); }
void Uart::write(std::span<const device::Byte> /*bytes*/) {}
std::optional<device::Byte> Uart::poll() { return std::nullopt; }
#endif

}  // namespace hedgehog::emulator
