// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/deform/potentials/potential_list.h"

#include <algorithm>

#include "core/base/error.h"
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
    ToolLoadSum sum(*tool());
    const std::vector<PadContact> contacts = contact_->contacts(positions_mm);
    for (const PadContact& contact : contacts) sum.press(contact);
    for (const auto& point : friction_->point_forces(positions_mm))
        sum.drag(point.at_mm, point.force_un);
    const Vec3 of_body_un = sum.load().force_un;
    const ToolContact::ObstaclePress obstacles = contact_->pressed_by_obstacles();
    for (const PadContact& contact : obstacles.contacts) sum.press(contact, obstacles.share);
    ToolLoad load = sum.load();
    load.impulse_un_s = dt_s * of_body_un;
    load.contacts = static_cast<int>(contacts.size());
    for (const PadContact& contact : contacts)
        for (const int node : contact_->nodes_of(contact)) load.touched.push_back(node);
    std::ranges::sort(load.touched);
    load.touched.erase(std::unique(load.touched.begin(), load.touched.end()), load.touched.end());
    load.least_gap_mm = std::min(contact_->least_gap_mm(positions_mm), obstacles.least_gap_mm);
    return load;
}

ObstacleLoad PotentialList::obstacle_load(std::span<const Vec3> positions_mm) const {
    ObstacleLoad load;
    if (!obstacles_) return load;
    load.touch = load_of(obstacles_->contacts(positions_mm));
    std::vector<Vec3> on_body(nodes_, Vec3::Zero());
    obstacles_->add_forces(positions_mm, on_body);
    for (const auto& point : obstacle_friction_->point_forces(positions_mm))
        load.force_un -= point.force_un;
    for (const Vec3& force : on_body) load.force_un -= force;
    return load;
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

SurfacesKept PotentialList::kept_overlaps() const {
    SurfacesKept kept;
    if (self_) kept.self = self_->pairs().kept_overlaps();
    if (obstacles_) kept.obstacles = obstacles_->pairs().kept_overlaps();
    return kept;
}

void PotentialList::set_overlaps(const SurfacesKept& kept) {
    const auto take = [](const std::optional<OverlapsKept>& some, auto* contact) {
        return !some || (contact && contact->pairs().set_overlaps(*some));
    };
    const SurfacesKept before = kept_overlaps();
    if (take(kept.self, self_) && take(kept.obstacles, obstacles_)) return;
    take(before.self, self_);
    throw InputError("has surfaces that touch otherwise", "the checkpoint of a body",
                     "Make the stepper of the body that it was taken of");
}

void PotentialList::let_go(std::span<const Vec3> positions_mm) const {
    if (self_) self_->pairs().let_go(positions_mm);
    if (obstacles_) obstacles_->let_go(positions_mm);
}

void PotentialList::find_overlaps(std::span<const Vec3> positions_mm) const {
    if (self_) self_->pairs().find_overlaps(positions_mm);
    if (obstacles_) obstacles_->find_overlaps(positions_mm);
}

PotentialList::SurfacesBeforeTear PotentialList::before_tear() const {
    SurfacesBeforeTear before;
    if (self_) before.self = std::make_shared<BeforeTear>(self_->pairs().before_tear());
    if (obstacles_)
        before.obstacles = std::make_shared<BeforeTear>(obstacles_->pairs().before_tear());
    return before;
}

void PotentialList::follow_split(const SurfacesBeforeTear& before, std::span<const int> parents,
                                 std::span<const Vec3> positions_mm) const {
    if (before.self) self_->pairs().follow_split(*before.self, parents, positions_mm);
    if (before.obstacles) obstacles_->follow_split(*before.obstacles, parents, positions_mm);
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
