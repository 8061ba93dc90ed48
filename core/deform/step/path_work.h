// SPDX-License-Identifier: GPL-3.0-or-later
// Work of the forces of elements and potentials along the straight path between two shapes, by
// adaptive Simpson quadrature of the forces. No energies are used, so that comparing the two checks
// that the forces are gradients of the energies. For tests and studies: costs five evaluations of
// all elements on a smooth path, and up to a few hundred where elements invert on it.
#pragma once

#include <span>
#include <stop_token>
#include <vector>

#include "core/deform/potentials/potential_list.h"
#include "core/deform/step/assembly.h"

namespace hepatica {

// Has its own slots and shares the assembly's plan. Not thread-safe; the same bits for any number
// of threads.
class PathWork {
  public:
    explicit PathWork(const Assembly& assembly) : assembly_(assembly.with_own_slots()) {}

    struct Result {
        double work_nj = 0.0;
        double error_nj = 0.0;  // a conservative estimate
        int evaluations = 0;
    };
    // Refines until the error is at most `tolerance_nj`, or the limit of evaluations is reached.
    // Throws Cancelled after a stop is requested.
    Result along(std::span<const Vec3> from_mm, std::span<const Vec3> to_mm,
                 const PotentialList& potentials, double tolerance_nj,
                 const std::stop_token& stop = {});

  private:
    double power(double place, std::span<const Vec3> from_mm, std::span<const Vec3> to_mm,
                 const PotentialList& potentials);

    Assembly assembly_;
    std::vector<Vec3> x_, motion_, force_;
};

}  // namespace hepatica
