// SPDX-License-Identifier: GPL-3.0-or-later
// hepatica::GovernedStepper: what tears after a step, and how the back end follows.
#include <span>
#include <vector>

#include "core/deform/stepper/governed_stepper.h"

namespace hepatica {
namespace {

// The vertices on both sides of these joints.
std::vector<int> vertices_at(const TornTopology& topology, std::span<const int> joints) {
    std::vector<int> vertices;
    for (const int j : joints)
        for (int k = 0; k < 3; ++k)
            for (const int v : topology.sides(topology.joints()[j], k)) vertices.push_back(v);
    return vertices;
}

}  // namespace

TearLoads GovernedStepper::tear_loads() {
    tearing_->take_openings(back_end_->ties());
    back_end_->find_stress(stress_pa_, energy_nj_);
    return {stress_pa_, energy_nj_, back_end_->state().positions_mm, back_end_->body().mass_g};
}

void GovernedStepper::tear(StepReport& report) {
    const TearLoads loads = tear_loads();
    tearing_->measure(loads);
    if (tearing_->part_overloaded(loads)) {
        const double before = back_end_->contact_energy();
        follow_tear();
        // Pads beside the tear have other areas and thicknesses, or are gone.
        const double lost = before - back_end_->contact_energy();
        report.energy.contact -= lost;
        report.energy.tear_loss += lost;
    }
    report.tear = tearing_->report();
}

void GovernedStepper::follow_tear(StepBackEnd& back_end) const {
    back_end.tear(description_, torn_body_of(*tearing_));
}

// Makes the back end follow the split and wakes the nodes around it.
void GovernedStepper::follow_tear() {
    const auto before = nodes();
    follow_tear(*back_end_);
    wake();
    if (!region_) return;
    const auto parents = tearing_->topology().parents();
    region_->follow_split(parents);
    std::vector<int> split;
    for (std::size_t v = before; v < nodes(); ++v) split.push_back(static_cast<int>(v));
    region_->wake(split);
    change_region();
}

void GovernedStepper::weaken(std::span<const int> joints, double factor) {
    if (!tearing_) return;
    tearing_->weaken(joints, factor);
    wake();
    if (region_ && region_->wake(vertices_at(tearing_->topology(), joints))) change_region();
}

void GovernedStepper::cut(const Vec3& corner_mm, const Vec3& first_edge_mm,
                          const Vec3& second_edge_mm) {
    if (!tearing_) return;
    const std::vector<int> joints =
        tearing_->crossing(corner_mm, first_edge_mm, second_edge_mm, positions_mm());
    if (joints.empty()) return;
    std::vector<int> tied = joints;
    std::erase_if(tied, [&](int j) { return !tearing_->topology().parted(j); });
    tearing_->measure(tear_loads());
    const double cohesion = back_end_->cohesion_energy(), contact = back_end_->contact_energy();
    tearing_->cut(joints);
    follow_tear();
    resting_.cohesion = back_end_->cohesion_energy();
    resting_.contact = back_end_->contact_energy();
    tool_work_ += resting_.cohesion - cohesion + resting_.contact - contact;
    // Joints that only lose their ties make no new vertices, around which it would wake.
    if (region_ && region_->wake(vertices_at(tearing_->topology(), tied))) change_region();
}

}  // namespace hepatica
