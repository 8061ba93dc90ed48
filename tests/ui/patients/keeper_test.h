// SPDX-License-Identifier: GPL-3.0-or-later
// A test of the keeper of patients, who has one from a CT.
#pragma once

#include <gtest/gtest.h>

#include <memory>
#include <vector>

#include "tests/ui/patients/fake_ward.h"

namespace hepatica::testing {

// A patient from a CT, saved as a.hep without corrections.
class KeeperTest : public ::testing::Test {
  protected:
    KeeperTest() {
        ward.open("ct");
        EXPECT_TRUE(ward.finish());
        save_as("a.hep");
        EXPECT_TRUE(ward.finish());
    }
    void add(int number) { ward.keeper().add(edit(number)); }
    void save_as(const char* name) { ward.keeper().save_as(FakeWard::path_of(name)); }

    // Vessels of one voxel, with this label.
    void remake(int label) {
        ward.keeper().remake(std::make_shared<const Volume>(),
                             Mask(Grid{{1, 1, 1}}, static_cast<std::uint8_t>(label)));
    }
    int label() const { return ward.workspace().patient()->mask.voxels[0]; }
    std::vector<int> edits() const { return numbers_of(ward.workspace().edits()); }

    FakeWard ward;
};

}  // namespace hepatica::testing
