// SPDX-License-Identifier: GPL-3.0-or-later
// Page-locks the memory of host vectors that are repeatedly copied to and from a machine
// (Machine::pin). The vectors must keep their length; two of equal length may be swapped.
#pragma once

#include <initializer_list>
#include <vector>

#include "core/base/vector.h"
#include "gpu/machine/machine.h"

namespace hepatica::gpu {

class PinnedVectors {
  public:
    explicit PinnedVectors(Machine& machine) : machine_(machine) {}
    ~PinnedVectors() { release(); }
    PinnedVectors(const PinnedVectors&) = delete;
    PinnedVectors& operator=(const PinnedVectors&) = delete;

    // Resizes the vectors, sets them to zero, and pins them instead of those pinned before.
    void resize(std::initializer_list<std::vector<Vec3>*> vectors, std::size_t size) {
        release();
        for (std::vector<Vec3>* vector : vectors) {
            vector->assign(size, Vec3::Zero());
            if (size == 0) continue;
            machine_.pin(vector->data(), size * sizeof(Vec3));
            pinned_.push_back(vector->data());
        }
    }

  private:
    void release() {
        for (Vec3* memory : pinned_) machine_.unpin(memory);
        pinned_.clear();
    }

    Machine& machine_;
    std::vector<Vec3*> pinned_;
};

}  // namespace hepatica::gpu
