// SPDX-License-Identifier: GPL-3.0-or-later
// Makes the local model of a step from the deforming part: the points of the body in the tool's
// pad, joined to at most 64 contacts (see most_local_contacts), and their compliance. Belongs to
// the thread that steps.
#pragma once

#include <cstdint>
#include <optional>

#include "core/deform/potentials/tool_contact.h"
#include "core/haptics/local_model.h"
#include "core/haptics/patch_compliance.h"
#include "core/scene/deform_part.h"

namespace hepatica {

struct JoinedContacts {
    std::vector<LocalContact> contacts;
    std::vector<SparseLoad> loads;            // a unit force for each
    std::vector<double> stiffness_un_per_mm;  // of its pads
};

// Joins contacts, ordered by part and triangle as `pads` gives them, so that neighbours in the list
// are neighbours on the tool. A joined contact has the sum of their forces, at their force-weighted
// mean, and the sum of their stiffnesses. Where their forces cancel they are left out, because the
// joined contact would have no normal.
void join(std::span<const PadContact> points, const ToolContact& pads, JoinedContacts& joined);

// Contacts of obstacles, which are rigid and compliant by their pads alone; the loads are of
// nothing. Fewer than those of the body, because obstacles do not bend to the tool.
inline constexpr int most_rigid_contacts = 16;  // and one for each further part
void join_rigid(const ToolContact::ObstaclePress& press, JoinedContacts& joined);

class PatchFeed {
  public:
    // Fills the model from the part after a step of dt_s. Costs nothing without a tool, a search
    // for contacts with one, and for contacts some solves with a factor, which is computed again
    // where the patch has rotated or stretched. A torn body is felt at its bare
    // faces, too, and counts as rigid: only its pads are compliant. Obstacles are felt as the play
    // has them: where they stop the tool.
    void fill(const DeformPart& part, double dt_s, LocalModel& model);

  private:
    void follow(const DeformPart& part);
    void follow_tear(const TornTopology* torn);
    Eigen::MatrixXd give(std::span<const Vec3> positions_mm, double dt_s);

    // Belong to the body with the settings below.
    std::optional<PatchCompliance> compliance_;
    std::optional<ToolContact> contact_;
    double wall_mm_ = 0.0, tether_pa_per_mm2_ = 0.0;
    ElementModel model_ = ElementModel::corotated;

    JoinedContacts joined_, rigid_;  // of the body, of obstacles

    // Of the tear whose surface contact_ has: how many vertices it has split, and its version.
    std::uint64_t split_ = 0, split_version_ = 0;
};

}  // namespace hepatica
