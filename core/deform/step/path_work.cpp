// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/deform/step/path_work.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/stop.h"
#include "core/deform/solvers/node_loops.h"

namespace hepatica {
namespace {

constexpr int most_evaluations = 257;

// A section of the path with the force along it at five equidistant places.
struct Stretch {
    double begin, length;
    std::array<double, 5> value;

    double simpson() const { return length / 6.0 * (value[0] + 4.0 * value[2] + value[4]); }
    double refined() const {
        return length / 12.0 *
               (value[0] + 4.0 * value[1] + 2.0 * value[2] + 4.0 * value[3] + value[4]);
    }
    // Error of the extrapolated integral; 1/15 of the refinement where the integrand is smooth.
    double error() const { return 2.0 * std::abs(refined() - simpson()) / 15.0; }
    double integral() const { return refined() + (refined() - simpson()) / 15.0; }
};

}  // namespace

// Force times motion at this place of the path.
double PathWork::power(double place, std::span<const Vec3> from_mm, std::span<const Vec3> to_mm,
                       const PotentialList& potentials) {
    const std::size_t nodes = from_mm.size();
    x_.resize(nodes);
    motion_.resize(nodes);
    force_.resize(nodes);
    for_each_node(nodes, [&](std::size_t i) {
        motion_[i] = to_mm[i] - from_mm[i];
        x_[i] = from_mm[i] + place * motion_[i];
    });
    assembly_.evaluate(x_);
    assembly_.gather_forces(force_);
    potentials.add_forces(x_, force_);
    return dot(motion_, force_);
}

PathWork::Result PathWork::along(std::span<const Vec3> from_mm, std::span<const Vec3> to_mm,
                                 const PotentialList& potentials, double tolerance_nj,
                                 const std::stop_token& stop) {
    const auto at = [&](double place) {
        throw_if_stopped(stop);
        return power(place, from_mm, to_mm, potentials);
    };
    std::vector<Stretch> stretches{{0.0, 1.0, {at(0.0), at(0.25), at(0.5), at(0.75), at(1.0)}}};
    Result result;
    for (result.evaluations = 5;; result.evaluations += 4) {
        result.work_nj = result.error_nj = 0.0;
        for (const Stretch& stretch : stretches) {
            result.work_nj += stretch.integral();
            result.error_nj += stretch.error();
        }
        if (!(result.error_nj > tolerance_nj) || result.evaluations + 4 > most_evaluations)
            return result;
        const auto worst = std::ranges::max_element(stretches, {}, &Stretch::error);
        const Stretch whole = *worst;
        const double half = 0.5 * whole.length, middle = whole.begin + half;
        const auto& v = whole.value;
        *worst = {whole.begin,
                  half,
                  {v[0], at(whole.begin + 0.25 * half), v[1], at(whole.begin + 0.75 * half), v[2]}};
        stretches.push_back(
            {middle, half, {v[2], at(middle + 0.25 * half), v[3], at(middle + 0.75 * half), v[4]}});
    }
}

}  // namespace hepatica
