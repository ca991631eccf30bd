// SPDX-License-Identifier: MIT
#include "base/keys/file_error.h"

#include "base/keys/value.h"

namespace hedgehog::keys {

std::string to_string(const FileError& error) {
  std::string text = error.file;
  if (error.line > 0) text += ":" + std::to_string(error.line);
  text += ": ";
  if (!error.key.empty()) text += printable(error.key) + ": ";
  return text + error.reason;
}

std::string to_string(const FileErrors& errors) {
  std::string text;
  for (const FileError& error : errors) text += to_string(error) + "\n";
  return text;
}

}  // namespace hedgehog::keys
