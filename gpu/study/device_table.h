// SPDX-License-Identifier: GPL-3.0-or-later
// Devices by name, for plans: what their makers say of their memory, and what public measurements
// say of launches and copies.
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

// Throws InputError that names those there are.
const PlannedDevice& planned_device(const std::string& name);

// What every device is taken to need for a launch, for a barrier within a block, and for a copy
// that the host waits for.
constexpr double launch_s = 3e-6, barrier_s = 5e-8, copy_s = 1e-5;

// The sum of all these for some traffic [s]: nothing is taken to overlap, and every byte to come
// from memory at its full rate.
double planned_seconds(const Traffic& traffic, const PlannedDevice& device);

}  // namespace hepatica::gpu
