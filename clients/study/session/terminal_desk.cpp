// SPDX-License-Identifier: MIT
#include "clients/study/session/terminal_desk.h"

#include <utility>

#include "clients/common/text.h"

namespace hedgehog::study {

namespace {

constexpr std::size_t kNoteColumns = 70;

}  // namespace

TerminalDesk::TerminalDesk(std::optional<ParticipantServer> page, bool blind)
    : page_(std::move(page)), blind_(blind) {}

void TerminalDesk::show(const View& view) {
  const Cue cue = cue_of(view);
  two_intervals_ = cue.two_intervals;
  if (page_) page_->show(cue);
  lines_ = blind_ ? blind_lines(view) : experimenter_lines(view);
  draw();
}

void TerminalDesk::draw() {
  std::vector<std::string> lines = lines_;
  if (note_) {
    // Of a long note its end is shown.
    std::size_t from = note_->size() > kNoteColumns ? note_->size() - kNoteColumns : 0;
    while (from < note_->size() && !client::begins_character((*note_)[from])) ++from;
    lines.push_back("  note: " + note_->substr(from) + "_");
  }
  terminal_.draw(lines);
}

std::optional<std::string> TerminalDesk::unfinished_note() { return std::exchange(note_, {}); }

std::optional<std::string> TerminalDesk::note_key(char key) {
  std::optional<std::string> done;
  if (key == '\n' || key == '\r') {
    done = std::exchange(note_, {});
  } else if (key == '\x7f' || key == '\b') {
    while (!note_->empty() && !client::begins_character(note_->back())) note_->pop_back();
    if (!note_->empty()) note_->pop_back();
  } else if (static_cast<unsigned char>(key) >= ' ') {
    *note_ += key;
  }
  draw();
  return done;
}

void TerminalDesk::take_in() {
  if (page_) page_->clear_keys();
  terminal_.take_in();
}

Input TerminalDesk::wait(std::chrono::milliseconds timeout) {
  Input input;
  char key = page_ ? page_->key().value_or('\0') : '\0';
  if (key == '\0') {
    const auto typed = terminal_.key(timeout);
    if (typed && note_ && !typed->arrow) {
      if (const auto note = note_key(typed->what)) {
        input.kind = Input::Kind::kNote;
        input.text = *note;
      }
      return input;
    }
    if (typed) {
      key = typed->what;
      input.at = typed->at;
    }
  }
  switch (key) {
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
      note_.emplace();
      draw();
      break;
    default:
      break;
  }
  return input;
}

}  // namespace hedgehog::study
