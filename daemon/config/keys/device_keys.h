// SPDX-License-Identifier: MIT
// Device files: parameters of one ball or one kind of ball. The keys are documented in
// config/devices.d/hedgehog-86.json.
#pragma once

#include <string>
#include <vector>

#include "base/keys/file_error.h"
#include "base/keys/key.h"
#include "base/keys/value.h"
#include "daemon/config/keys/geometry_keys.h"
#include "model/device_model.h"

namespace hedgehog::config {

/// All keys, in the order of the documented file.
const std::vector<keys::Key<model::DeviceModel>>& device_keys();

/// The model in `root`; missing keys have the values of a hedgehog-86. Errors are added to
/// `errors`, with their lines in `file`; the result must then not be used. `possible`: see
/// `check_geometry`.
model::DeviceModel read_device(const keys::Value& root, const std::string& file,
                               const KnownGeometries& possible, keys::FileErrors& errors);

/// `device` as the text of a device file that reads back the same.
std::string print_device(const model::DeviceModel& device);

}  // namespace hedgehog::config
