// SPDX-License-Identifier: GPL-3.0-or-later
// Opens the three-dimensional view: what lies before a plane is taken out of it. The plane stays
// where it is in the patient when the view is turned, so that one can look into what was opened.
#pragma once

#include "render/scene_view.h"

namespace hepatica {

inline constexpr double clip_step_mm = 2.0;  // of a key or a notch of the wheel

// UI thread; the view must outlive it.
class ClipControl {
  public:
    explicit ClipControl(SceneView& view) : view_(view) {}

    // Puts the plane through the point, across the present line of sight.
    void open_at(const Vec3& point_mm);
    void close();
    // Moves the plane along its normal, deeper into the patient where > 0; nothing where it is not
    // there.
    void shift(double by_mm);

    bool is_open() const { return plane_.has_value(); }
    const std::optional<ClipPlane>& plane() const { return plane_; }

  private:
    SceneView& view_;
    std::optional<ClipPlane> plane_;
};

}  // namespace hepatica
