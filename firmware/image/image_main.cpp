// SPDX-License-Identifier: MIT
// firmware_image boot2|uf2 IN OUT: the second stage with its check sum; a flash image as UF2.
// Exit: 0, 64 usage, 65 a second stage too long, 66 IN cannot be read, 73 OUT cannot be written.
#include <sysexits.h>

#include <cstdio>
#include <fstream>
#include <iterator>
#include <string_view>
#include <vector>

#include "firmware/image/uf2.h"

namespace {

constexpr std::uint32_t kFlash = 0x10000000;

int fail(int code, const char* what) {
  std::fprintf(stderr, "firmware_image: %s\n", what);
  return code;
}

}  // namespace

int main(int argc, char** argv) {
  using namespace hedgehog::firmware;
  const std::string_view kind = argc == 4 ? argv[1] : "";
  if (kind != "boot2" && kind != "uf2") return fail(EX_USAGE, "firmware_image boot2|uf2 IN OUT");
  std::ifstream in(argv[2], std::ios::binary);
  if (!in) return fail(EX_NOINPUT, argv[2]);
  const std::vector<std::uint8_t> read{std::istreambuf_iterator<char>(in), {}};
  std::vector<std::uint8_t> made;
  if (kind == "uf2") {
    made = uf2(read, kFlash);
  } else {
    // What the linker has filled up is filled up again.
    const std::size_t code = std::min(read.size(), kBoot2Size - 4);
    for (std::size_t i = code; i < read.size(); ++i)
      if (read[i] != 0) return fail(EX_DATAERR, "the second stage has more than 252 bytes");
    made = *boot2_with_crc(std::span(read).first(code));
  }
  std::ofstream out(argv[3], std::ios::binary);
  out.write(reinterpret_cast<const char*>(made.data()), static_cast<std::streamsize>(made.size()));
  return out.flush() ? EX_OK : fail(EX_CANTCREAT, argv[3]);
}
