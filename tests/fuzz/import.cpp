// SPDX-License-Identifier: MIT
// Arbitrary text as a pattern of another format: the daemon accepts every imported pattern.
#include <cstdlib>
#include <string_view>

#include "clients/lib/import/import.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace hedgehog;
  auto imported =
      client::import_pattern(std::string_view(reinterpret_cast<const char*>(data), size));
  if (!imported) return 0;
  imported->pattern.name = "imported/fuzz";
  if (!protocol::decode_pattern(protocol::encode_pattern(imported->pattern))) std::abort();
  return 0;
}
