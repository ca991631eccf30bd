// SPDX-License-Identifier: MIT
#include <csignal>
#include <cstdio>
#include <string>

#include "cli/program.h"
#include "clients/common/arguments.h"
#include "clients/common/exit_code.h"
#include "clients/common/interrupts.h"
#include "clients/gamepad/bridge.h"
#include "clients/gamepad/uinput_device.h"
#include "protocol/wire/direction.h"

namespace {

using namespace hedgehog;
using namespace hedgehog::gamepad;

volatile std::sig_atomic_t recentre_requested = 0;

void note_recentre(int) { recentre_requested = 1; }

void print(const std::string& message) {
  std::fprintf(stderr, "hedgehog-gamepad: %s\n", message.c_str());
}

int run(const std::string& path, const BridgeOptions& options) {
  const auto device = UinputDevice::create(path);
  if (!device) {
    print(device.error().message);
    return device.error().exit_code;
  }
  Bridge bridge(**device, options, print);
  const auto done = bridge.run([&] {
    if (recentre_requested != 0) {
      recentre_requested = 0;
      bridge.recentre();
    }
    return client::interrupted();
  });
  if (client::interrupted()) return kInterrupted;
  if (done) return 0;
  print(done.error().message);
  return done.error().exit_code;
}

}  // namespace

int main(int argc, char** argv) {
  cli::Program app{
      "Makes the ball a gamepad with standard force feedback. SIGUSR1: takes the present tilt as "
      "the centre of the stick.",
      "hedgehog-gamepad"};
  app.set_version(std::string("hedgehog-gamepad " HEDGEHOG_VERSION));
  BridgeOptions options;
  std::optional<std::string> address;
  std::string device = kUinputPath;
  std::string rumble = "down";
  std::string sdl_rumble = "yes";
  app.add_option("--address", address, "host:port or a socket's path (HEDGEHOG_ADDRESS)");
  app.add_option("--device", device, "uinput's device file").show_default();
  app.add_option("--rumble-direction", rumble, "where an effect without a direction pushes")
      .one_of({"up", "down", "left", "right", "front", "back"})
      .show_default();
  app.add_option("--sdl-rumble", sdl_rumble,
                 "yes: a wave from 0x4000 is SDL's rumble and has no direction; no: it is on the "
                 "right")
      .one_of({"yes", "no"})
      .show_default();
  app.add_option("--full-level", options.translation.full_level,
                 "of a game's strongest force, of the ball's")
      .range(0.2, 1.0)
      .show_default();
  app.add_option("--full-deg", options.tilt.full_deg, "the tilt that is the end of the stick")
      .range(10.0, 90.0)
      .show_default();
  app.add_option("--dead-zone-deg", options.tilt.dead_zone_deg, "smaller tilts are the centre")
      .range(0.0, 9.0)
      .show_default();
  app.add_option("--curve", options.tilt.curve, "1: even, more: finer near the centre")
      .range(0.5, 4.0)
      .show_default();
  app.add_flag("--once", options.once, "ends with the connection instead of reconnecting");
  app.add_flag("--trace", options.trace, "prints what games upload, play, erase and set as gain");
  if (const auto code = client::parse_arguments(app, argc, argv)) return *code;
  options.translation.sdl_rumble = sdl_rumble == "yes";
  for (const auto word : {protocol::Word::kUp, protocol::Word::kDown, protocol::Word::kLeft,
                          protocol::Word::kRight, protocol::Word::kFront, protocol::Word::kBack})
    if (protocol::name(word) == rumble) options.translation.rumble_direction = word;
  const auto addresses = client::daemon_addresses(address);
  if (!addresses) {
    print(addresses.error().message);
    return kUsage;
  }
  options.addresses = *addresses;
  client::watch_interrupts();
  std::signal(SIGUSR1, note_recentre);
  return run(device, options);
}
