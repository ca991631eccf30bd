// SPDX-License-Identifier: MIT
#include "clients/ctl/calibrate/calibrate_verb.h"

#include <unistd.h>

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <optional>
#include <utility>

#include "base/atomic_file.h"
#include "clients/ctl/calibrate/calibration.h"
#include "clients/ctl/calibrate/heat_progress.h"
#include "clients/ctl/calibrate/heating.h"
#include "clients/ctl/calibrate/winding_calibration.h"

namespace hedgehog::client {
namespace {

int cannot_write(const std::string& path) {
  print_error(path + ": cannot be written");
  return kCannotCreate;
}

int write(const Session& session, const CalibrateOptions& options, const Calibration& found,
          const protocol::Description& before) {
  // Written atomically: a truncated device file is worse than the old one.
  constexpr mode_t kForEverybody = 0666;
  if (!base::write_file_atomically(options.out, device_file(found, before), kForEverybody).empty())
    return cannot_write(options.out);
  if (session.json) {
    // A file's name may contain any bytes.
    constexpr auto kReplace = nlohmann::json::error_handler_t::replace;
    std::puts(nlohmann::json{{"written", options.out}}.dump(-1, ' ', false, kReplace).c_str());
    return kDone;
  }
  const std::string name = std::filesystem::path(options.out).stem().string();
  std::printf(
      "wrote %s\n"
      "To use it: copy it into /etc/hedgehog/devices.d, write \"device\": \"%s\"\n"
      "into /etc/hedgehog/hedgehogd.json, restart hedgehogd.\n",
      options.out.c_str(), name.c_str());
  return kDone;
}

std::string contents_of(const std::string& path) {
  std::ifstream file(path);
  return {std::istreambuf_iterator<char>(file), {}};
}

/// Windings, then heating; or heating from where an interrupted run has stopped.
int calibrate_heat(Session& session, const CalibrateOptions& options, const PushedSides& pushed,
                   const protocol::Description& before) {
  const std::string path = options.out + ".progress";
  HeatProgress progress;
  if (access(path.c_str(), F_OK) == 0) {
    auto earlier = read_progress(contents_of(path));
    const auto status = session.connection.call(protocol::DeviceStatus{});
    if (!status) return report_error(status.error());
    const std::string why =
        earlier ? incompatible(*earlier, before, status->temperature_c) : "it is damaged";
    if (!why.empty()) {
      print_error(path + " cannot be resumed: " + why + ". Remove it to start over");
      return kBadData;
    }
    progress = *std::move(earlier);
  } else {
    progress.ball = identity_of(before);
    const int code = calibrate_windings(session, options, pushed, before, progress.windings);
    if (code != kDone) return code;
  }
  HeatProgressFile file(path, progress);
  if (!file.ok()) return cannot_write(path);
  if (const int code = heat_and_cool(session, before, file, progress); code != kDone) return code;
  Calibration found = progress.windings;
  if (const int code = fit_heat(session, progress, before, found); code != kDone) return code;
  const int code = write(session, options, found, before);
  if (code == kDone) file.remove();
  return code;
}

}  // namespace

int run_calibrate(Session& session, const CalibrateOptions& options) {
  const auto pushed = read_pushed(options.pushed);
  if (!pushed) {
    print_error("--pushed is like x=front,y=left,z=up, each winding on an axis of its own");
    return kUsage;
  }
  if (!options.force && access(options.out.c_str(), F_OK) == 0) {
    print_error(options.out + " is there already; --force replaces it");
    return kCannotCreate;
  }
  if (auto hello = session.connection.hello("hedgehogctl"); !hello)
    return report_error(hello.error());
  const auto before = session.connection.call(protocol::DeviceDescribe{});
  if (!before) return report_error(before.error());
  if (options.thermal) return calibrate_heat(session, options, *pushed, *before);
  Calibration found;
  const int code = calibrate_windings(session, options, *pushed, *before, found);
  return code == kDone ? write(session, options, found, *before) : code;
}

}  // namespace hedgehog::client
