// SPDX-License-Identifier: GPL-3.0-or-later
// Makes the local model of a step from the deforming part: the points of the body that lie in the
// tool's pad, joined to 64 contacts at most, and their compliance. Belongs to the thread that
// steps.
#pragma once

#include <optional>

#include "core/deform/potentials/tool_contact.h"
#include "core/haptics/local_model.h"
#include "core/haptics/patch_compliance.h"
#include "core/scene/deform_part.h"

namespace hepatica {

class PatchFeed {
  public:
    // As the part is after a step of dt_s. Costs nothing without a tool, a search for contacts with
    // one, and where something touches some solves with a factor, which is made anew where the
    // patch has turned or stretched. A body that is torn counts as stiff: its contacts give way by
    // their pads alone.
    void fill(const DeformPart& part, double dt_s, LocalModel& model);

  private:
    void follow(const DeformPart& part);
    void join(std::span<const PadContact> points, LocalModel& model);
    Eigen::MatrixXd give(std::span<const Vec3> positions_mm, double dt_s);

    // Of the body that it was made of.
    std::optional<PatchCompliance> compliance_;
    std::optional<ToolContact> contact_;
    double wall_mm_ = 0.0, tether_pa_per_mm2_ = 0.0;
    ElementModel model_ = ElementModel::corotated;

    std::vector<SparseLoad> loads_;  // of each joined contact a unit force, and
    std::vector<double> stiffness_;  // that of its pads [uN/mm]
};

}  // namespace hepatica
