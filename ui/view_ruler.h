// SPDX-License-Identifier: GPL-3.0-or-later
// Measuring in the three-dimensional view: a click on a vessel sets a point of what is being
// measured, in the list that the slices have, too (slices/measurements.h). What counts is the shape
// at rest, which is the CT's: a vessel that is pulled has no other diameter. The lines go along
// with the vessels, and say so.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "core/patient/patient_case.h"
#include "core/scene/frame.h"
#include "render/scene_view.h"
#include "ui/slices/measurements.h"

namespace hepatica {

// UI thread; no widget. The measurements must outlive it.
class ViewRuler {
  public:
    struct Screen {
        std::function<void(std::vector<MeasureView>)> show;
        std::function<void(const std::string&)> say;
        std::function<const Frame*()> frame;  // the newest; null: none
    };
    ViewRuler(Measurements& measurements, Screen screen);

    // Null: there is none. The list is not cleared here.
    void show_patient(std::shared_ptr<const PatientCase> patient);
    // A point of a vessel was clicked, as the frame shows it; says what has been measured or what
    // is missing.
    void click(const SurfacePick& pick, const ViewAxes& axes);
    // Brings the lines to where the newest frame has the vessels.
    void follow();

    // What the next click does; empty where nothing is being measured.
    std::string guidance() const;

  private:
    // The vertices at rest of which the frame's are moved.
    const std::vector<Vec3>& rest_of(const Frame& frame) const;
    void find_anchors(const std::vector<Vec3>& rest);

    Measurements& measurements_;
    Screen screen_;
    std::shared_ptr<const PatientCase> patient_;
    // Of each point of the list, in its order, with what is half made at the end: the vertex with
    // which it goes along; -1: no vessel is near it, and it stays.
    std::vector<int> anchors_;
    const void* anchored_to_ = nullptr;  // the vertices at rest; null: to be found anew
};

}  // namespace hepatica
