// SPDX-License-Identifier: MIT
#include "daemon/server/net/http/website.h"

#include <spdlog/spdlog.h>

#include <chrono>
#include <string_view>
#include <utility>

#include "daemon/server/net/http/metrics.h"
#include "daemon/server/net/http/origin_check.h"

namespace hedgehog::server {
namespace {

/// Time without a tick of the control thread after which health checks fail.
constexpr std::chrono::seconds kMaxControlSilence{1};

/// `error` as an HTTP response.
HttpResponse unauthorized(const protocol::RpcError& error) {
  if (error.code == protocol::ErrorCode::kBusy) return http_error(503, error.message);
  HttpResponse answer = http_error(401, error.message);
  answer.challenge = "Bearer realm=\"hedgehogd\"";
  return answer;
}

}  // namespace

Website::Website(Server& server, const std::string& pages, std::vector<std::string> allow_origins)
    : server_(server), pages_(pages), allow_origins_(std::move(allow_origins)) {
  if (!pages_.problem().empty()) spdlog::warn("{}", pages_.problem());
}

std::optional<HttpResponse> Website::refusal(const HttpRequest& request) {
  auto refusal = refused(request, allow_origins_);
  if (!refusal) return std::nullopt;
  ++server_.counters().rejected[refusal->reason];
  const std::string& sentence = *refusal->answer.body;
  spdlog::warn("{}", std::string_view(sentence).substr(0, sentence.size() - 1));
  return std::move(refusal->answer);
}

HttpResponse Website::answer(const HttpRequest& request) {
  if (auto no = refusal(request)) return *std::move(no);
  if (request.method != "GET" && request.method != "HEAD") {
    HttpResponse answer =
        http_error(405, "only GET and HEAD are allowed; the protocol is served at /ws");
    answer.allow = "GET, HEAD";
    return answer;
  }
  const std::string path = request.path();
  const bool live = path == "/metrics" || path == "/healthz" || path.starts_with(kRecordingsPath);
  if (live && !request.tls) return live_response(path);
  if (live) {
    Session session;
    session.transport = "https";
    session.address = request.address;
    if (!request.token) return unauthorized(token_needed(session));
    if (const auto error = server_.check_token(session, *request.token))
      return unauthorized(*error);
    HttpResponse answer = live_response(path);
    answer.authorized = true;
    return answer;
  }
  if (path == "/ws") return http_error(426, "this is for WebSocket: one JSON-RPC message a frame");
  return page(request);
}

std::optional<HttpResponse> Website::log_in(Session& session, const HttpRequest& request) {
  if (!request.token) return std::nullopt;
  const auto error = server_.log_in(session, *request.token);
  return error ? std::optional(unauthorized(*error)) : std::nullopt;
}

HttpResponse Website::live_response(const std::string& path) {
  if (path == "/metrics") {
    return {200, "text/plain; version=0.0.4; charset=utf-8",
            std::make_shared<const std::string>(metrics_text(server_))};
  }
  if (path == "/healthz") return health();
  return recording(path.substr(kRecordingsPath.size()));
}

HttpResponse Website::recording(const std::string& name) const {
  if (!server_.has_recording(name)) return http_error(404, "there is no such recording");
  HttpResponse answer{200, "application/octet-stream"};
  answer.filename = name;
  answer.pending = server_.read_recording(name);
  return answer.pending ? answer : http_error(503, "the disk is slow; retry later");
}

HttpResponse Website::health() const {
  const control::StatusSnapshot& now = server_.device_view().now();
  if (server_.control_silent() > kMaxControlSilence)
    return http_error(503, "the control loop has stalled");
  std::string text = "ok\n" + std::string(control::name(now.state));
  if (now.reason != control::Reason::kNone)
    text += " (" + std::string(control::name(now.reason)) + ")";
  return http_error(200, text);
}

HttpResponse Website::page(const HttpRequest& request) const {
  const base::WebFile* page = pages_.find(request.path());
  if (page == nullptr && request.path() == "/") {
    return http_error(404, "hedgehogd runs, but the dashboard's pages are missing: " +
                               pages_.problem() + ". The rest works: /ws, /metrics, /healthz");
  }
  if (page == nullptr) return http_error(404, "there is no such page");
  base::WebFileResponse file =
      base::web_file_response(*page, request.accept_encoding, request.if_none_match);
  HttpResponse answer{file.body ? 200 : 304, std::string(page->type)};
  if (file.body) answer.body = std::move(file.body);
  answer.etag = std::move(file.etag);
  answer.cache_control = file.cache_control;
  answer.encoding = file.encoding;
  answer.vary = file.vary;
  return answer;
}

}  // namespace hedgehog::server
