// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/deform/potentials/external_forces.h"

#include <cmath>

#include "core/deform/step/node_loops.h"
#include "core/deform/stepper/stepper_input.h"

namespace hepatica {
namespace {

// Used by both the held point's force and its stiffness.
struct Pull {
    Vec3 stretch_mm;  // from the held point to the target
    double length_mm;
    double limit_mm;  // stretch at which the force stops growing
};

Pull pull_of(const Grab& grab, std::span<const Vec3> positions) {
    Vec3 stretch = Vec3::Zero();  // by differences: exact for a body far from the origin
    for (int a = 0; a < 4; ++a)
        if (grab.vertices[a] >= 0)
            stretch += grab.weights[a] * (grab.target_mm - positions[grab.vertices[a]]);
    return {stretch, stretch.norm(), grab.force_limit_un / grab.stiffness_un_per_mm};
}

Mat3 stiffness_of(const Grab& grab, const Pull& pull) {
    if (pull.length_mm <= pull.limit_mm) return grab.stiffness_un_per_mm * Mat3::Identity();
    const Vec3 n = pull.stretch_mm / pull.length_mm;
    return (grab.force_limit_un / pull.length_mm) * (Mat3::Identity() - n * n.transpose());
}

}  // namespace

void ExternalForces::set_grabs(std::span<const Grab> grabs) {
    validate_grabs(grabs, body_.rest_positions_mm.size());
    grabs_.assign(grabs.begin(), grabs.end());
}

void ExternalForces::set_gravity(const Vec3& gravity_mm_per_s2) {
    validate_gravity(gravity_mm_per_s2);
    gravity_ = gravity_mm_per_s2;
}

double ExternalForces::energy(std::span<const Vec3> positions_mm) const {
    double sum = sum_over_nodes(positions_mm.size(), [&](std::size_t i) {
        return 0.5 * body_.tether_un_per_mm[i] *
               (positions_mm[i] - body_.rest_positions_mm[i]).squaredNorm();
    });
    for (const Grab& grab : grabs_) {
        const Pull pull = pull_of(grab, positions_mm);
        sum += pull.length_mm <= pull.limit_mm
                   ? 0.5 * grab.stiffness_un_per_mm * pull.length_mm * pull.length_mm
                   : grab.force_limit_un * (pull.length_mm - 0.5 * pull.limit_mm);
    }
    return sum;
}

void ExternalForces::add_forces(std::span<const Vec3> positions_mm,
                                std::span<Vec3> forces_un) const {
    for_each_node(positions_mm.size(), [&](std::size_t i) {
        forces_un[i] += body_.mass_g[i] * gravity_ +
                        body_.tether_un_per_mm[i] * (body_.rest_positions_mm[i] - positions_mm[i]);
    });
    for (const Grab& grab : grabs_) {
        const Pull pull = pull_of(grab, positions_mm);
        const Vec3 force = pull.length_mm <= pull.limit_mm
                               ? Vec3(grab.stiffness_un_per_mm * pull.stretch_mm)
                               : Vec3(grab.force_limit_un / pull.length_mm * pull.stretch_mm);
        for (int a = 0; a < 4; ++a)
            if (grab.vertices[a] >= 0) forces_un[grab.vertices[a]] += grab.weights[a] * force;
    }
}

template <class Visit>
void ExternalForces::for_each_grab_block(const Grab& grab, std::span<const Vec3> positions_mm,
                                         const BlockMatrix& matrix, const Visit& visit) const {
    const Mat3 stiffness = stiffness_of(grab, pull_of(grab, positions_mm));
    for (int a = 0; a < 4; ++a)
        for (int b = 0; b < 4; ++b) {
            const int i = grab.vertices[a], j = grab.vertices[b];
            if (i < 0 || j < 0) continue;
            const double weight = grab.weights[a] * grab.weights[b];
            const bool stored = matrix.find(i, j) >= 0;
            visit(i, stored ? j : i, (stored ? weight : std::abs(weight)) * stiffness);
        }
}

void ExternalForces::add_stiffness(std::span<const Vec3> positions_mm, double factor,
                                   BlockMatrix& matrix) const {
    for_each_node(positions_mm.size(), [&](std::size_t i) {
        if (body_.tether_un_per_mm[i] > 0.0)
            matrix.block[matrix.diagonal[i]].diagonal().array() +=
                factor * body_.tether_un_per_mm[i];
    });
    for (const Grab& grab : grabs_)
        for_each_grab_block(grab, positions_mm, matrix, [&](int i, int j, const Mat3& block) {
            matrix.block[matrix.find(i, j)] += factor * block;
        });
}

double ExternalForces::quadratic_form(std::span<const Vec3> positions_mm, std::span<const Vec3> d,
                                      const BlockMatrix& matrix) const {
    double sum = sum_over_nodes(
        d.size(), [&](std::size_t i) { return body_.tether_un_per_mm[i] * d[i].squaredNorm(); });
    for (const Grab& grab : grabs_)
        for_each_grab_block(grab, positions_mm, matrix, [&](int i, int j, const Mat3& block) {
            sum += d[i].dot(block * d[j]);
        });
    return sum;
}

}  // namespace hepatica
