// SPDX-License-Identifier: GPL-3.0-or-later
// A stiff wall at z = 0 below a device's handle, handed to the force loop as a simulation would: 60
// times a second, with the tool where the hand has led it.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "core/haptics/force_loop.h"
#include "core/haptics/simulated_device.h"

namespace hepatica::test {

struct WallPress {
    SimulatedHand hand;
    HapticTraits traits{.damping_un_s_per_mm = 5e3};
    ForceLoopOptions options;
    double wall_un_per_mm = 1e9;
    double seconds = 60.0;
    bool follows = true;  // the tool goes into the wall with the handle; otherwise it stays on it
};

struct WallResult {
    double work_nj = 0.0;       // that the loop has done on the hand at the end, and
    double most_work_nj = 0.0;  // the most at any time
    double most_mm = 0.0;       // how far the handle went from z = 0, either way
    double most_force_un = 0.0;
    double last_force_un = 0.0;
    double sum = 0.0;  // of all forces: the same bits or not
};

// A hand that comes down onto the wall, presses, and trembles.
inline HapticPose trembling(double t) {
    const double down = 2.0 - 4.0 * std::min(1.0, t);
    return {.at_mm = Vec3(0.3 * std::sin(2.0 * M_PI * 1.3 * t), 0.0,
                          down + 0.4 * std::sin(2.0 * M_PI * 8.0 * t))};
}

inline LocalModel wall_model(const WallPress& press, const Vec3& tool_mm) {
    LocalModel model;
    model.tool = true;
    model.centre_mm = tool_mm;
    const double depth = -tool_mm.z();
    // As the coupling in series with the wall would press at that place.
    model.contacts = {{.at_mm = tool_mm, .normal = -Vec3::UnitZ(), .force_un = 0.0}};
    if (depth > 0.0) {
        if (press.follows)
            model.contacts[0].force_un =
                depth * coupling_limit(press.traits.damping_un_s_per_mm, press.traits);
        else
            model.centre_mm.z() = 0.0;
    } else {
        model.centre_mm.z() = 0.0;
    }
    model.compliance = Eigen::MatrixXd::Constant(1, 1, 1.0 / press.wall_un_per_mm);
    return model;
}

inline WallResult press(WallPress press) {
    press.hand.path = trembling;
    SimulatedDevice device(press.hand, press.traits);
    press.traits = device.traits();
    TripleBuffer<LocalModel> models;
    Vec3 led = device.at_mm();
    LocalModel first = wall_model(press, led);
    first.centre_mm = led;  // where the tool is taken in hand
    first.contacts.clear();
    first.compliance.resize(0, 0);
    models.back() = first;
    models.publish();
    std::uint64_t posted = 0;
    ForceLoop loop(
        device, models,
        [&](const Command& command) {
            if (const auto* move = std::get_if<MoveTool>(&command)) led = move->target_mm;
            return ++posted;
        },
        press.options);
    WallResult result;
    const int ticks = static_cast<int>(std::lround(press.seconds / press.traits.period_s));
    for (int i = 1; i <= ticks; ++i) {
        const Tick tick = loop.tick();
        result.most_mm = std::max(result.most_mm, std::abs(device.at_mm().z()));
        result.last_force_un = tick.force.force_un.norm();
        result.most_force_un = std::max(result.most_force_un, result.last_force_un);
        result.sum += tick.force.force_un.z();
        if (i % 17 != 0) continue;
        models.back() = wall_model(press, led);
        models.publish();
    }
    result.work_nj = device.work_nj();
    result.most_work_nj = device.most_work_nj();
    return result;
}

}  // namespace hepatica::test
