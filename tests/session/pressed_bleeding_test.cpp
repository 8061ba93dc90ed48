// SPDX-License-Identifier: GPL-3.0-or-later
// What a frame says of forceps that hold a vessel while another one, or the same, bleeds.
#include <gtest/gtest.h>

#include "tests/session/cut_vessel.h"
#include "tests/session/new_session.h"

namespace hepatica {
namespace {

using test::middle_of;
using test::of_portal_veins;
using test::play;
using test::small_patient;

// Of the two branches that leave the trunk, one is cut through.
constexpr int the_trunk = 0, cut_branch = 1, whole_branch = 2;

Vec3 along_middle_of(int segment) {
    const auto& points =
        small_patient()->tree.segments[static_cast<std::size_t>(segment)].points_mm;
    const std::size_t m = points.size() / 2;
    return (points[m + 1] - points[m - 1]).normalized();
}

Blade across_what_bleeds() {
    const Vec3 at = middle_of(small_patient()->tree, cut_branch);
    const Vec3 across = 12.0 * along_middle_of(cut_branch).unitOrthogonal();
    return {at - across, at + across};
}

// Forceps close around the middle of a vessel and hold it.
void close_forceps_around(Session& session, int segment) {
    const Vec3 along = along_middle_of(segment), from = along.unitOrthogonal();
    session.post(AddTool{"forceps", 1.5, 16.0, -from, middle_of(small_patient()->tree, segment),
                         along.cross(from)});
    for (int left = 30; left > 0; --left) {
        session.post(CloseForceps{1.0 / left});
        session.step();
    }
    play(session, 60);
}

// The trunk is on the way to what bleeds, the other branch is not.
TEST(PressedBleeding, AFrameTellsAHeldVesselThatFeedsTheBleedingFromAnother) {
    for (const int held : {the_trunk, whole_branch}) {
        SCOPED_TRACE(held);
        const auto session = of_portal_veins();
        session->post(UseTools{});
        session->post(across_what_bleeds());
        play(*session, 2);
        session->update_frame();
        ASSERT_TRUE(session->frame().tear);
        ASSERT_GT(session->frame().tear->leak_g_s, 0.0);
        EXPECT_EQ(session->frame().tear->open_share, 1.0) << "nothing presses yet";
        EXPECT_EQ(session->frame().tear->other_open_share, 1.0);
        EXPECT_EQ(session->frame().tear->other_segment, -1);
        close_forceps_around(*session, held);
        session->update_frame();
        ASSERT_EQ(session->frame().statistics.message, "");
        const TearView& tear = *session->frame().tear;
        const double pressed = held == the_trunk ? tear.open_share : tear.other_open_share;
        EXPECT_LT(pressed, 1.0);
        EXPECT_GT(pressed, 0.0);
        EXPECT_EQ(held == the_trunk ? tear.other_open_share : tear.open_share, 1.0);
        EXPECT_EQ(tear.other_segment, held == the_trunk ? -1 : whole_branch);
    }
}

}  // namespace
}  // namespace hepatica
