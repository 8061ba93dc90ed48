// SPDX-License-Identifier: GPL-3.0-or-later
// The liver found in randomised bodies whose organs touch it (random_abdomen.h). Oracle: what was
// drawn. The seeds are others than those at which the method was made (1 to 24, 901 to 903).
#include <gtest/gtest.h>

#include <array>

#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/segmentation/liver_region.h"
#include "tests/segmentation/random_abdomen.h"
#include "tests/support/falls_of_progress.h"

namespace hepatica::test {
namespace {

struct Share {
    std::size_t taken = 0, all = 0;
    double of_all() const {
        return all > 0 ? static_cast<double>(taken) / static_cast<double>(all) : 0.0;
    }
};

struct Judged {
    double dice = 0.0;
    std::array<Share, static_cast<std::size_t>(AbdomenOrgan::count)> organs;

    double taken(AbdomenOrgan organ) const {
        return organs[static_cast<std::size_t>(organ)].of_all();
    }
};

Judged judged(const RandomAbdomen& body, const Mask& found) {
    Judged result;
    std::size_t both = 0, sum = 0;
    for (std::size_t i = 0; i < found.voxels.size(); ++i) {
        Share& share = result.organs[body.organs.voxels[i]];
        ++share.all;
        if (found.voxels[i] != 0) ++share.taken;
        both += found.voxels[i] != 0 && body.liver.voxels[i] != 0 ? 1 : 0;
        sum += (found.voxels[i] != 0 ? 1 : 0) + (body.liver.voxels[i] != 0 ? 1 : 0);
    }
    result.dice = 2.0 * static_cast<double>(both) / static_cast<double>(sum);
    return result;
}

class FoundLiver : public testing::TestWithParam<int> {};

INSTANTIATE_TEST_SUITE_P(Seeds, FoundLiver, testing::Range(101, 109));

TEST_P(FoundLiver, LeavesOutItsNeighbours) {
    Job job;
    const RandomAbdomen body =
        random_abdomen({.seed = static_cast<std::uint64_t>(GetParam()), .spacing_mm = {2, 2, 2.5}});
    const Judged found = judged(body, find_liver(body.ct, job).liver);
    EXPECT_GT(found.dice, 0.90);
    EXPECT_LT(found.taken(AbdomenOrgan::spleen), 0.15);
    EXPECT_LT(found.taken(AbdomenOrgan::heart), 0.15);
    EXPECT_LT(found.taken(AbdomenOrgan::stomach), 0.15);
    EXPECT_LT(found.taken(AbdomenOrgan::kidney), 0.05);
    EXPECT_LT(found.taken(AbdomenOrgan::wall), 0.02);
    EXPECT_LT(found.taken(AbdomenOrgan::bowel), 0.05);
}

TEST(FoundLiverInASlab, IsFoundToItsCutEnds) {
    Job job;
    for (const std::uint64_t seed : {911u, 912u}) {
        const RandomAbdomen body =
            random_abdomen({.seed = seed, .spacing_mm = {2, 2, 2.5}, .slab_mm = 45.0});
        EXPECT_GT(judged(body, find_liver(body.ct, job).liver).dice, 0.90) << seed;
    }
}

// Its many filters report each from the beginning on.
TEST(FoundLiverProgress, RisesToTheEnd) {
    const RandomAbdomen body = random_abdomen({.seed = 101, .spacing_mm = {3, 3, 3}});
    Job job;
    const FallsOfProgress falls(job);
    find_liver(body.ct, job);
    EXPECT_TRUE(falls.stages().empty());
    EXPECT_GT(falls.reports(), 100);
    EXPECT_NEAR(job.progress().fraction, 1.0, 1e-9);
}

TEST(FoundLiverOfAnyThreads, HasTheSameVoxels) {
    const RandomAbdomen body = random_abdomen({.seed = 101, .spacing_mm = {3, 3, 3}});
    Job job;
    const Mask of_all = find_liver(body.ct, job).liver;
    const ThreadLimit one(1);
    EXPECT_EQ(find_liver(body.ct, job).liver.voxels, of_all.voxels);
}

}  // namespace
}  // namespace hepatica::test
