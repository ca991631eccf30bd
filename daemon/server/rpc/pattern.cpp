// SPDX-License-Identifier: MIT
// pattern.list, .get, .put, .remove
#include <utility>

#include "daemon/server/disk/pattern_library.h"
#include "daemon/server/rpc/handlers.h"

namespace hedgehog::server {
namespace {

protocol::RpcError not_kept(const std::string& what) {
  return protocol::error(protocol::ErrorCode::kInternalError, "internal_error: " + what);
}

/// `response` once it is on disk.
Deferred when_written(DiskWorkPtr work, Response response) {
  return {[work = std::move(work), response = std::move(response)](
              HandlerContext&, bool give_up) -> std::optional<Response> {
    if (!work->done.load(std::memory_order_acquire))
      return give_up
                 ? std::optional(Response(not_kept(
                       "applied, but not yet written to disk; a restart before that undoes it")))
                 : std::nullopt;
    if (!work->problem.empty())
      return Response(not_kept("applied, but writing to disk failed, so a restart may undo it: " +
                               work->problem));
    return response;
  }};
}

}  // namespace

Outcome handle(Call& call, const protocol::PatternList&) {
  return Encoded{call.context.patterns.list()};
}

Outcome handle(Call& call, const protocol::PatternGet& request) {
  const PatternLibrary& patterns = call.context.patterns;
  const PatternLibrary::Entry* entry = patterns.find(request.name);
  if (entry == nullptr)
    return Response(protocol::no_such_pattern("name", request.name, patterns.names()));
  return Response(protocol::PatternResult{
      entry->pattern, PatternLibrary::summary(*entry).duration_ms, entry->shipped});
}

Outcome handle(Call& call, const protocol::PatternPut& request) {
  PatternLibrary& patterns = call.context.patterns;
  if (const auto track = make_keyframe_track(request.pattern.keyframes, call.device_view().array());
      track.has_error())
    return Response(track.error());
  auto work = patterns.put(request.pattern);
  if (work.has_error()) return Response(work.error());
  return when_written(std::move(*work),
                      Response(PatternLibrary::summary(*patterns.find(request.pattern.name))));
}

Outcome handle(Call& call, const protocol::PatternRemove& request) {
  auto work = call.context.patterns.remove(request.name);
  if (work.has_error()) return Response(work.error());
  return when_written(std::move(*work), Response(protocol::Done{}));
}

}  // namespace hedgehog::server
