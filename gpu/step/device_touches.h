// SPDX-License-Identifier: GPL-3.0-or-later
// The contacts of a body on a machine: the lists made by the host's search, and their forces.
#pragma once

#include <span>
#include <vector>

#include "core/base/vector.h"
#include "core/deform/potentials/touch_list.h"
#include "gpu/kernels/step_kernels.h"
#include "gpu/step/growing_array.h"

namespace hepatica::gpu {

class DeviceTouches {
  public:
    // `standing_mm`: points that do not move, which the lists number after the body's nodes.
    DeviceTouches(Machine& machine, std::span<const Vec3> standing_mm);

    // Sets the number of nodes of the body and clears all contacts.
    void set_nodes(std::size_t nodes);
    // Sets the contacts; unchanged data are not copied again.
    void set(const TouchList& list);
    // Computes forces and energies at these positions, and stiffness except that of friction.
    void press(View<const Vector3<double>> position);
    // Computes the stiffness of friction at the same positions; call after press(), with all other
    // forces of the nodes.
    void foresee(const NodeViews& nodes);

    TouchesView view() const;

  private:
    struct ByNode {
        std::vector<int> nodes, begin{0}, entries;  // nodes with contacts, and their lists
    };
    ByNode lists_by_node(const std::vector<int>& touch_nodes);
    void list_by_node(std::vector<int> touch_nodes);
    PlacesView places(View<const Vector3<double>> position) const {
        return {position, standing_.read()};
    }
    std::size_t pads() const { return points_.size() + pairs_.size(); }
    std::size_t first_tie() const { return pads() + rubs_.size(); }

    Machine& machine_;
    int nodes_ = 0;
    Array<Vector3<double>> standing_;
    GrowingArray<int> row_;  // the host's copy is that without contacts
    GrowingArray<PadCapsule> tool_;
    GrowingArray<PadPoint> points_;
    GrowingArray<PadPair> pairs_;
    GrowingArray<RubPoint> rubs_;
    SofteningLaw softening_;
    GrowingArray<TieTouch> ties_;
    GrowingArray<int> touch_nodes_, touched_, begin_, entries_;
    GrowingArray<TouchPull> pulls_;
    std::vector<int> count_of_node_;  // scratch, all 0 between calls
};

}  // namespace hepatica::gpu
