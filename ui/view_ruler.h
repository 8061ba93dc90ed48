// SPDX-License-Identifier: GPL-3.0-or-later
// Measuring in the 3D view: a click on a vessel sets a point of the measurements shared with the
// slices (slices/measurements.h). The shape at rest, which is the CT's, is measured, even if the
// vessel is pulled. The lines move with the vessels, and their text then says that it holds at
// rest.
#pragma once

#include <QString>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "core/patient/patient_case.h"
#include "core/scene/frame.h"
#include "render/scene_view.h"
#include "ui/slices/measurements.h"

namespace hepatica {

// UI thread only; no widgets. The measurements must outlive it.
class ViewRuler {
  public:
    struct Screen {
        std::function<void(std::vector<MeasureView>)> show;
        std::function<void(const std::string&)> say;
        std::function<const Frame*()> frame;  // the newest frame; null: none
    };
    ViewRuler(Measurements& measurements, Screen screen);

    // Null: none. Does not clear the measurements, and hides none.
    void show_patient(std::shared_ptr<const PatientCase> patient);
    // A point of the frame's surface was clicked; reports the result or what to do next.
    void click(const SurfacePick& pick, const ViewAxes& axes);
    // Whether those made so far are left out of the view: they would lie across a lesson's vessels.
    void hide_made(bool hide);
    // Moves the lines with the vessels of the newest frame.
    void follow();

    // What the next click does, in the window's language; empty if nothing is being measured.
    QString guidance() const;

  private:
    void find_anchors(const std::vector<Vec3>& rest);
    std::vector<const Measurement*> drawn() const;  // in order, an unfinished one last

    Measurements& measurements_;
    Screen screen_;
    std::shared_ptr<const PatientCase> patient_;
    std::size_t hidden_ = 0;  // so many of the first ones made are not drawn
    // For each point of drawn(): the vertex it moves with; -1: no vessel is near, and it stays.
    std::vector<int> anchors_;
    const void* anchored_to_ = nullptr;  // the rest positions used; null: none
};

}  // namespace hepatica
