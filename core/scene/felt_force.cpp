// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/felt_force.h"

namespace hepatica {

namespace {

constexpr double millinewton_per_un = 1e-3;

}  // namespace

FeltForce::FeltForce(double dt_s) : pulls_(over_s, dt_s), tools_(over_s, dt_s) {}

void FeltForce::see(const Frame& frame) {
    if (frame.statistics.paused) return;
    pull_mn_ = pulls_.take(frame.grab ? millinewton_per_un * frame.grab->force_un : 0.0);
    tool_mn_ = tools_.take(frame.tool ? millinewton_per_un * frame.tool->force_un.norm() : 0.0);
}

void FeltForce::show_in(Frame& frame) const {
    if (frame.grab) frame.grab->felt_un = pull_mn_ / millinewton_per_un;
    if (frame.tool) frame.tool->felt_un = tool_mn_ / millinewton_per_un;
}

}  // namespace hepatica
