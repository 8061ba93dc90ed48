// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/haptics/force_loop.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace hepatica {
namespace {

constexpr int most_silent = 100;  // ticks
constexpr double least_way_mm = 1e-6, least_turn_rad = 1e-6;

Vec3 at_most(const Vec3& value, double limit) {
    const double size = value.norm();
    return size > limit ? Vec3(limit / size * value) : value;
}

// Work that is no number would end the control of passivity for good.
bool finite(const HapticSample& sample) {
    const HapticPose& pose = sample.pose;
    return pose.at_mm.allFinite() && pose.turned.coeffs().allFinite() &&
           std::isfinite(sample.work_nj);
}

}  // namespace

ForceLoop::ForceLoop(HapticDevice& device, TripleBuffer<LocalModel>& models, Post post,
                     const ForceLoopOptions& options)
    : device_(device),
      models_(models),
      post_(std::move(post)),
      options_(options),
      local_(options.coupling_un_per_mm.value_or(
                 coupling_limit(device.traits().damping_un_s_per_mm, device.traits())),
             options.turn_coupling_un_mm.value_or(
                 coupling_limit(device.traits().turn_damping_un_mm_s, device.traits()))),
      passivity_(device.traits()),
      ticks_in_step_(
          std::max(1, static_cast<int>(std::lround(options.step_s / device.traits().period_s)))) {}

Vec3 ForceLoop::place_of(const HapticPose& handle) const {
    return grip_->tool_mm + (handle.at_mm - grip_->handle.at_mm);
}

// Measured from the tool's pose in the model: what the commands so far will still turn it by, and
// what the handle has turned since the last of them.
Vec6 ForceLoop::way_to(const HapticPose& handle) const {
    Vec6 way = way_between(led_, handle);
    way.head<3>() = place_of(handle) - centre_mm_;
    way.tail<3>() += left_rad_;
    return way;
}

// The force continues from that of the previous model; the difference fades over a step. Where the
// tool has no contact, there is no difference. Another tool begins with no force.
void ForceLoop::take(const LocalModel& model, const HapticPose& handle) {
    Vec6 before = Vec6::Zero();
    const bool another = model.tool_number != tool_number_;
    tool_number_ = model.tool_number;
    if (grip_ && !another) before = faded().both() + local_.at(way_to(handle)).both();
    if (!model.tool) {
        grip_.reset();
    } else if (!grip_ || another) {
        grip_ = Grip{handle, model.centre_mm};
        led_ = handle;
    }
    local_.take(model);
    centre_mm_ = model.centre_mm;
    std::erase_if(posted_turns_,
                  [&](const PostedTurn& turn) { return turn.command <= model.commands_taken; });
    left_rad_ = model.left_rad;
    for (const PostedTurn& turn : posted_turns_) left_rad_ += turn.by_rad;
    fading_.setZero();
    if (grip_ && local_.contacts() > 0) fading_ = before - local_.at(way_to(handle)).both();
    if (!fading_.allFinite()) fading_.setZero();
    since_model_ = 0;
}

// A value that is not finite must not reach a motor.
HapticForce ForceLoop::within_limits(const Vec6& both) const {
    if (!both.allFinite()) return {};
    return {at_most(both.head<3>(), device_.traits().force_limit_un),
            at_most(both.tail<3>(), device_.traits().torque_limit_un_mm)};
}

HapticForce ForceLoop::faded() const {
    const Vec6 left =
        std::max(0.0, 1.0 - static_cast<double>(since_model_) / ticks_in_step_) * fading_;
    return {left.head<3>(), left.tail<3>()};
}

void ForceLoop::lead(const HapticPose& handle) {
    since_lead_ = 0;
    const Vec6 way = way_between(led_, handle);
    if (way.head<3>().norm() > least_way_mm) {
        post_(MoveTool{place_of(handle)});
        led_.at_mm = handle.at_mm;
    }
    if (way.tail<3>().norm() > least_turn_rad) {
        const Vec3 by_rad = way.tail<3>();
        posted_turns_.push_back({post_(TurnTool{by_rad}), by_rad});
        left_rad_ += by_rad;
        led_.turned = handle.turned;
    }
}

Tick ForceLoop::tick() {
    Tick done;
    if (lost_) return {.lost = true};
    const std::optional<HapticSample> sample = device_.read();
    silent_ = sample && sample->number != number_ ? 0 : silent_ + 1;
    if (!sample || silent_ > most_silent || !finite(*sample)) {
        device_.write({});
        lost_ = true;
        return {.lost = true};
    }
    number_ = sample->number;
    const bool stepped = models_.update();
    if (stepped) take(models_.front(), sample->pose);
    done.tool = grip_.has_value();
    done.contacts = local_.contacts();
    if (grip_) {
        HapticForce wanted;
        if (done.contacts > 0)
            wanted = within_limits(local_.at(way_to(sample->pose)).both() + faded().both());
        done.force = options_.controlled ? within_limits(passivity_.limited(wanted, *sample).both())
                                         : wanted;
        done.damping_un_s_per_mm = options_.controlled ? passivity_.damping_un_s_per_mm() : 0.0;
        ++since_model_;
        if (++since_lead_ >= ticks_in_step_ || stepped) lead(sample->pose);
    }
    device_.write(done.force);
    return done;
}

}  // namespace hepatica
