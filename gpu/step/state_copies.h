// SPDX-License-Identifier: GPL-3.0-or-later
// Copies one vector per node of a body to a machine and back. Source and destination must have the
// same length.
#pragma once

#include <vector>

#include "core/base/vector.h"
#include "gpu/step/growing_array.h"

namespace hepatica::gpu {

using small::Vector3;

inline void copy_in(Machine& machine, const std::vector<Vec3>& from,
                    GrowingArray<Vector3<double>>& to) {
    static_assert(sizeof(Vec3) == sizeof(Vector3<double>));
    machine.upload(to.view().data, from.data(), from.size() * sizeof(Vec3));
}

inline void copy_out(Machine& machine, const GrowingArray<Vector3<double>>& from,
                     std::vector<Vec3>& to) {
    machine.download(to.data(), from.read().data, to.size() * sizeof(Vec3));
}

// See Machine::begin_download.
inline void begin_copy_out(Machine& machine, const GrowingArray<Vector3<double>>& from,
                           std::vector<Vec3>& to) {
    machine.begin_download(to.data(), from.read().data, to.size() * sizeof(Vec3));
}

}  // namespace hepatica::gpu
