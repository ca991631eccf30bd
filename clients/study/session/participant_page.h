// SPDX-License-Identifier: MIT
// The participant's own screen: a second terminal that displays the run over a Unix socket in the
// study's folder.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "clients/common/problem.h"
#include "clients/study/session/screen.h"

namespace hedgehog::study {

/// The run's side of the socket. Works without any connected page.
class ParticipantServer {
 public:
  /// Listens at `path`; a socket left by a killed run is replaced. EX_CANTCREAT if another run
  /// listens there.
  static Result<ParticipantServer> listen(const std::filesystem::path& path);
  ParticipantServer(ParticipantServer&& other) noexcept;
  ParticipantServer& operator=(ParticipantServer&&) = delete;
  ~ParticipantServer();

  void show(const Cue& cue);
  /// '<' or '>' if it was pressed on a page.
  std::optional<char> key();
  /// Discards the keys pressed so far.
  void clear_keys();

 private:
  ParticipantServer() = default;

  std::filesystem::path path_{};
  int listener_ = -1;
  std::vector<int> pages_{};
  std::optional<Cue> shown_{};
};

/// Runs the page until `stop` returns true: waits for a run to listen at `path`, and for the next
/// one after that. EX_NOINPUT if `path` is not valid for a socket.
Result<void> run_participant_page(const std::filesystem::path& path,
                                  const std::function<bool()>& stop);

}  // namespace hedgehog::study
