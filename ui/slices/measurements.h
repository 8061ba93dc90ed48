// SPDX-License-Identifier: GPL-3.0-or-later
// What a person measures in slices and in the three-dimensional view: distances, angles, and the
// diameter of a vessel at its centreline with the stenosis there (core/tree/lumen_calibre.h). No
// widget.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "core/tree/vessel_tree.h"

namespace hepatica {

enum class MeasurementKind { distance, angle, diameter };

// In patient coordinates. A distance has two points, an angle three with its vertex between the
// others, a diameter two on the wall about the centreline; while it is being made, fewer.
struct Measurement {
    MeasurementKind kind = MeasurementKind::distance;
    std::vector<Vec3> points_mm;
    std::string text;  // empty while it is being made
};

// The slice, or the plane of the picture, in which a point is set.
struct SlicePlane {
    Vec3 normal = Vec3::UnitZ();
    Vec3 right = Vec3::UnitX();  // on the screen
};

// UI thread.
class Measurements {
  public:
    // Whenever anything below was changed.
    void on_change(std::function<void()> tell) { watchers_.push_back(std::move(tell)); }

    // What the next points are for; nothing: points are not for measuring. Drops what is half made.
    void choose(std::optional<MeasurementKind> kind);
    std::optional<MeasurementKind> chosen() const { return kind_; }

    // Returns what to tell the person: what has been measured, or why the point is of no use; else
    // an empty text. A diameter lies across the vessel, in the plane.
    std::string add_point(const Vec3& position_mm, const SlicePlane& plane, const VesselTree& tree);
    void remove_last();  // first what is half made
    void clear();        // of another patient
    // Diameters were those of a tree that has been corrected since.
    void remove_diameters();

    const std::vector<Measurement>& made() const { return made_; }
    const Measurement* half_made() const {
        return half_made_.points_mm.empty() ? nullptr : &half_made_;
    }

  private:
    void finish();
    std::string add_diameter(const Vec3& position_mm, const SlicePlane& plane,
                             const VesselTree& tree);
    void tell() const;

    std::optional<MeasurementKind> kind_;
    Measurement half_made_;
    std::vector<Measurement> made_;
    std::vector<std::function<void()>> watchers_;
};

}  // namespace hepatica
