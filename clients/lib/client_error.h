// SPDX-License-Identifier: MIT
// Why a client did not get its answer.
#pragma once

#include <boost/assert/source_location.hpp>
#include <boost/system/result.hpp>
#include <cstdint>
#include <optional>
#include <string>

#include "protocol/wire/error.h"

namespace hedgehog::client {

enum class Failure : std::uint8_t {
  kNoDaemon,    // nobody listens, or not for us
  kBadAddress,  // what was given as the daemon's address is none
  kClosed,      // the daemon ended the connection; it is of no further use
  kTimeout,     // no answer in time; the connection lives, a late answer is ignored
  kProtocol,    // what came was not understood, or what shall be sent is too long
  kRefused,     // the daemon said no: see `refusal`
  kNoInput,     // a file of the caller cannot be read
  kBadData,     // what is in that file is not what it should be
};

/// `message` is one sentence for a person, without the program's name.
struct ClientError {
  Failure failure = Failure::kProtocol;
  std::string message{};
  /// kRefused: what the daemon said.
  std::optional<protocol::RpcError> refusal{};
};

/// Makes `Outcome<T>::value()` throw std::runtime_error with the message.
[[noreturn]] void throw_exception_from_error(const ClientError& error,
                                             const boost::source_location& where);

template <class T>
using Outcome = boost::system::result<T, ClientError>;

}  // namespace hedgehog::client
