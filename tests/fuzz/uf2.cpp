// SPDX-License-Identifier: MIT
// Arbitrary bytes as a UF2 file: an accepted image stays inside the flash, and a second reading
// gives the same result.
#include <cstdlib>

#include "clients/ctl/board/uf2_file.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace hedgehog::client;
  const auto image = read_uf2({data, size});
  if (!image) {
    if (image.error().message.empty()) std::abort();
    return 0;
  }
  const bool complete = size == image->blocks * kUf2BlockBytes && image->blocks >= 1;
  const bool inside =
      image->end >= kFlashBegin + image->bytes() && image->end <= kFlashBegin + kFlashBytes;
  if (!complete || !inside || *read_uf2({data, size}) != *image) std::abort();
  return 0;
}
