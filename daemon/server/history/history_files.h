// SPDX-License-Identifier: MIT
// The event history in the state directory: `trips`, `derating`, `recurring`, `events` (others of
// the ball) and `effects`, each `.jsonl`, with the previous full file, `.jsonl.1`.
#pragma once

#include <string>

#include "daemon/server/disk/disk_thread.h"
#include "daemon/server/history/event_history.h"

namespace hedgehog::server {

/// The stored history; empty if missing, or, with a log line, if unreadable. Start-up only.
HistoryTexts load_history(const std::string& directory);
/// Appends to it on the disk thread, which must outlive the writer; completely or not at all. A
/// failing disk is logged once until it works again.
EventHistory::Writer history_writer(const std::string& directory, DiskThread& disk);

}  // namespace hedgehog::server
