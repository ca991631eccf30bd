// SPDX-License-Identifier: MIT
// The experimenter at the terminal; the participant at its arrow keys or at a separate page.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "clients/common/terminal.h"
#include "clients/study/session/desk.h"
#include "clients/study/session/participant_page.h"

namespace hedgehog::study {

class TerminalDesk : public Desk {
 public:
  /// `blind`: this screen shows only what the participant may see, for a setup with one screen.
  TerminalDesk(std::optional<ParticipantServer> page, bool blind);

  void show(const View& view) override;
  Input wait(std::chrono::milliseconds timeout) override;
  void take_in() override;
  bool unattended() const override { return false; }
  std::optional<std::string> unfinished_note() override;

 private:
  void draw();
  /// A key while a note is being typed. Returns the note if that ended it.
  std::optional<std::string> note_key(char key);

  client::Terminal terminal_;
  std::optional<ParticipantServer> page_;
  bool blind_;
  bool two_intervals_ = false;
  std::vector<std::string> lines_{};
  /// A note being typed, key by key, so that the run and its claim on the ball continue meanwhile.
  std::optional<std::string> note_{};
};

}  // namespace hedgehog::study
