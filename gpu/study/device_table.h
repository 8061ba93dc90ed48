// SPDX-License-Identifier: GPL-3.0-or-later
// Performance figures of devices by name, for plans: memory rates from their data sheets, and costs
// of launches and copies from public measurements.
#pragma once

#include <span>
#include <string>

#include "gpu/machine/machine.h"

namespace hepatica::gpu {

struct PlannedDevice {
    std::string name;
    double bytes_per_s;       // of its memory
    double link_bytes_per_s;  // to the host, one way
    std::string source;
};
std::span<const PlannedDevice> planned_devices();

// Throws InputError, naming those available, where there is none of this name.
const PlannedDevice& planned_device(const std::string& name);

// Assumed times of a launch, of a barrier within a block, and of a copy that the host waits for
// [s].
constexpr double launch_s = 3e-6, barrier_s = 5e-8, copy_s = 1e-5;

// Estimated time of this traffic [s]: nothing overlaps, and every byte comes from memory at its
// full rate.
double planned_seconds(const Traffic& traffic, const PlannedDevice& device);

}  // namespace hepatica::gpu
