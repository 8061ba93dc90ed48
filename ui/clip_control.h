// SPDX-License-Identifier: GPL-3.0-or-later
// Cuts away the part of the 3D view in front of a plane. The plane keeps its place in the patient
// when the view is turned, so that one can look into the opened part.
#pragma once

#include "render/scene_view.h"

namespace hepatica {

inline constexpr double clip_step_mm = 2.0;  // per key press or wheel notch

// UI thread only; the view must outlive it.
class ClipControl {
  public:
    explicit ClipControl(SceneView& view) : view_(view) {}

    // Puts the plane through this point, perpendicular to the line of sight.
    void open_at(const Vec3& point_mm);
    void close();
    // Moves the plane along its normal, deeper into the patient if by_mm > 0. No effect if the view
    // is not open.
    void shift(double by_mm);

    // How far the plane was moved from where it was put; negative towards the eye.
    double depth_mm() const { return depth_mm_; }

    bool is_open() const { return plane_.has_value(); }
    const std::optional<ClipPlane>& plane() const { return plane_; }

  private:
    SceneView& view_;
    std::optional<ClipPlane> plane_;
    double depth_mm_ = 0.0;
};

}  // namespace hepatica
