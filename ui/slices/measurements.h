// SPDX-License-Identifier: GPL-3.0-or-later
// Measurements in the slices and the 3D view: distances, angles, and the diameter of a vessel at
// its centreline with the degree of stenosis (core/tree/lumen_calibre.h). No widgets.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "core/tree/vessel_tree.h"

namespace hepatica {

enum class MeasurementKind { distance, angle, diameter };

// Points in patient coordinates, mm: two for a distance, three for an angle with the vertex second,
// two on the wall across the centreline for a diameter; fewer while it is being made.
struct Measurement {
    MeasurementKind kind = MeasurementKind::distance;
    std::vector<Vec3> points_mm;
    std::string text;  // empty while it is being made
};

// The slice, or the picture plane of the 3D view, in which a point is set. Unit vectors.
struct SlicePlane {
    Vec3 normal = Vec3::UnitZ();
    Vec3 right = Vec3::UnitX();  // to the right on the screen
};

// UI thread only.
class Measurements {
  public:
    // Called after every change.
    void on_change(std::function<void()> tell) { watchers_.push_back(std::move(tell)); }

    // Sets what the next points measure; nullopt: nothing. Drops an unfinished measurement.
    void choose(std::optional<MeasurementKind> kind);
    std::optional<MeasurementKind> chosen() const { return kind_; }

    // Adds a point to the chosen measurement. Returns the message for the user: the result, or why
    // there is none; empty while points are missing. A diameter is drawn across the vessel within
    // `plane`.
    std::string add_point(const Vec3& position_mm, const SlicePlane& plane, const VesselTree& tree);
    void remove_last();  // an unfinished one first
    void clear();        // for another patient
    // To be called when the tree has been corrected.
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
