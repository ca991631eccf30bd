// SPDX-License-Identifier: MIT
#include "clients/ctl/exit_code.h"

#include <cstdio>
#include <nlohmann/json.hpp>

#include "protocol/server_codec.h"

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
    case kArmed:
      return kTryLater;
    case kUnauthorized:
    case kForbidden:
      return kNotAllowed;
    case kNoSuchEffect:
      return kEndedOtherwise;
    case kNoSuchPattern:
      return kNoInput;
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

using nlohmann::ordered_json;

bool errors_are_json = false;

std::string_view name_of(Failure failure) noexcept {
  switch (failure) {
    case Failure::kNoDaemon:
      return "no_daemon";
    case Failure::kBadAddress:
      return "usage";
    case Failure::kClosed:
      return "closed";
    case Failure::kTimeout:
      return "timeout";
    case Failure::kProtocol:
    case Failure::kRefused:
      return "protocol";
    case Failure::kNoInput:
      return "no_input";
    case Failure::kBadData:
      return "bad_data";
  }
  return "protocol";
}

void print_json(const ordered_json& error) {
  ordered_json line;
  line["error"] = error;
  // File names may contain any bytes.
  std::fprintf(stderr, "%s\n",
               line.dump(-1, ' ', false, ordered_json::error_handler_t::replace).c_str());
}

void print_json(std::string_view name, const std::string& message) {
  ordered_json error;
  error["code"] = nullptr;
  error["message"] = message;
  error["data"]["name"] = name;
  print_json(error);
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

void report_errors_as_json() noexcept { errors_are_json = true; }

ExitCode report_error(const ClientError& error) {
  if (errors_are_json) {
    if (error.refusal)
      print_json(ordered_json::parse(protocol::encode_error({}, *error.refusal)).at("error"));
    else
      print_json(name_of(error.failure), error.message);
    return exit_code_of(error);
  }
  std::fprintf(stderr, "hedgehogctl: %s\n", error.message.c_str());
  if (error.failure == Failure::kNoDaemon) {
    std::fputs("  start it: sudo systemctl start hedgehogd     no ball: hedgehogd --simulate\n",
               stderr);
  }
  if (error.refusal && error.refusal->code == protocol::ErrorCode::kForbidden) {
    std::fputs(
        "  as root: sudo hedgehogctl ...     or join the group: sudo adduser $USER hedgehog\n",
        stderr);
  }
  return exit_code_of(error);
}

ExitCode report_usage_error(const std::string& sentence) {
  if (errors_are_json)
    print_json(name_of(Failure::kBadAddress), sentence);
  else
    std::fprintf(stderr, "%s\n", sentence.c_str());
  return kUsage;
}

void print_failure(std::string_view name, const std::string& message) {
  if (errors_are_json)
    print_json(name, message);
  else
    std::fprintf(stderr, "hedgehogctl: %s\n", message.c_str());
}

}  // namespace hedgehog::client
