// SPDX-License-Identifier: GPL-3.0-or-later
// Phantoms whose systems touch: as often as was asked for, nowhere else, and on the same tree.
#include "core/phantom/phantom_contacts.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/error.h"
#include "core/phantom/phantom.h"

namespace hepatica {
namespace {

constexpr auto portal = VascularSystem::portal, hepatic = VascularSystem::hepatic;

PhantomOptions options_of(int seed, int touching) {
    PhantomOptions options;
    options.seed = static_cast<std::uint64_t>(seed);
    options.systems = 2;
    options.generations = 6;
    options.touching = touching;
    options.dims = {128, 128, 96};
    options.spacing_mm = Vec3(1.6, 1.6, 1.7);
    return options;
}

Phantom made_touching(const PhantomOptions& options) {
    Job job;
    return make_phantom(options, job);
}

struct Gap {
    double mm = std::numeric_limits<double>::infinity();  // between the walls; negative: overlap
    Vec3 place = Vec3::Zero();
};

Gap gap_between(const VesselSegment& a, const VesselSegment& b) {
    Gap gap;
    for (std::size_t p = 0; p < a.points_mm.size(); ++p)
        for (std::size_t q = 0; q < b.points_mm.size(); ++q) {
            const double mm =
                (a.points_mm[p] - b.points_mm[q]).norm() - a.radii_mm[p] - b.radii_mm[q];
            if (mm < gap.mm) gap = {mm, 0.5 * (a.points_mm[p] + b.points_mm[q])};
        }
    return gap;
}

class TouchingSystems : public testing::TestWithParam<int> {};
INSTANTIATE_TEST_SUITE_P(Seeds, TouchingSystems, testing::Range(1, 6));

// Each contact is a pair of segments of its own whose lumens overlap, and no other pair overlaps.
TEST_P(TouchingSystems, TouchAsOftenAsAskedAndNowhereElse) {
    const Phantom phantom = made_touching(options_of(GetParam(), 5));
    ASSERT_NO_THROW(validate(phantom.tree));
    ASSERT_EQ(phantom.contacts_mm.size(), 5u);
    int overlaps = 0;
    for (const VesselSegment& a : phantom.tree.segments)
        for (const VesselSegment& b : phantom.tree.segments) {
            if (a.system != hepatic || b.system != portal) continue;
            const Gap gap = gap_between(a, b);
            if (gap.mm >= 0.0) continue;
            ++overlaps;
            // Where the walls overlap most is where the contact was said to be.
            double away_mm = std::numeric_limits<double>::infinity();
            for (const Vec3& contact : phantom.contacts_mm)
                away_mm = std::min(away_mm, (contact - gap.place).norm());
            EXPECT_LT(away_mm, 6.0);
            // Neither axis lies deep in the other lumen.
            for (const Vec3& p : a.points_mm)
                for (std::size_t k = 0; k < b.points_mm.size(); ++k)
                    EXPECT_GT((p - b.points_mm[k]).norm(), 0.85 * b.radii_mm[k]);
        }
    EXPECT_EQ(overlaps, 5);
}

// Nodes, radii and the number of points are those of the phantom that was not bent; so are all
// portal veins.
TEST_P(TouchingSystems, KeepTheTree) {
    const VesselTree bent = made_touching(options_of(GetParam(), 5)).tree;
    const VesselTree straight = made_touching(options_of(GetParam(), 0)).tree;
    ASSERT_EQ(bent.segments.size(), straight.segments.size());
    int moved = 0;
    for (std::size_t i = 0; i < bent.segments.size(); ++i) {
        const VesselSegment& a = bent.segments[i];
        const VesselSegment& b = straight.segments[i];
        EXPECT_EQ(a.radii_mm, b.radii_mm);
        EXPECT_EQ(a.proximal_node, b.proximal_node);
        EXPECT_EQ(a.points_mm.front(), b.points_mm.front());
        EXPECT_EQ(a.points_mm.back(), b.points_mm.back());
        if (a.points_mm == b.points_mm) continue;
        ++moved;
        EXPECT_EQ(a.system, hepatic);
        for (std::size_t k = 2; k < a.points_mm.size(); ++k)  // no kinks
            EXPECT_GT((a.points_mm[k] - a.points_mm[k - 1])
                          .normalized()
                          .dot((a.points_mm[k - 1] - a.points_mm[k - 2]).normalized()),
                      0.6);
    }
    EXPECT_EQ(moved, 5);
}

// Every voxel of the mask belongs to the system whose wall it lies deeper in; no HU lies beyond
// those of the two systems.
TEST_P(TouchingSystems, ShareVoxelsByWhatFillsThem) {
    PhantomOptions options = options_of(GetParam(), 5);
    options.noise_hu = 0.0;
    options.point_spread_sigma_mm = 0.0;
    options.hepatic_contrast_hu = 50.0;  // below 65
    const Phantom phantom = made_touching(options);
    const Grid& grid = phantom.ct.grid;
    for (const Vec3& contact : phantom.contacts_mm) {
        int of_portal = 0, of_hepatic = 0;
        const Vec3 at = grid.to_index(contact);
        for (int z = -3; z <= 3; ++z)
            for (int y = -3; y <= 3; ++y)
                for (int x = -3; x <= 3; ++x) {
                    const Index3 i{static_cast<int>(std::lround(at.x())) + x,
                                   static_cast<int>(std::lround(at.y())) + y,
                                   static_cast<int>(std::lround(at.z())) + z};
                    ASSERT_TRUE(grid.contains(i[0], i[1], i[2]));
                    const std::uint8_t label = phantom.vessels.at(i[0], i[1], i[2]);
                    of_portal += label == static_cast<int>(portal);
                    of_hepatic += label == static_cast<int>(hepatic);
                    if (label == 0) continue;
                    EXPECT_LE(phantom.ct.at(i[0], i[1], i[2]), 175);
                }
        EXPECT_GT(of_portal, 0);
        EXPECT_GT(of_hepatic, 0);
    }
}

TEST(TouchingSystemsOptions, MoreContactsKeepThoseBefore) {
    const Phantom few = made_touching(options_of(3, 2)), many = made_touching(options_of(3, 5));
    EXPECT_EQ(few.contacts_mm[0], many.contacts_mm[0]);
    EXPECT_EQ(few.contacts_mm[1], many.contacts_mm[1]);
}

TEST(TouchingSystemsOptions, SetTheContrastOfHepaticVeins) {
    PhantomOptions options = options_of(1, 0);
    options.noise_hu = 0.0;
    options.hepatic_contrast_hu = 61.0;
    const Phantom phantom = made_touching(options);
    std::int16_t brightest = 0;
    for (std::size_t i = 0; i < phantom.vessels.voxels.size(); ++i)
        if (phantom.vessels.voxels[i] == static_cast<int>(hepatic))
            brightest = std::max(brightest, phantom.ct.voxels[i]);
    EXPECT_NEAR(brightest, 110 + 61, 1);
    // What was the default stays it.
    options.hepatic_contrast_hu = 0.85 * options.contrast_hu;
    const Phantom stated = made_touching(options);
    options.hepatic_contrast_hu.reset();
    EXPECT_EQ(stated.ct.voxels, made_touching(options).ct.voxels);
}

TEST(TouchingSystemsOptions, ThatCannotBeMetAreRefused) {
    PhantomOptions options = options_of(1, 3);
    options.systems = 1;
    EXPECT_THROW(made_touching(options), InputError);
    options = options_of(1, 20);
    options.generations = 2;
    EXPECT_THROW(made_touching(options), InputError);  // four ends a system have no room for twenty
    options = options_of(1, 21);
    EXPECT_THROW(made_touching(options), InputError);
    options = options_of(1, 0);
    options.hepatic_contrast_hu = -1.0;
    EXPECT_THROW(made_touching(options), InputError);
}

}  // namespace
}  // namespace hepatica
