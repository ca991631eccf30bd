// SPDX-License-Identifier: MIT
// Arbitrary bytes as a line from a client and as a line from a server. A decoded line must be
// unchanged by encoding and decoding; a rejected one must have an error that can be sent.
#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>

#include "protocol/client_codec.h"
#include "protocol/server_codec.h"

namespace {

using namespace hedgehog::protocol;

void require(bool condition) {
  if (!condition) std::abort();
}

void check(const Item& item) {
  if (!item.request) {
    const std::string line = encode_error(item.id.value_or(Id{}), item.request.error());
    require(line.find('\n') == std::string::npos);
    const auto messages = decode_messages(line);
    require(messages.has_value() && messages->size() == 1);
    return;
  }
  const std::string line = encode_request(item.id, *item.request);
  const Incoming again = decode_line(line);
  require(again.items.size() == 1 && again.items.front().request.has_value());
  require(again.items.front().id == item.id);
  // Quaternions are normalised when decoded, so the second decoding is the stable one.
  const std::string stable = encode_request(item.id, *again.items.front().request);
  require(stable == encode_request(item.id, *decode_line(stable).items.front().request));
}

/// A request alone is decoded without a tree, one in a batch with it. The batch is one more level
/// of nesting.
void check_alone_and_in_a_batch(std::string_view line) {
  const Incoming alone = decode_line(line);
  if (alone.batch || !alone.items.front().method) return;
  const Incoming batch = decode_line('[' + std::string(line) + ']');
  const Item& one = alone.items.front();
  const Item& other = batch.items.front();
  if (!other.request && other.request.error().code == ErrorCode::kParseError) {
    const auto opened =
        std::count(line.begin(), line.end(), '{') + std::count(line.begin(), line.end(), '[');
    require(static_cast<std::size_t>(opened) >= kMaxNesting);
    return;
  }
  require(one.id == other.id && one.method == other.method);
  require(one.request.has_value() == other.request.has_value());
  if (one.request)
    require(encode_request(one.id, *one.request) == encode_request(one.id, *other.request));
  else
    require(one.request.error().message == other.request.error().message);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view line(reinterpret_cast<const char*>(data), size);
  for (const Item& item : decode_line(line).items) check(item);
  check_alone_and_in_a_batch(line);
  (void)decode_messages(line);
  (void)decode_result<Status>(line);
  (void)decode_result<Description>(line);
  return 0;
}
