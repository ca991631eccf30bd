// SPDX-License-Identifier: MIT
// Helpers of the protocol's tests.
#pragma once

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <string_view>

#include "protocol/server_codec.h"

namespace hedgehog::protocol {

/// A request of `method` with these params, as a line with id 1.
inline std::string line_of(std::string_view method, std::string_view params) {
  return R"({"jsonrpc":"2.0","id":1,"method":")" + std::string(method) + R"(","params":)" +
         std::string(params) + "}";
}

/// The only item of a line.
inline Item only(std::string_view line) {
  Incoming incoming = decode_line(line);
  EXPECT_EQ(incoming.items.size(), 1u) << line;
  EXPECT_FALSE(incoming.batch) << line;
  return incoming.items.at(0);
}

/// The request decoded from valid params.
template <class T>
T accepted(std::string_view method, std::string_view params) {
  const Item item = only(line_of(method, params));
  if (!item.request) {
    ADD_FAILURE() << method << params << ": " << item.request.error().message;
    return {};
  }
  return std::get<T>(*item.request);
}

/// The error for invalid params.
inline RpcError refused(std::string_view method, std::string_view params) {
  const Item item = only(line_of(method, params));
  if (item.request) {
    ADD_FAILURE() << method << params << " was accepted";
    return {};
  }
  return item.request.error();
}

/// The error for an invalid line, whose response has the id null.
inline RpcError refused_line(std::string_view line) {
  const Item item = only(line);
  if (item.request) {
    ADD_FAILURE() << line << " was accepted";
    return {};
  }
  EXPECT_EQ(item.id, Id{}) << line;
  return item.request.error();
}

}  // namespace hedgehog::protocol
