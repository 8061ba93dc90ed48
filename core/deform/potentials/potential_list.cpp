// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/deform/potentials/potential_list.h"

#include "core/deform/potentials/grab_springs.h"
#include "core/deform/potentials/gravity.h"
#include "core/deform/potentials/tether.h"
#include "core/deform/stepper/stepper_input.h"

namespace hepatica {

PotentialList::PotentialList(const Body& body) : nodes_(body.rest_positions_mm.size()) {
    auto gravity = std::make_unique<Gravity>(body);
    auto grabs = std::make_unique<GrabSprings>();
    gravity_ = gravity.get();
    grabs_ = grabs.get();
    all_.push_back(std::move(gravity));
    all_.push_back(std::make_unique<Tether>(body));
    all_.push_back(std::move(grabs));
}

PotentialList::~PotentialList() = default;

void PotentialList::set_grabs(std::span<const Grab> grabs) {
    validate_grabs(grabs, nodes_);
    grabs_->set(grabs);
}

void PotentialList::set_gravity(const Vec3& gravity_mm_per_s2) {
    validate_gravity(gravity_mm_per_s2);
    gravity_->set(gravity_mm_per_s2);
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

double PotentialList::book(std::span<const Vec3> positions_mm, std::span<const Vec3> reference_mm,
                           EnergyLedger& ledger) const {
    double sum = 0.0;
    for (const auto& potential : all_) {
        const double energy = potential->energy(positions_mm, reference_mm);
        potential->book(energy, ledger);
        sum += energy;
    }
    return sum;
}

}  // namespace hepatica
