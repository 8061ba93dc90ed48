// SPDX-License-Identifier: GPL-3.0-or-later
// That the campaign of tears sees surfaces that have passed through each other.
#include "core/study/torn_crossings.h"

#include <gtest/gtest.h>

#include <functional>
#include <memory>
#include <span>
#include <vector>

#include "core/deform/stepper/cpu_stepper.h"
#include "core/deform/stepper/stepper_checkpoint.h"
#include "core/mesh/crossing_triangles.h"
#include "core/tear/tearing.h"
#include "tests/deform/support/two_bars.h"

namespace hepatica {
namespace {

// Two crossed bars, of which the upper one can be cut across its middle.
class TornCrossings : public testing::Test {
  protected:
    TornCrossings() {
        body_.tear.emplace();
        stepper_ = make_cpu_stepper(body_, {});
    }

    // Across the upper bar, from a height on upwards: it is of 3 to 7 mm.
    void cut_upper(double from_mm) {
        const Vec3 across = test::about_z(upper_angle_rad) * Vec3(0, 10, 0), up(0, 0, 5);
        stepper_->cut(Vec3(0.3, 0.2, from_mm) - 0.5 * across, across, up);
        ASSERT_GT(stepper_->positions_mm().size(), body_.mesh.vertices_mm.size());
    }
    // Where every vertex would be if the chosen ones had gone elsewhere, whatever is in their way.
    std::vector<Vec3> moved(const std::function<bool(std::size_t)>& chosen,
                            const Vec3& by_mm) const {
        const auto now = stepper_->positions_mm();
        std::vector<Vec3> then(now.begin(), now.end());
        for (std::size_t v = 0; v < then.size(); ++v)
            if (chosen(v)) then[v] += by_mm;
        return then;
    }
    int counted(std::span<const Vec3> positions_mm, bool apart = false) const {
        OverlapsKept kept = stepper_->checkpoint().self->overlaps;
        if (apart) kept.lying.clear();
        return torn_crossings(stepper_->tearing()->topology(), body_, positions_mm, kept);
    }
    int all(std::span<const Vec3> positions_mm) const {
        return static_cast<int>(
            crossing_triangles(stepper_->tearing()->topology().surface(), positions_mm).size());
    }

    static constexpr double upper_angle_rad = 1.4;
    BodyDescription body_ = test::crossed_bars(1.0, upper_angle_rad);
    std::unique_ptr<Stepper> stepper_;
};

TEST_F(TornCrossings, OfOneVesselThroughAnotherAreSeenBeforeAndAfterACut) {
    for (const bool cut : {false, true}) {
        if (cut) cut_upper(2.6);
        EXPECT_EQ(counted(stepper_->positions_mm()), 0);
        const auto of_upper = [&](std::size_t v) { return stepper_->positions_mm()[v].z() > 2.5; };
        const std::vector<Vec3> through = moved(of_upper, Vec3(0, 0, -2));
        EXPECT_EQ(counted(through), all(through) - all(stepper_->positions_mm()));
        EXPECT_GT(counted(through), 0);
    }
}

// A corner of a cut that goes half through, pressed into the side which it was one with.
TEST_F(TornCrossings, OfTheTwoSidesOfATearAreCountedOnceTheyHaveComeApart) {
    cut_upper(4.9);
    const Vec3 along = test::about_z(upper_angle_rad) * Vec3(0.05, 0, 0);
    const std::size_t split = body_.mesh.vertices_mm.size();
    int crossed = 0;
    for (const double way : {1.0, -1.0}) {
        const std::vector<Vec3> then =
            moved([&](std::size_t v) { return v == split; }, way * along);
        crossed += all(then);
        EXPECT_EQ(counted(then), 0);
        EXPECT_EQ(counted(then, true), all(then));
    }
    EXPECT_GT(crossed, 0);
}

}  // namespace
}  // namespace hepatica
