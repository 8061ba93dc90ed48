// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/slices/mask_brush.h"

#include <algorithm>
#include <utility>

namespace hepatica {

bool is_worth_a_step(const BrushStroke& stroke, const Vec3& place_mm) {
    return (stroke.path_mm.back() - place_mm).norm() >= 0.2 * stroke.radius_mm;
}

void MaskBrush::set_mode(BrushMode mode) {
    mode_ = mode;
    lift();
    watchers_.tell();
}

void MaskBrush::set_radius(double radius_mm) {
    radius_mm_ = std::clamp(radius_mm, least_mm, most_mm);
    watchers_.tell();
}

void MaskBrush::begin(const Vec3& place_mm) {
    if (mode_ == BrushMode::away) return;
    down_ = true;
    strokes_.push_back({{place_mm}, radius_mm_, mode_ == BrushMode::erases});
    watchers_.tell();
}

void MaskBrush::lead_to(const Vec3& place_mm) {
    if (!down_ || !is_worth_a_step(strokes_.back(), place_mm)) return;
    strokes_.back().path_mm.push_back(place_mm);
    watchers_.tell();
}

void MaskBrush::lift() {
    if (!std::exchange(down_, false)) return;
    hand_.add(BrushStroke(strokes_.back()));
    watchers_.tell();
}

void MaskBrush::remove_last() {
    if (strokes_.empty()) return;
    strokes_.pop_back();
    if (!std::exchange(down_, false)) hand_.take_back(1);
    watchers_.tell();
}

void MaskBrush::remove_all() {
    const std::size_t kept = strokes_.size() - (std::exchange(down_, false) ? 1 : 0);
    strokes_.clear();
    if (kept > 0) hand_.take_back(kept);
    watchers_.tell();
}

void MaskBrush::show(const std::vector<BrushStroke>& strokes) {
    const std::size_t kept = strokes_.size() - (down_ ? 1 : 0);
    if (std::equal(strokes.begin(), strokes.end(), strokes_.begin(),
                   strokes_.begin() + static_cast<std::ptrdiff_t>(kept)))
        return;
    down_ = false;
    strokes_ = strokes;
    watchers_.tell();
}

void MaskBrush::remake() const {
    if (!strokes_.empty() && remake_) remake_();
}

}  // namespace hepatica
