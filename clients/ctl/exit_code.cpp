// SPDX-License-Identifier: MIT
#include "clients/ctl/exit_code.h"

#include <cstdio>

namespace hedgehog::client {

namespace {

ExitCode exit_code_of(protocol::ErrorCode code) noexcept {
  using enum protocol::ErrorCode;
  switch (code) {
    case kInvalidParams:
      return kUsage;
    case kNotArmed:
    case kDeviceAbsent:
      return kUnavailable;
    case kBusy:
    case kRefusedThermal:
    case kClaimed:
      return kTryLater;
    case kUnauthorized:
    case kForbidden:
      return kNotAllowed;
    case kNoSuchEffect:
    case kNoSuchPattern:
      return kEndedOtherwise;
    case kInternalError:
      return kInternal;
    case kParseError:
    case kInvalidRequest:
    case kMethodNotFound:
    case kUnsupported:
      return kProtocolError;
  }
  return kProtocolError;
}

}  // namespace

ExitCode exit_code_of(const ClientError& error) noexcept {
  switch (error.failure) {
    case Failure::kNoDaemon:
    case Failure::kClosed:
      return kUnavailable;
    case Failure::kBadAddress:
      return kUsage;
    case Failure::kTimeout:
      return kTryLater;
    case Failure::kProtocol:
      return kProtocolError;
    case Failure::kNoInput:
      return kNoInput;
    case Failure::kBadData:
      return kBadData;
    case Failure::kRefused:
      return error.refusal ? exit_code_of(error.refusal->code) : kProtocolError;
  }
  return kProtocolError;
}

ExitCode complain(const ClientError& error) {
  std::fprintf(stderr, "hedgehogctl: %s\n", error.message.c_str());
  if (error.failure == Failure::kNoDaemon) {
    std::fputs("  start it: sudo systemctl start hedgehogd     no ball: hedgehogd --simulate\n",
               stderr);
  }
  if (error.refusal && error.refusal->code == protocol::ErrorCode::kForbidden) {
    std::fputs("  as root: sudo hedgehogctl …     or join the group: sudo adduser $USER hedgehog\n",
               stderr);
  }
  return exit_code_of(error);
}

}  // namespace hedgehog::client
