// SPDX-License-Identifier: MIT
#include "daemon/server/net/line/line_connection.h"

#include <spdlog/spdlog.h>

namespace hedgehog::server {

bool LineConnection::feed(std::string_view bytes) {
  reader_.feed(bytes);
  if (known_ || !reader_.first_byte()) return true;
  known_ = true;
  // Web pages can reach loopback, and HTTP requests begin with a letter.
  if (*reader_.first_byte() == '{' || *reader_.first_byte() == '[') return true;
  spdlog::warn("connection {} does not speak JSON-RPC; closed", id());
  ++counters().rejected["not_json"];
  return false;
}

bool LineConnection::take_lines() {
  while (const auto line = reader_.next()) {
    if (line->too_long)
      too_long();
    else
      take(line->text);
    if (must_pause()) return true;
  }
  return false;
}

}  // namespace hedgehog::server
