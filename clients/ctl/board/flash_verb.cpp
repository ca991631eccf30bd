// SPDX-License-Identifier: MIT
#include "clients/ctl/board/flash_verb.h"

#include <fmt/format.h>
#include <poll.h>

#include <chrono>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <utility>

#include "base/regular_file.h"
#include "clients/common/interrupts.h"
#include "clients/ctl/board/image_load.h"
#include "clients/ctl/board/uf2_file.h"
#include "clients/ctl/terminal/words.h"

namespace hedgehog::client {

namespace {

using nlohmann::ordered_json;

/// Larger files are rejected unread: the flash has 2 MiB.
constexpr std::size_t kMaxFileBytes = 64 * 1024 * 1024;
constexpr int kPollMs = 200;

int fail(const Problem& problem) {
  print_failure("failed", problem.message);
  return problem.exit_code;
}

struct Image {
  std::string content;
  Uf2Image uf2;
};

Outcome<Image> read_image(const std::string& path) {
  base::FileText file = base::read_regular_file(path, kMaxFileBytes);
  if (!file.good()) return ClientError{Failure::kNoInput, path + ": " + file.problem, {}};
  const auto uf2 =
      read_uf2({reinterpret_cast<const std::uint8_t*>(file.text.data()), file.text.size()});
  if (!uf2) return ClientError{Failure::kBadData, path + ": " + uf2.error().message, {}};
  return Image{std::move(file.text), *uf2};
}

class Flash {
 public:
  Flash(const FlashOptions& options, bool json)
      : options_(options), json_(json), timeout_(static_cast<int>(1000.0 * options.wait_s)) {}

  Outcome<void> read() {
    auto image = read_image(options_.file);
    if (!image) return image.error();
    image_ = *std::move(image);
    report_["file"] = options_.file;
    report_["blocks"] = image_.uf2.blocks;
    report_["bytes"] = image_.uf2.bytes();
    print("file", fmt::format("{}: {} blocks, {} bytes below 0x{:08X}", options_.file,
                              image_.uf2.blocks, grouped(image_.uf2.bytes()), image_.uf2.end));
    return {};
  }

  int run(Connection& connection) {
    const auto ball = look(connection);
    if (!ball) return report_error(ball.error());
    if (ball->description.simulated && !json_)
      std::fputs("hedgehogctl: the ball is simulated: the file goes to another board\n", stderr);
    const bool present = ball->status.state != "absent";
    if (present) {
      if (const int code = send_into_boot_loader(connection); code != kDone) return code;
    } else {
      print("board", "does not answer; looking for one in its boot loader");
    }
    // A board that this program has not sent to its boot loader will not appear there later.
    const bool sent = present || ball->status.reason == "boot_loader";
    if (const int code = load(sent ? timeout_ : Milliseconds(0)); code != kDone) return code;
    return wait_for_board(connection, ball->description.board);
  }

  void print_report() const {
    if (json_)
      std::puts(report_.dump(-1, ' ', false, ordered_json::error_handler_t::replace).c_str());
  }

 private:
  void print(const char* name, const std::string& what) const {
    if (json_) return;
    std::printf("  %s%s\n", left(name, 10).c_str(), what.c_str());
    // The next line may take seconds.
    std::fflush(stdout);
  }

  int send_into_boot_loader(Connection& connection) {
    if (options_.volume.empty()) {
      if (const auto others = mounted_boot_volumes(); !others.empty()) {
        return fail({kUnavailable, "a board that is not the ball's is in its boot loader, " +
                                       others[0] + ": unplug it, or name the ball's by --volume"});
      }
    }
    const auto gone = connection.call(protocol::DeviceEnterBootLoader{});
    if (!gone) return report_error(gone.error());
    print("board", "is in its boot loader");
    return kDone;
  }

  int load(Milliseconds timeout) {
    ImageLoad load;
    load.file = options_.file;
    load.content = image_.content;
    load.volume = options_.volume;
    load.timeout = timeout;
    const auto loaded = load_image(load);
    if (!loaded) return fail(loaded.error());
    const bool by_volume = !loaded->volume.empty();
    report_["written_by"] = by_volume ? "volume" : "picotool";
    report_["volume"] = by_volume ? ordered_json(loaded->volume) : ordered_json();
    print("written", by_volume ? "to " + loaded->volume : "by picotool");
    return kDone;
  }

  int wait_for_board(Connection& connection, const protocol::BoardDescription& before) {
    const auto deadline = Clock::now() + timeout_;
    for (;;) {
      const auto now = connection.call(protocol::DeviceDescribe{});
      if (!now) return report_error(now.error());
      if (now->board.present) return compare(connection, before, now->board);
      if (interrupted()) return fail({kInterrupted, "interrupted; the board has its new firmware"});
      if (Clock::now() >= deadline) break;
      ::poll(nullptr, 0, kPollMs);
    }
    const auto status = connection.call(protocol::DeviceStatus{});
    if (!status) return report_error(status.error());
    return fail({kUnavailable, "the daemon does not see the board again. " +
                                   status->remedy.value_or("hedgehogctl devices")});
  }

  int compare(Connection& connection, const protocol::BoardDescription& before,
              const protocol::BoardDescription& after) {
    const auto status = connection.call(protocol::DeviceStatus{});
    if (!status) return report_error(status.error());
    const auto both = [this](const char* name, const std::optional<std::string>& from,
                             const std::optional<std::string>& to) {
      report_[name]["before"] = from ? ordered_json(*from) : ordered_json();
      report_[name]["after"] = to ? ordered_json(*to) : ordered_json();
      print(name, from.value_or("not known") + " → " + to.value_or("not known"));
    };
    both("firmware", before.firmware, after.firmware);
    both("protocol", before.protocol, after.protocol);
    report_["state"] = status->state;
    report_["remedy"] = status->remedy ? ordered_json(*status->remedy) : ordered_json();
    print(status->state.c_str(), status->remedy.value_or(""));
    return kDone;
  }

  const FlashOptions& options_;
  bool json_;
  Milliseconds timeout_;
  Image image_;
  ordered_json report_;
};

}  // namespace

int run_board_flash(const CommonOptions& common, const FlashOptions& options) {
  Flash flash(options, common.json);
  if (const auto good = flash.read(); !good) return report_error(good.error());
  if (!options.check) {
    auto session = open_session(common);
    if (!session) return report_error(session.error());
    if (const int code = flash.run(session->connection); code != kDone) return code;
  }
  flash.print_report();
  return kDone;
}

}  // namespace hedgehog::client
