// SPDX-License-Identifier: MIT
// hedgehog-usbip: the simulated board and sensors as USB devices.
#include <sysexits.h>

#include <csignal>
#include <cstdio>
#include <exception>
#include <iostream>

#include "cli/program.h"
#include "emulator/device_text.h"
#include "emulator/server.h"

namespace {

using namespace hedgehog;

volatile std::sig_atomic_t stop = 0;

void request_stop(int /*signal*/) { stop = 1; }

void catch_signals() {
  struct sigaction action {};
  action.sa_handler = request_stop;
  for (const int signal : {SIGTERM, SIGINT}) sigaction(signal, &action, nullptr);
  (void)std::signal(SIGPIPE, SIG_IGN);
}

struct Options {
  std::vector<std::string> devices;
  bool vhci = false;
  std::string listen = "127.0.0.1:3240";
  std::string control;
};

int run(const Options& options) {
  emulator::Hub hub(options.vhci ? std::optional<emulator::Vhci>(emulator::Vhci()) : std::nullopt);
  for (const std::string& text : options.devices) {
    auto made = emulator::make_device(text);
    if (!made.device) {
      std::cerr << "hedgehog-usbip: " << text << ": " << made.failure << "\n";
      return EX_USAGE;
    }
    if (!hub.add(made.name, std::move(made.device))) {
      std::cerr << "hedgehog-usbip: " << text << ": there is a device " << made.name
                << " already; `name=` gives it another name\n";
      return EX_USAGE;
    }
    const std::string answer = made.plugged ? hub.execute("plug " + made.name) : "ok";
    if (answer != "ok") {
      std::cerr << "hedgehog-usbip: " << made.name << ": " << answer << "\n";
      return EX_UNAVAILABLE;
    }
  }
  device::FileDescriptor imports;
  device::FileDescriptor commands;
  try {
    if (!options.vhci) imports = emulator::listen_tcp(options.listen);
    if (!options.control.empty()) commands = emulator::listen_unix(options.control);
  } catch (const std::exception& e) {
    std::cerr << "hedgehog-usbip: " << e.what() << "\n";
    return EX_CANTCREAT;
  }
  if (imports.get() >= 0)
    std::cout << "listening on port " << emulator::port_of(imports.get()) << std::endl;
  else
    std::cout << "ready" << std::endl;
  emulator::Server(hub, std::move(imports), std::move(commands), true).run(stop);
  return EX_OK;
}

}  // namespace

int main(int argc, char** argv) {
  Options options;
  cli::Program app(
      "hedgehog-usbip serves a simulated driver board and orientation sensors as USB devices,\n"
      "over USB/IP or straight into this machine's vhci-hcd. Commands come on stdin, a line each.",
      "hedgehog-usbip");
  app.add_option("device", options.devices,
                 "KIND[,name=N][,serial=S][,start=C][,ambient=C][,trace=F][,unplugged]; kinds:\n" +
                     emulator::device_kinds())
      .required()
      .type_name("DEVICE");
  const auto vhci = app.add_flag("--vhci", options.vhci,
                                 "plug them into this machine (root, module vhci-hcd), no network");
  app.add_option("--listen", options.listen, "where hosts import them; port 0 takes a free one")
      .type_name("A:P")
      .show_default()
      .excludes(vhci);
  app.add_option("--control", options.control, "commands from this Unix socket as well")
      .type_name("F");
  app.set_version("hedgehog-usbip " HEDGEHOG_VERSION);
  if (const auto code = app.parse_and_print(argc, argv)) return *code;
  catch_signals();
  try {
    return run(options);
  } catch (const std::exception& e) {
    std::cerr << "hedgehog-usbip: " << e.what() << "\n";
    return EX_UNAVAILABLE;
  }
}
