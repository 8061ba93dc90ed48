// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/patient/image_digest.h"

#include <gtest/gtest.h>

#include "core/base/error.h"

namespace hepatica {
namespace {

Volume some_ct() {
    Grid grid;
    grid.dims = {3, 4, 5};
    grid.spacing_mm = Vec3(0.7, 0.7, 1.25);
    grid.origin_mm = Vec3(-120.5, 33.25, -1000.125);
    Volume ct(grid);
    for (std::size_t i = 0; i < ct.voxels.size(); ++i)
        ct.voxels[i] = static_cast<std::int16_t>(37 * i - 1000);
    return ct;
}

TEST(ImageDigest, TellsImagesApartByVoxelsAndByGeometry) {
    const std::string digest = digest_of(some_ct());
    EXPECT_EQ(digest.size(), 64u);
    EXPECT_EQ(digest_of(some_ct()), digest);
    Volume other = some_ct();
    other.voxels[17] ^= 1;
    EXPECT_NE(digest_of(other), digest);
    other = some_ct();
    other.grid.spacing_mm.z() += 0.01;
    EXPECT_NE(digest_of(other), digest);
    other = some_ct();
    std::swap(other.grid.dims[0], other.grid.dims[1]);
    EXPECT_NE(digest_of(other), digest);
    other = some_ct();
    other.grid.origin_mm.y() += 0.002;
    EXPECT_NE(digest_of(other), digest);
    other = some_ct();
    other.grid.direction.col(0) *= -1.0;
    EXPECT_NE(digest_of(other), digest);
}

// As another format rounds it to single precision.
TEST(ImageDigest, BearsTheRoundingOfAFormat) {
    Volume rounded = some_ct();
    rounded.grid.spacing_mm = rounded.grid.spacing_mm.cast<float>().cast<double>();
    rounded.grid.origin_mm = rounded.grid.origin_mm.cast<float>().cast<double>();
    EXPECT_EQ(digest_of(rounded), digest_of(some_ct()));
}

// 12 million voxels in parts of 2 million.
TEST(ImageDigest, IsTheSameInPartsAndHearsACancelInEach) {
    Volume ct = some_ct();
    ct.grid.dims = {300, 200, 200};
    ct.voxels.assign(ct.grid.count(), -7);
    ct.voxels.back() = 11;
    int looks = 0;
    Job whole;
    whole.observe([&](JobEvent event) { looks += event == JobEvent::check; });
    EXPECT_EQ(digest_of(ct, whole), digest_of(ct));
    EXPECT_EQ(looks, 6);
    for (const int last : {1, 3, 6}) {
        int seen = 0;
        Job job;
        job.observe([&](JobEvent event) {
            if (event == JobEvent::check && ++seen == last) job.cancel();
        });
        EXPECT_THROW(digest_of(ct, job), Cancelled);
    }
}

}  // namespace
}  // namespace hepatica
