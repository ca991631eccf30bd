// SPDX-License-Identifier: MIT
// The firmware of the reference board: a loop of a millisecond, asleep in between.
#include "daemon/device/board_core/board_core.h"
#include "daemon/device/board_core/port.h"
#include "firmware/boot_loader.h"
#include "firmware/brown_out.h"
#include "firmware/clocks.h"
#include "firmware/flash_id.h"
#include "firmware/pico_port.h"
#include "firmware/pico_wiring.h"
#include "firmware/sleep.h"
#include "firmware/tick.h"
#include "firmware/usb/descriptors.h"
#include "firmware/watchdog.h"

namespace hedgehog::firmware {
namespace {

// Not on the stack, whose depth is that of the calls.
constinit board::BoardCore core{board::reference_limits()};
constinit PicoPort port;

void start_usb_serial() noexcept {
  char serial[kSerialDigits + 1];
  read_serial(serial);
  set_serial(serial);
}

/// Polls and sleeps until `due()`.
template <class Due>
void wait_until(Due due) noexcept {
  const Wakeups wakeups(kTimerInterrupt | kUsbInterrupt | kPinInterrupt);
  for (;;) {
    wakeups.clear();
    port.poll();
    if (due()) return;
    wakeups.sleep();
  }
}

}  // namespace

extern "C" [[noreturn]] void board_main() {
  start_brown_out_detector();
  start_clocks();
  start_peripherals();
  start_pins();
  start_watchdog();
  start_usb_serial();
  port.start();
  Tick tick;
  tick.start();
  constexpr board::Wiring kWiring = pico_wiring();
  for (;;) {
    wait_until([&tick] { return tick.take_measurement(); });
    port.convert();
    wait_until([&tick] { return tick.take(); });
    board::board_millisecond(core, kWiring, port);
    if (core.boot_loader_due()) enter_boot_loader();
    if (core.set_point_age_ms() == 0) tick.follow(port.arrived_us());
    feed_watchdog();
  }
}

}  // namespace hedgehog::firmware
