// SPDX-License-Identifier: MIT
#include <cstdio>
#include <optional>
#include <string>

#include "cli/program.h"
#include "clients/common/arguments.h"
#include "clients/common/exit_code.h"
#include "clients/common/interrupts.h"
#include "clients/racer/drive.h"
#include "clients/racer/lap.h"
#include "clients/racer/server/pages.h"

using namespace hedgehog;

int main(int argc, char** argv) {
  cli::Program app{"The racing game that is felt on the ball.", "hedgehog-racer"};
  app.set_version(std::string("hedgehog-racer " HEDGEHOG_VERSION));
  app.require_commands(0, 1);

  std::optional<std::string> address;
  bool no_ball = false;
  bool driver = false;
  std::string listen = "127.0.0.1:7585";
  std::string pages = racer::default_pages_folder();
  app.add_option("--listen", listen, "address:port of the page, on loopback; port 0: a free one")
      .show_default();
  app.add_option("--address", address,
                 "of the daemon: host:port or a socket's path (HEDGEHOG_ADDRESS)");
  app.add_flag("--no-ball", no_ball, "looks for no daemon");
  app.add_flag("--driver", driver, "the built-in driver begins");
  app.add_option("--pages", pages, "the folder with the page's files");
  racer::LapOptions laps;
  const cli::CommandSpec lap = app.add_command("lap", "the built-in driver drives, without a page");
  lap.add_option("--address", address, "host:port or a socket's path (HEDGEHOG_ADDRESS)");
  lap.add_flag("--no-ball", no_ball, "only prints the events, at maximum speed");
  lap.add_option("--seconds", laps.seconds, "of the race").range(0.1, 86'400.0).show_default();
  lap.add_option("--speed", laps.speed, "as many times as fast; the daemon must run so, too")
      .range(0.1, 100.0)
      .show_default();
  lap.add_flag("--json", laps.json, "a JSON object a line");
  if (const auto code = client::parse_arguments(app, argc, argv)) return *code;
  client::watch_interrupts();
  if (!no_ball) {
    const auto addresses = client::daemon_addresses(address);
    if (!addresses) {
      std::fprintf(stderr, "hedgehog-racer: %s\n", addresses.error().message.c_str());
      return kUsage;
    }
    laps.addresses = *addresses;
  }
  if (lap.is_given()) return racer::drive_laps(laps, client::interrupted);
  racer::DriveOptions drive;
  const auto settings = racer::listen_at(listen);
  if (!settings) {
    std::fprintf(stderr, "hedgehog-racer: --listen: %s is no address:port\n", listen.c_str());
    return kUsage;
  }
  drive.page = *settings;
  drive.page.pages = pages;
  drive.addresses = laps.addresses;
  if (driver) drive.mode = racer::Mode::kDriver;
  return racer::drive(drive, client::interrupted);
}
