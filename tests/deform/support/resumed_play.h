// SPDX-License-Identifier: GPL-3.0-or-later
// A play that is resumed from a checkpoint in its middle, through bytes, must end with the same
// bits.
#pragma once

#include <gtest/gtest.h>

#include <cstdint>
#include <string>

#include "core/deform/stepper/stepper.h"
#include "core/deform/stepper/stepper_checkpoint.h"

namespace hepatica::test {

// `make()` gives the stepper of the play and `step(stepper, k)` makes step k of `steps`. Returns
// what was kept after step `kept_at`.
template <class Make, class Step>
StepperCheckpoint expect_same_bits_from(int kept_at, int steps, const Make& make,
                                        const Step& step) {
    const auto first = make(), second = make();
    std::string bytes;
    std::uint64_t then = 0;
    for (int k = 0; k < steps; ++k) {
        step(*first, k);
        if (k != kept_at) continue;
        bytes = to_bytes(first->checkpoint());
        then = first->state_hash();
    }
    StepperCheckpoint checkpoint = checkpoint_from_bytes(bytes);
    EXPECT_EQ(to_bytes(checkpoint), bytes);
    second->restore(checkpoint);
    EXPECT_EQ(second->state_hash(), then) << "kept at " << kept_at;
    for (int k = kept_at + 1; k < steps; ++k) step(*second, k);
    EXPECT_EQ(second->state_hash(), first->state_hash()) << "kept at " << kept_at;
    return checkpoint;
}

}  // namespace hepatica::test
