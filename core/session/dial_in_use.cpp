// SPDX-License-Identifier: GPL-3.0-or-later
// hepatica::DialInUse: the dial's settings by index.
#include "core/session/dial_in_use.h"

#include <utility>
#include <vector>

#include "core/scene/deform_part.h"
#include "core/scene/setting_json.h"

namespace hepatica {

namespace {

QualityGovernor governor_of(const QualityDial& dial) {
    std::vector<double> costs, errors;
    for (const QualityPoint& point : dial.front()) {
        costs.push_back(point.frame_ms);
        errors.push_back(point.error_relative);
    }
    return {std::move(costs), errors};
}

}  // namespace

DialInUse::DialInUse(QualityDial dial) : dial_(std::move(dial)), governor_(governor_of(dial_)) {}

std::optional<double> DialInUse::quality() const {
    if (!point_) return std::nullopt;
    return dial_.quality_of(*point_);
}

void DialInUse::follow(const DeformPart& deform) {
    const StepperOptions setting = deform.setting();
    point_.reset();
    for (std::size_t i = 0; i < dial_.front().size() && !point_; ++i)
        if (same_setting(dial_.front()[i].options, setting)) point_ = i;
}

void DialInUse::use(std::size_t point, DeformPart& deform) {
    deform.use(dial_.front()[point].options);
    point_ = point;
}

bool DialInUse::take(QualityDial dial, DeformPart* deform, double budget_ms) {
    const std::optional<double> turned = quality();
    dial_ = std::move(dial);
    forget_costs();
    if (deform == nullptr) return false;
    follow(*deform);
    if (point_ || !turned) return false;
    use(automatic_ ? governor_.start(budget_ms) : dial_.index_at(*turned), *deform);
    return true;
}

void DialInUse::turn(double quality, DeformPart& deform) {
    automatic_ = false;
    use(dial_.index_at(quality), deform);
}

void DialInUse::turn_automatically(double budget_ms, DeformPart& deform) {
    automatic_ = true;
    forget_costs();
    use(governor_.start(budget_ms), deform);
}

void DialInUse::forget_costs() {
    governor_ = governor_of(dial_);
}

bool DialInUse::govern(double step_ms, double budget_ms, DeformPart* deform) {
    if (!automatic_ || !point_ || deform == nullptr) return false;
    const std::size_t next = governor_.next(*point_, step_ms, budget_ms);
    if (next == *point_) return false;
    use(next, *deform);
    return true;
}

void DialInUse::fill(FrameStatistics& statistics) const {
    statistics.automatic = automatic_;
    statistics.expected_error = point_ ? dial_.front()[*point_].error_relative : 0.0;
    statistics.error_reference = point_ ? dial_.front()[*point_].reference : "";
    statistics.quality = quality().value_or(0.0);
}

}  // namespace hepatica
