// SPDX-License-Identifier: MIT
#include "clients/study/session/terminal_desk.h"

#include <utility>

namespace hedgehog::study {

TerminalDesk::TerminalDesk(std::optional<ParticipantServer> page, bool blind)
    : page_(std::move(page)), blind_(blind) {}

void TerminalDesk::show(const View& view) {
  const Cue cue = cue_of(view);
  two_intervals_ = cue.two_intervals;
  if (page_) {
    page_->show(cue);
  }
  terminal_.draw(blind_ ? participant_lines(cue) : experimenter_lines(view));
}

Input TerminalDesk::wait(std::chrono::milliseconds patience) {
  Input input;
  std::optional<char> key = page_ ? page_->key() : std::nullopt;
  if (!key) {
    key = terminal_.key(patience);
  }
  switch (key.value_or('\0')) {
    case '<':
      input.kind = Input::Kind::kAnswer;
      input.answer = two_intervals_ ? Answer::kFirst : Answer::kNo;
      break;
    case '>':
      input.kind = Input::Kind::kAnswer;
      input.answer = two_intervals_ ? Answer::kSecond : Answer::kYes;
      break;
    case 'p':
      input.kind = Input::Kind::kPause;
      break;
    case 'c':
      input.kind = Input::Kind::kContinue;
      break;
    case 'v':
      input.kind = Input::Kind::kVoid;
      break;
    case 'q':
      input.kind = Input::Kind::kStop;
      break;
    case 'n':
      input.kind = Input::Kind::kNote;
      input.text = terminal_.line("note: ");
      break;
    default:
      break;
  }
  return input;
}

}  // namespace hedgehog::study
