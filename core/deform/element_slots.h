// SPDX-License-Identifier: GPL-3.0-or-later
// What every element of a body writes: its forces and stiffness blocks, into slots of its own, as
// the paper has it. Four elements lie side by side in the lanes of a slot, and are evaluated in
// one pass where their function is written for lanes.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "core/base/vector.h"
#include "core/deform/body.h"
#include "core/deform/elements/lanes.h"

namespace hepatica {

// Keeps a reference to the body. Not thread-safe; loops inside run in parallel and give the same
// bits for any number of threads.
class ElementSlots {
  public:
    explicit ElementSlots(const Body& body);

    // Evaluates all elements at the positions; returns the elastic energy [nJ]. With
    // Tangent::none only forces are written, otherwise forces and stiffness.
    double evaluate(std::span<const Vec3> positions_mm, small::Tangent tangent);
    // The elastic energy alone; leaves the slots as they are.
    double energy(std::span<const Vec3> positions_mm) const;
    // d^T K d over the blocks and differences of d, independent of any matrix.
    double quadratic_form(std::span<const Vec3> d) const;

    // The slot of the force on node a of element e of group g ...
    int force_slot(std::size_t g, int e, int a) const;
    // ... and of its block of a pair of nodes (see pair_index).
    int block_slot(std::size_t g, int e, int pair) const;
    // Elastic force [uN] in a slot.
    Vec3 force(int slot) const;
    // Adds a slot's block [uN/mm], row-major.
    void add_block(int slot, double (&sum)[9]) const;

  private:
    static constexpr int lanes = 4;
    using Wide = small::Lanes<double, lanes>;

    struct Group {
        int first_force = 0;  // entries of force_ and block_
        int first_block = 0;
        std::vector<small::TetrahedronRest<Wide>> tetrahedra;
    };
    // The elements of a pack; beyond the last element of a group it repeats that.
    struct Pack {
        const ElementGroup* group;
        int first;  // element
        int count;  // of its lanes that count

        int element(int lane) const { return first + (lane < count ? lane : count - 1); }
        const int* nodes(int lane) const {
            return group->connectivity.data() + element(lane) * group->nodes_per_element;
        }
    };

    template <class Visit>
    double sum_over_packs(const Visit& visit) const;
    static void load(const Pack& pack, std::span<const Vec3> values, small::Vector3<Wide>* x);
    template <small::Tangent tangent>
    double evaluate_pack(std::size_t g, const Pack& pack, std::span<const Vec3> positions_mm);
    template <small::Tangent tangent>
    double evaluate_singly(std::size_t g, const Pack& pack, std::span<const Vec3> positions_mm);

    const Body& body_;
    std::vector<Group> groups_;
    std::vector<small::Vector3<Wide>> force_;
    std::vector<small::Matrix3<Wide>> block_;
};

inline Vec3 ElementSlots::force(int slot) const {
    const small::Vector3<Wide>& wide = force_[static_cast<std::size_t>(slot / lanes)];
    const int lane = slot % lanes;
    return {wide[0][lane], wide[1][lane], wide[2][lane]};
}

inline void ElementSlots::add_block(int slot, double (&sum)[9]) const {
    const small::Matrix3<Wide>& wide = block_[static_cast<std::size_t>(slot / lanes)];
    const int lane = slot % lanes;
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) sum[3 * i + j] += wide(i, j)[lane];
}

}  // namespace hepatica
