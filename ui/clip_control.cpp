// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/clip_control.h"

namespace hepatica {

void ClipControl::open_at(const Vec3& point_mm) {
    plane_ = ClipPlane{point_mm, view_.axes().forward};
    depth_mm_ = 0.0;
    view_.set_clip(plane_);
}

void ClipControl::close() {
    plane_.reset();
    view_.set_clip(plane_);
}

void ClipControl::shift(double by_mm) {
    if (!plane_) return;
    plane_->point_mm += by_mm * plane_->inward;
    depth_mm_ += by_mm;
    view_.set_clip(plane_);
}

}  // namespace hepatica
