// SPDX-License-Identifier: GPL-3.0-or-later
// Measurements in the slices and the 3D view: distances, angles, and the diameter of a vessel at
// its centreline with the degree of stenosis (core/tree/lumen_calibre.h). No widgets.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "core/patient/measurement.h"
#include "core/tree/vessel_tree.h"

namespace hepatica {

// While it is being made it has fewer points.
struct Measurement : KeptMeasurement {
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
    // Whenever kept() was changed, unless by show() or clear(): it is to be kept with the case.
    void on_work(std::function<void()> tell) { on_work_ = std::move(tell); }

    // Sets what the next points measure; nullopt: nothing. Drops an unfinished measurement.
    void choose(std::optional<MeasurementKind> kind);
    std::optional<MeasurementKind> chosen() const { return kind_; }

    // Adds a point to the chosen measurement. Returns the message for the user: the result, or why
    // there is none; empty while points are missing. A diameter is drawn across the vessel within
    // `plane`.
    std::string add_point(const Vec3& position_mm, const SlicePlane& plane, const VesselTree& tree);
    void remove_last();  // of an unfinished one only its last point
    // Returns what it removed, those without a vessel among them.
    std::vector<KeptMeasurement> remove_all();
    // Puts these back before what was measured since; diameters are measured anew on the tree.
    void bring_back(std::vector<KeptMeasurement> removed, const VesselTree& tree);
    // The tree has been corrected: diameters are measured anew. One whose vessel is gone is left
    // out until the vessel is there again. Returns how many were lost with this tree.
    std::size_t follow_tree(const VesselTree& tree);

    // Those of a patient who is opened, on his tree. Returns how many of them have no vessel.
    std::size_t show(std::vector<KeptMeasurement> measurements, const VesselTree& tree);
    void clear();  // for another patient

    const std::vector<Measurement>& made() const { return made_; }
    // All, as a case keeps them: those made, and diameters without a vessel as they were measured.
    std::vector<KeptMeasurement> kept() const;
    const Measurement* half_made() const {
        return half_made_.points_mm.empty() ? nullptr : &half_made_;
    }

  private:
    void finish();
    void show_on(const VesselTree& tree);
    std::string add_diameter(const Vec3& position_mm, const SlicePlane& plane,
                             const VesselTree& tree);
    void tell() const;

    std::optional<MeasurementKind> kind_;
    Measurement half_made_;
    std::vector<KeptMeasurement> taken_;  // all, as they were when they were taken
    std::vector<Measurement> made_;       // of these, those that the vessels still have
    std::vector<std::size_t> places_;     // of each of made_ among taken_
    std::vector<std::function<void()>> watchers_;
    std::function<void()> on_work_ = [] {};
};

}  // namespace hepatica
