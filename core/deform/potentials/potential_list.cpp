// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/deform/potentials/potential_list.h"

#include <algorithm>

#include "core/deform/potentials/grab_springs.h"
#include "core/deform/potentials/gravity.h"
#include "core/deform/potentials/load_input.h"
#include "core/deform/potentials/obstacle_contact.h"
#include "core/deform/potentials/self_contact.h"
#include "core/deform/potentials/self_friction.h"
#include "core/deform/potentials/softening_ties.h"
#include "core/deform/potentials/tether.h"
#include "core/deform/potentials/tool_contact.h"
#include "core/deform/potentials/tool_friction.h"
#include "core/deform/potentials/tool_load_sum.h"

namespace hepatica {

PotentialList::PotentialList(const Body& body) : nodes_(body.rest_positions_mm.size()) {
    auto gravity = std::make_unique<Gravity>(body);
    auto grabs = std::make_unique<GrabSprings>();
    gravity_ = gravity.get();
    grabs_ = grabs.get();
    all_.push_back(std::move(gravity));
    all_.push_back(std::make_unique<Tether>(body));
    all_.push_back(std::move(grabs));
    if (body.self_pad) {
        auto self = std::make_unique<SelfContact>(body);
        self_ = self.get();
        all_.push_back(std::move(self));
        if (body.self_pad->friction > 0.0) {
            auto friction = std::make_unique<SelfFriction>(body, *self_);
            self_friction_ = friction.get();
            all_.push_back(std::move(friction));
        }
    }
    if (body.obstacles) {
        auto obstacles = std::make_unique<ObstacleContact>(body);
        auto friction = std::make_unique<ObstacleFriction>(body, *obstacles);
        obstacles_ = obstacles.get();
        obstacle_friction_ = friction.get();
        all_.push_back(std::move(obstacles));
        all_.push_back(std::move(friction));
    }
    if (body.tears) {
        auto ties = std::make_unique<SofteningTies>();
        ties_ = ties.get();
        all_.push_back(std::move(ties));
    }
    if (body.surface.empty()) return;
    auto contact = std::make_unique<ToolContact>(body);
    auto friction = std::make_unique<ToolFriction>(body, *contact);
    contact_ = contact.get();
    friction_ = friction.get();
    all_.push_back(std::move(contact));
    all_.push_back(std::move(friction));
}

PotentialList::~PotentialList() = default;

void PotentialList::set_grabs(std::span<const Grab> grabs) {
    validate_grabs(grabs, nodes_);
    grabs_->set(grabs);
}

double PotentialList::grab_energy(std::span<const Vec3> positions_mm) const {
    return grabs_->energy(positions_mm, positions_mm);
}

void PotentialList::set_gravity(const Vec3& gravity_mm_per_s2) {
    validate_gravity(gravity_mm_per_s2);
    gravity_->set(gravity_mm_per_s2);
}

void PotentialList::set_tool(const std::optional<Tool>& tool) {
    if (tool) validate_tool(*tool, contact_ != nullptr);
    if (contact_ != nullptr) contact_->set(tool);
}

const std::optional<Tool>& PotentialList::tool() const {
    static const std::optional<Tool> none;
    return contact_ != nullptr ? contact_->tool() : none;
}

bool PotentialList::lead_tool(std::span<const Vec3> positions_mm, double share, double dt_s) {
    return tool() && contact_->lead(positions_mm, share, dt_s);
}

std::vector<int> PotentialList::vertices_near_tool(std::span<const Vec3> positions_mm) const {
    return tool() ? contact_->vertices_near_way(positions_mm) : std::vector<int>{};
}

bool PotentialList::tool_in_obstacle() const {
    return tool() && contact_->in_obstacle();
}

bool PotentialList::free_of_tool(std::span<const Vec3> positions_mm) const {
    return contact_ == nullptr || contact_->free(positions_mm);
}

ToolLoad PotentialList::tool_load(std::span<const Vec3> positions_mm, double dt_s) const {
    if (!tool()) return {};
    return load_of(*contact_, *friction_, positions_mm, dt_s);
}

ObstacleLoad PotentialList::obstacle_load(std::span<const Vec3> positions_mm) const {
    if (!obstacles_) return {};
    return load_of(*obstacles_, *obstacle_friction_, positions_mm);
}

TouchList PotentialList::touches_along(std::span<const Vec3> from_mm,
                                       std::span<const Vec3> to_mm) const {
    enum { between_surfaces, on_obstacles, on_tool };
    TouchList list;
    if (self_) self_->pairs().list_touches(from_mm, to_mm, list.pairs);
    if (self_friction_) self_friction_->list_rubs(between_surfaces, list.rubs);
    if (obstacles_) {
        obstacles_->list_touches(from_mm, to_mm, list.pairs);
        obstacle_friction_->list_rubs(on_obstacles, list.rubs);
    }
    if (tool()) {
        contact_->list_touches(from_mm, to_mm, list);
        friction_->list_rubs(on_tool, list.rubs);
    }
    if (ties_) ties_->list_touches(list);
    return list;
}

std::span<const Vec3> PotentialList::obstacles_mm() const {
    return obstacles_ ? obstacles_->standing_mm() : std::span<const Vec3>{};
}

bool PotentialList::touches(std::span<const Vec3> positions_mm) const {
    return tool() || coupled(positions_mm) ||
           (obstacles_ && !obstacles_->contacts(positions_mm).empty());
}

void PotentialList::begin_step(const BodyState& start, double dt_s,
                               std::span<const std::uint8_t> held) const {
    for (const auto& potential : all_) potential->begin_step(start, dt_s, held);
}

void PotentialList::end_step() const {
    for (const auto& potential : all_) potential->end_step();
}

double PotentialList::free_share(std::span<const Vec3> from_mm, std::span<const Vec3> to_mm) const {
    double share = 1.0;
    for (const auto& potential : all_)
        share = std::min(share, potential->free_share(from_mm, to_mm));
    return share;
}

double PotentialList::share_until_touch(std::span<const Vec3> from_mm,
                                        std::span<const Vec3> to_mm) const {
    double share = 1.0;
    for (const auto& potential : all_)
        share = std::min(share, potential->share_until_touch(from_mm, to_mm));
    return share;
}

const std::vector<Grab>& PotentialList::grabs() const {
    return grabs_->all();
}

const Vec3& PotentialList::gravity_mm_per_s2() const {
    return gravity_->mm_per_s2();
}

double PotentialList::energy(std::span<const Vec3> positions_mm,
                             std::span<const Vec3> reference_mm) const {
    double sum = 0.0;
    for (const auto& potential : all_) sum += potential->energy(positions_mm, reference_mm);
    return sum;
}

void PotentialList::add_forces(std::span<const Vec3> positions_mm,
                               std::span<Vec3> forces_un) const {
    for (const auto& potential : all_) potential->add_forces(positions_mm, forces_un);
}

void PotentialList::foresee(std::span<const Vec3> positions_mm,
                            std::span<const Vec3> forces_un) const {
    for (const auto& potential : all_) potential->foresee(positions_mm, forces_un);
}

void PotentialList::add_stiffness(std::span<const Vec3> positions_mm, double factor,
                                  BlockMatrix& matrix) const {
    for (const auto& potential : all_) potential->add_stiffness(positions_mm, factor, matrix);
}

void PotentialList::add_product(std::span<const Vec3> positions_mm, double factor,
                                std::span<const Vec3> d, const BlockMatrix& pattern,
                                std::span<Vec3> product) const {
    for (const auto& potential : all_)
        potential->add_product(positions_mm, factor, d, pattern, product);
}

bool PotentialList::coupled(std::span<const Vec3> positions_mm) const {
    return std::ranges::any_of(
        all_, [&](const auto& potential) { return potential->coupled(positions_mm); });
}

void PotentialList::add_coupling(std::span<const Vec3> positions_mm, double factor,
                                 std::span<const Vec3> d, std::span<Vec3> product) const {
    for (const auto& potential : all_) potential->add_coupling(positions_mm, factor, d, product);
}

void PotentialList::append_coupling(std::span<const Vec3> positions_mm, double factor,
                                    CouplingBlocks& blocks) const {
    for (const auto& potential : all_) potential->append_coupling(positions_mm, factor, blocks);
}

double PotentialList::book(std::span<const Vec3> positions_mm, std::span<const Vec3> reference_mm,
                           EnergyLedger& ledger) const {
    double sum = 0.0;
    ledger.contact = ledger.friction_loss = 0.0;  // shared by several potentials, which add to them
    for (const auto& potential : all_) {
        const double energy = potential->energy(positions_mm, reference_mm);
        potential->book(energy, ledger);
        sum += energy;
    }
    return sum;
}

}  // namespace hepatica
