// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/slices/mask_brush.h"

#include <algorithm>

namespace hepatica {

void MaskBrush::set_mode(BrushMode mode) {
    mode_ = mode;
    lift();
    tell();
}

void MaskBrush::set_radius(double radius_mm) {
    radius_mm_ = std::clamp(radius_mm, least_mm, most_mm);
    tell();
}

void MaskBrush::begin(const Vec3& place_mm) {
    if (mode_ == BrushMode::away) return;
    down_ = true;
    strokes_.push_back({{place_mm}, radius_mm_, mode_ == BrushMode::erases});
    tell();
}

void MaskBrush::lead_to(const Vec3& place_mm) {
    if (!down_) return;
    std::vector<Vec3>& path = strokes_.back().path_mm;
    // The ball sweeps what lies between: nearer points would add nothing.
    if ((path.back() - place_mm).norm() < 0.2 * strokes_.back().radius_mm) return;
    path.push_back(place_mm);
    tell();
}

void MaskBrush::remove_last() {
    lift();
    if (!strokes_.empty()) strokes_.pop_back();
    tell();
}

void MaskBrush::remove_all() {
    lift();
    strokes_.clear();
    tell();
}

void MaskBrush::remake() const {
    if (!strokes_.empty() && remake_) remake_();
}

void MaskBrush::tell() const {
    for (const auto& watcher : watchers_) watcher();
}

}  // namespace hepatica
