// SPDX-License-Identifier: MIT
// hedgehogd --replay F: replays a flight recording through the controller, without device or
// socket.
#pragma once

#include <iosfwd>
#include <string>

namespace hedgehog::daemon {

/// Writes one JSON object per tick to `out`,
///   {"tick","state","reason","sensor_c","model_c","asked_a","current_a","measured_a","events","same"}
/// and at the end {"ticks","different","written_by"}. Returns 0; 1: the result of a tick differs;
/// 65: not a recording; 66: no such file; 69: written by another build.
int replay(const std::string& path, std::ostream& out, std::ostream& errors);

}  // namespace hedgehog::daemon
