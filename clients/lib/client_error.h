// SPDX-License-Identifier: MIT
// Errors of a client's calls.
#pragma once

#include <boost/assert/source_location.hpp>
#include <boost/system/error_code.hpp>
#include <boost/system/result.hpp>
#include <chrono>
#include <cstdint>
#include <optional>
#include <string>

#include "protocol/wire/error.h"

namespace hedgehog::client {

enum class Failure : std::uint8_t {
  kNoDaemon,    // no listener, or access denied
  kBadAddress,  // the given address of the daemon is invalid
  kClosed,      // the daemon ended the connection, which cannot be used any more
  kTimeout,     // no response in time; the connection stays open, a late response is ignored
  kProtocol,    // an invalid message was received, or the request is too long
  kRefused,     // the daemon returned an error, see `refusal`
  kNoInput,     // a file of the caller cannot be read
  kBadData,     // the content of that file is invalid
};

/// `message` is one sentence for a person, without the program's name.
struct ClientError {
  Failure failure = Failure::kProtocol;
  std::string message{};
  /// kRefused: the daemon's error.
  std::optional<protocol::RpcError> refusal{};
};

/// Whether a later attempt to connect can succeed after `error` without a change of address or
/// token: not with an invalid address, nor after a refusal, unless the daemon has too many clients
/// (`busy`) or has not checked the token (`unauthorized` with `retry_after_ms`).
bool may_connect_later(const ClientError& error) noexcept;

/// `retry_after_ms` of the daemon's error, at most a minute; 0: not given.
std::chrono::milliseconds retry_after(const ClientError& error) noexcept;

/// "connection refused": the message of a socket's error, for use within a sentence.
std::string reason_of(const boost::system::error_code& error);

/// Makes `Outcome<T>::value()` throw std::runtime_error with the message.
[[noreturn]] void throw_exception_from_error(const ClientError& error,
                                             const boost::source_location& where);

template <class T>
using Outcome = boost::system::result<T, ClientError>;

}  // namespace hedgehog::client
