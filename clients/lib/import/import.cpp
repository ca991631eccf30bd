// SPDX-License-Identifier: MIT
#include "clients/lib/import/import.h"

#include "clients/lib/import/foreign_json.h"
#include "clients/lib/import/reading.h"
#include "clients/lib/import/timeline.h"
#include "clients/lib/import/trailing_commas.h"

namespace hedgehog::client {

namespace {

Outcome<Imported> made_of(Reading reading) {
  Notes& notes = reading.notes;
  if (reading.layers.empty()) {
    return bad_data("there is no haptic event in the file that a ball can play" +
                    (notes.all().empty() ? std::string() : ": " + notes.all().front()));
  }
  Keyframes made = keyframes_of(reading.layers);
  if (made.frames.back().t_ms < 1) {
    return bad_data(made.late ? "all that is in the file begins after 60 s"
                              : "nothing in the file lasts a millisecond");
  }
  if (made.late) notes.add("what begins after 60 s is left out");
  if (made.cut) notes.add("what lasts longer is cut at 60 s");
  if (made.clipped) notes.add("what overlaps adds up to more than 1 and is cut there");
  if (made.simplified)
    notes.add("it has more than 256 points; those that matter least are left out");
  Imported imported;
  imported.pattern.description = std::move(reading.description);
  imported.pattern.waveform = reading.waveform;
  imported.pattern.frequency_hz = reading.frequency_hz;
  imported.pattern.keyframes = std::move(made.frames);
  imported.notes = notes.all();
  return imported;
}

}  // namespace

Outcome<Imported> import_pattern(std::string_view text) {
  if (text.size() > kMaxImportBytes) return bad_data("the file is larger than 4 MiB");
  const auto strict = protocol::parse_json(text, kMaxImportNesting);
  const auto parsed =
      strict ? strict : protocol::parse_json(without_trailing_commas(text), kMaxImportNesting);
  if (!parsed) return bad_data(strict.error().message);
  const bool ahap = parsed->find("Pattern") != nullptr;
  if (!ahap && parsed->find("perceptions") == nullptr) {
    return bad_data(
        "the file is neither AHAP (it has no \"Pattern\") nor hjif (no \"perceptions\")");
  }
  auto reading = ahap ? read_ahap(*parsed) : read_hjif(*parsed);
  if (!reading) return reading.error();
  if (!strict) reading->notes.add("commas behind a last item are left out: JSON has none there");
  return made_of(*std::move(reading));
}

}  // namespace hedgehog::client
