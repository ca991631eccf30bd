// SPDX-License-Identifier: MIT
// Pattern files: in the daemon's format and in other formats.
#pragma once

#include <string>
#include <vector>

#include "clients/lib/client_error.h"
#include "clients/lib/import/import.h"
#include "protocol/values/pattern.h"

namespace hedgehog::client {

/// True if a command-line argument is a file rather than the name of a pattern: it ends in ".json",
/// ".ahap" or ".hjif" (the latter two also in capitals); "acme/x.json", which may also be a
/// vendor's pattern, only if that file exists.
bool is_pattern_file(const std::string& text);
/// True if `text`, which has a file extension, is not a pattern's name, or that file exists.
bool names_a_file(const std::string& text);

/// The content of a regular file; kNoInput if it is not one, cannot be read, or is larger than 4
/// MiB.
Outcome<std::string> read_text(const std::string& path);
/// kBadData: "<path>: <what is wrong>".
Outcome<protocol::Pattern> read_pattern(const std::string& path);
/// An AHAP or HJIF file, named imported/<the file's name>; errors as read_pattern's.
Outcome<Imported> read_foreign_pattern(const std::string& path);
/// A file of any format, by its extension; only other formats have notes.
Outcome<Imported> read_any_pattern(const std::string& path);
/// "hedgehogctl: <path>: <note>", a line each on stderr.
void print_notes(const std::string& path, const std::vector<std::string>& notes);
/// The content of a pattern file: a line per key frame, as in the shipped ones; without the last
/// LF.
std::string pattern_text(const protocol::Pattern& pattern);

}  // namespace hedgehog::client
