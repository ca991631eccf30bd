// SPDX-License-Identifier: MIT
// Patterns in files: as the daemon keeps them, and as other formats have them.
#pragma once

#include <string>
#include <vector>

#include "clients/lib/client_error.h"
#include "clients/lib/import/import.h"
#include "protocol/values/pattern.h"

namespace hedgehog::client {

/// What is meant by it on a command line: a file rather than the name of a pattern. It ends in
/// ".json", ".ahap" or ".hjif" (those two also in capitals); and "acme/x.json", which may be a
/// vendor's pattern too, only where there is that file.
bool is_pattern_file(const std::string& text);
/// `text`, which ends as files do, is no pattern's name, or there is such a file.
bool names_a_file(const std::string& text);

/// The whole regular file; kNoInput when it is none, cannot be read, or is larger than 4 MiB.
Outcome<std::string> read_text(const std::string& path);
/// kBadData: "<path>: <what is wrong>".
Outcome<protocol::Pattern> read_pattern(const std::string& path);
/// An AHAP or HJIF file, named imported/<the file's name>; errors as read_pattern's.
Outcome<Imported> read_foreign_pattern(const std::string& path);
/// Either of them, by how the file's name ends; only one of other formats has notes.
Outcome<Imported> read_any_pattern(const std::string& path);
/// "hedgehogctl: <path>: <note>", a line each on stderr.
void print_notes(const std::string& path, const std::vector<std::string>& notes);
/// As such files are written: a key frame a line, as the shipped ones; without the last LF.
std::string pattern_text(const protocol::Pattern& pattern);

}  // namespace hedgehog::client
