// SPDX-License-Identifier: MIT
// The event history on disk, in the state directory: `trips.jsonl`, `derating.jsonl`,
// `recurring.jsonl`, `events.jsonl` of what else concerns the ball and `effects.jsonl`, and beside
// each the full one before it, `.1`.
#pragma once

#include <string>

#include "daemon/server/disk/disk_thread.h"
#include "daemon/server/history/event_history.h"

namespace hedgehog::server {

/// What is there; empty where nothing is, and, which is logged, where it cannot be read. Start-up
/// only.
HistoryTexts load_history(const std::string& directory);
/// Appends there on the disk thread, which must outlive the writer; whole or not at all. A disk
/// that fails is logged once until it works again.
EventHistory::Writer history_writer(const std::string& directory, DiskThread& disk);

}  // namespace hedgehog::server
