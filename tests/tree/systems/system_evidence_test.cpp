// SPDX-License-Identifier: GPL-3.0-or-later
// Where the trunks are: the widest pieces about each anchor.
#include "core/tree/systems/system_evidence.h"

#include <gtest/gtest.h>

namespace hepatica {
namespace {

VesselPiece piece(const Vec3& centre_mm, double radius_mm) {
    VesselPiece one;
    one.centre_mm = centre_mm;
    one.radius_mm = radius_mm;
    return one;
}

// The hilum at the origin, the confluence 100 mm above it.
const AnatomicalAnchors anchors{Vec3::Zero(), Vec3(0, 0, 100)};

TEST(Trunks, AreTheWidestPiecesWithinThirtyMillimetresOfTheirAnchor) {
    const std::vector<VesselPiece> pieces{
        piece(Vec3(0, 0, 10), 5.0),   // portal: within four fifths of the widest
        piece(Vec3(0, 0, 29), 6.0),   // portal
        piece(Vec3(0, 0, 31), 9.0),   // too far away
        piece(Vec3(20, 0, 0), 4.7),   // too thin
        piece(Vec3(0, 0, 75), 4.0),   // hepatic
        piece(Vec3(0, 0, 104), 3.0),  // too thin
    };
    const Trunks trunks = trunks_at(pieces, anchors);
    EXPECT_EQ(trunks.portal, (std::vector<int>{0, 1}));
    EXPECT_EQ(trunks.hepatic, (std::vector<int>{4}));
}

// Where nothing is that near, all that are hardly farther away than the nearest count alike,
// whichever stands first.
TEST(Trunks, AreSoughtFartherAwayWhereNothingIsNear) {
    const std::vector<VesselPiece> pieces{
        piece(Vec3(-49, 0, 0), 2.0),  // hardly farther away than the nearest, but thin
        piece(Vec3(40, 0, 0), 5.0),   // the nearest
        piece(Vec3(0, 50, 0), 6.0),   // at the limit
        piece(Vec3(0, 50.1, 0), 8.0)};
    EXPECT_EQ(trunks_at(pieces, anchors).portal, (std::vector<int>{1, 2}));
}

}  // namespace
}  // namespace hepatica
