// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/deform/potentials/body_surfaces.h"

#include <gtest/gtest.h>

#include "core/base/error.h"
#include "core/deform/potentials/potential_list.h"
#include "tests/deform/support/obstacle_shapes.h"
#include "tests/deform/support/two_bars.h"

namespace hepatica {
namespace {

// Those of the body fit where those of the obstacles do not, and the other way round.
TEST(BodySurfaces, OverlapsThatDoNotFitChangeNothing) {
    BodyDescription bars = test::crossed_bars(1.0);
    bars.obstacles = test::one_obstacle(test::ball_surface(Vec3(0, 0, -8), 5.0));
    const Body body = build_body(bars, ElementModel::corotated, ElementOrder::linear);
    PotentialList potentials(body);
    const OverlapsKept before{{0, 1}, {}}, good{{0, 2}, {}}, bad{{-1, 0}, {}};
    potentials.surfaces().set_overlaps({before, before});
    for (const SurfacesKept& kept : {SurfacesKept{good, bad}, SurfacesKept{bad, good}}) {
        EXPECT_THROW(potentials.surfaces().set_overlaps(kept), InputError);
        EXPECT_EQ(potentials.surfaces().kept_overlaps().self->touching, before.touching);
        EXPECT_EQ(potentials.surfaces().kept_overlaps().obstacles->touching, before.touching);
    }
    potentials.surfaces().set_overlaps({good, good});
    EXPECT_EQ(potentials.surfaces().kept_overlaps().self->touching, good.touching);
    EXPECT_EQ(potentials.surfaces().kept_overlaps().obstacles->touching, good.touching);
}

TEST(BodySurfaces, OverlapsOfObstaclesThatAreNotThereChangeNothing) {
    const Body body =
        build_body(test::crossed_bars(1.0), ElementModel::corotated, ElementOrder::linear);
    PotentialList potentials(body);
    const OverlapsKept some{{0, 1}, {}};
    EXPECT_THROW(potentials.surfaces().set_overlaps({some, some}), InputError);
    EXPECT_TRUE(potentials.surfaces().kept_overlaps().self->touching.empty());
}

}  // namespace
}  // namespace hepatica
