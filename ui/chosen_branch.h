// SPDX-License-Identifier: GPL-3.0-or-later
// The branch that is chosen in the table, as a line along its centreline that goes with the
// deformed body. A branch has one even where no vertex of the surface is nearest to it, as a short
// one between wide ones. No widgets.
#pragma once

#include <memory>
#include <vector>

#include "core/patient/patient_case.h"
#include "core/scene/frame.h"

namespace hepatica {

class ChosenBranch {
  public:
    // Number of a segment of his tree; -1: none.
    void choose(int branch, std::shared_ptr<const PatientCase> patient);
    void forget() { choose(-1, nullptr); }
    int branch() const { return branch_; }
    // In the frame's deformed body, at most `spacing_mm` apart at rest; empty: none is chosen.
    std::vector<Vec3> line_in(const Frame& frame);

    static constexpr double spacing_mm = 1.0;

  private:
    int branch_ = -1;
    std::shared_ptr<const PatientCase> patient_;
    std::vector<Vec3> at_rest_mm_;
    // The vertices that lead the points, and what they are vertices of.
    std::vector<int> anchors_;
    const std::vector<Vec3>* anchored_to_ = nullptr;
};

}  // namespace hepatica
