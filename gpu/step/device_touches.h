// SPDX-License-Identifier: GPL-3.0-or-later
// What a body touches, on a machine: the lists that the host's search made, and what comes of them.
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
    // `standing_mm`: what the lists number behind the body's nodes.
    DeviceTouches(Machine& machine, std::span<const Vec3> standing_mm);

    // Of a body of so many nodes, which touches nothing then.
    void set_nodes(std::size_t nodes);
    // What does not change is not copied again.
    void set(const TouchList& list);
    // Forces and energies at these positions, stiffness but that of friction.
    void press(View<const Vector3<double>> position);
    // The stiffness of friction there, after press() and with all other forces of the nodes.
    void foresee(const NodeViews& nodes);

    TouchesView view() const;

  private:
    struct ByNode {
        std::vector<int> nodes, begin{0}, entries;  // nodes that touch something, their lists
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
    double tool_pad_mm_ = 1.0;
    Array<Vector3<double>> standing_;
    GrowingArray<int> row_;  // its copy on the host: while nothing touches
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
