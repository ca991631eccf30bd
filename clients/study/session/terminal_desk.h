// SPDX-License-Identifier: MIT
// The experimenter at the terminal, the participant at the arrow keys or at a page of their own.
#pragma once

#include <functional>
#include <optional>

#include "clients/study/session/desk.h"
#include "clients/study/session/participant_page.h"
#include "clients/study/session/terminal.h"

namespace hedgehog::study {

class TerminalDesk : public Desk {
 public:
  /// `blind`: this screen shows what the participant may see, for a table with one screen.
  TerminalDesk(std::optional<ParticipantServer> page, bool blind);

  void show(const View& view) override;
  Input wait(std::chrono::milliseconds patience) override;
  bool unattended() const override { return false; }

 private:
  Terminal terminal_;
  std::optional<ParticipantServer> page_;
  bool blind_;
  bool two_intervals_ = false;
};

}  // namespace hedgehog::study
