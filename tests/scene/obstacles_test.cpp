// SPDX-License-Identifier: GPL-3.0-or-later
// Obstacles of a scene: surfaces of the case's organs, asked for or not, what the part costs, and
// that vessels of a world touch them.
#include "core/scene/obstacles_of_organs.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "core/base/error.h"
#include "core/base/units.h"
#include "core/mesh/surface.h"
#include "core/scene/crossings.h"
#include "core/scene/deform_part.h"
#include "core/scene/level_surface.h"
#include "core/scene/world.h"
#include "tests/session/small_patient.h"
#include "tests/support/enclosed_volume.h"

namespace hepatica {
namespace {

using Json = nlohmann::ordered_json;
using test::small_patient;
using testing::HasSubstr;

// Labels balls on a grid around them; later ones over earlier ones.
struct Ball {
    Vec3 centre_mm;
    double radius_mm;
    std::uint8_t label;
};

Mask organs_with(const std::vector<Ball>& balls, const Vec3& spacing_mm, bool left_handed = false) {
    Eigen::AlignedBox3d box;
    for (const Ball& ball : balls)
        for (const double side : {-1.0, 1.0})
            box.extend(ball.centre_mm + side * Vec3::Constant(ball.radius_mm + 5.0));
    Grid grid;
    grid.spacing_mm = spacing_mm;
    if (left_handed) grid.direction.col(0) = -grid.direction.col(0);
    grid.origin_mm = box.min();
    if (left_handed) grid.origin_mm.x() = box.max().x();
    for (std::size_t c = 0; c < 3; ++c)
        grid.dims[c] =
            static_cast<int>(box.sizes()[static_cast<int>(c)] / spacing_mm[static_cast<int>(c)]) +
            1;
    Mask organs(grid);
    for (std::size_t i = 0; i < organs.voxels.size(); ++i) {
        const auto [x, y, z] = grid.index_of(i);
        for (const Ball& ball : balls)
            if ((grid.to_mm(x, y, z) - ball.centre_mm).norm() <= ball.radius_mm)
                organs.voxels[i] = ball.label;
    }
    return organs;
}

TEST(LevelSurface, OfABallIsClosedRoundAndTurnedOutwards) {
    for (const bool left_handed : {false, true}) {
        Grid grid;
        grid.dims = {24, 26, 28};
        grid.spacing_mm = Vec3(1.0, 0.9, 0.8);
        if (left_handed) grid.direction.col(2) = -grid.direction.col(2);
        FloatVolume share(grid);
        const Vec3 centre = grid.to_mm(Vec3(11.7, 12.6, 13.9));
        for (std::size_t i = 0; i < share.voxels.size(); ++i) {
            const auto [x, y, z] = grid.index_of(i);
            const double inside = 8.0 - (grid.to_mm(x, y, z) - centre).norm();
            share.voxels[i] = static_cast<float>(std::clamp(0.5 + 0.3 * inside, 0.0, 1.0));
        }
        const TriangleMesh surface = level_surface(share);
        EXPECT_NO_THROW(validate_closed(surface));
        const double volume = 4.0 / 3.0 * M_PI * 512.0;
        EXPECT_NEAR(test::enclosed_volume_mm3(surface), volume, 0.02 * volume);
        double shortest = INFINITY;  // area of a triangle
        for (const Vec3& x : surface.vertices_mm) EXPECT_NEAR((x - centre).norm(), 8.0, 0.15);
        for (const auto& [a, b, c] : surface.triangles) {
            const auto& x = surface.vertices_mm;
            shortest = std::min(shortest, (x[b] - x[a]).cross(x[c] - x[a]).norm() / 2.0);
        }
        EXPECT_GT(shortest, 1e-3);
    }
}

TEST(LevelSurface, OfNothingIsEmpty) {
    Grid grid;
    grid.dims = {4, 4, 4};
    EXPECT_TRUE(level_surface(FloatVolume(grid)).triangles.empty());
}

TEST(ObstaclesOfOrgans, AreTheLiverAndEachTumour) {
    for (const bool left_handed : {false, true}) {
        const Mask organs = organs_with({{Vec3(0, 0, 0), 30.0, organ_label::liver},
                                         {Vec3(5, 0, 0), 6.0, organ_label::first_tumour},
                                         {Vec3(-12, 3, 0), 4.0, organ_label::first_tumour + 4},
                                         {Vec3(0, -20, 0), 5.0, organ_label::cava}},
                                        Vec3(1.0, 1.0, 1.5), left_handed);
        const std::vector<Obstacle> found = obstacles_in(organs);
        ASSERT_EQ(found.size(), 3u);
        EXPECT_EQ(found[0].kind, SurfaceKind::shell);
        const double radii[] = {30.0, 6.0, 4.0};
        const Vec3 centres[] = {Vec3::Zero(), Vec3(5, 0, 0), Vec3(-12, 3, 0)};
        for (std::size_t i = 0; i < 3; ++i) {
            if (i > 0) {
                EXPECT_EQ(found[i].kind, SurfaceKind::solid);
            }
            EXPECT_NO_THROW(validate(Obstacles{{found[i]}}));
            const double volume = 4.0 / 3.0 * M_PI * std::pow(radii[i], 3);
            // The vena cava is no liver, but its hole is filled.
            EXPECT_NEAR(test::enclosed_volume_mm3(found[i].surface), volume, 0.2 * volume) << i;
            for (const Vec3& x : found[i].surface.vertices_mm)
                EXPECT_NEAR((x - centres[i]).norm(), radii[i], 1.0) << i;
        }
        EXPECT_LT(found[0].surface.triangles.size(), 4000u);
    }
    EXPECT_TRUE(obstacles_in(Mask()).empty());
    EXPECT_TRUE(
        obstacles_in(organs_with({{Vec3::Zero(), 9.0, organ_label::cava}}, Vec3::Constant(1.0)))
            .empty());
}

// A tumour of one voxel has the surface of its voxel.
TEST(ObstaclesOfOrgans, ATinyTumourIsThere) {
    Grid grid;
    grid.dims = {9, 9, 9};
    Mask organs(grid);
    organs.at(4, 4, 4) = organ_label::first_tumour;
    const std::vector<Obstacle> found = obstacles_in(organs);
    ASSERT_EQ(found.size(), 1u);
    EXPECT_GT(test::enclosed_volume_mm3(found[0].surface), 0.01);
}

// A grid that is cut off at the organ: the surface is closed there.
TEST(ObstaclesOfOrgans, AreClosedWhereTheGridEnds) {
    Grid grid;
    grid.dims = {12, 9, 7};
    Mask organs(grid);
    std::ranges::fill(organs.voxels, organ_label::first_tumour);
    organs.at(0, 0, 0) = 0;
    const std::vector<Obstacle> found = obstacles_in(organs);
    ASSERT_EQ(found.size(), 1u);
    EXPECT_NO_THROW(validate_closed(found[0].surface));
    EXPECT_GT(test::enclosed_volume_mm3(found[0].surface), 400.0);
}

std::shared_ptr<PatientCase> patient_with(const Mask& organs) {
    auto patient = std::make_shared<PatientCase>(*small_patient());
    patient->organs = organs;
    return patient;
}

// Beside the middle of a segment, at a distance from its wall.
Ball tumour_beside(int segment, double gap_mm, double radius_mm) {
    const VesselSegment& vessel = small_patient()->tree.segments[segment];
    const std::size_t middle = vessel.points_mm.size() / 2;
    const Vec3 along = (vessel.points_mm[middle + 1] - vessel.points_mm[middle - 1]).normalized();
    const Vec3 aside = along.unitOrthogonal();
    return {vessel.points_mm[middle] + (vessel.radii_mm[middle] + gap_mm + radius_mm) * aside,
            radius_mm, organ_label::first_tumour};
}

SceneSpec scene_with(const char* contact) {
    return scene_from_json(
        Json::parse(std::string(R"({"deform": {}, "contact": )") + contact + "}"));
}

std::vector<std::string> names_of_parts(const World& world) {
    std::vector<std::string> names;
    for (const PartCost& part : world.parts()) names.push_back(part.name);
    return names;
}

TEST(ObstaclesOfAScene, AreBuiltWhereTheyAreNamed) {
    const auto patient =
        patient_with(organs_with({tumour_beside(1, 3.0, 5.0)}, Vec3::Constant(0.8)));
    Job job;
    using Names = std::vector<std::string>;
    World only(patient, scene_with(R"({"obstacles": true})"), job);
    EXPECT_EQ(names_of_parts(only), (Names{"shape", "deform", "obstacles"}));
    EXPECT_FALSE(only.deform()->touchable());
    EXPECT_FALSE(only.deform()->body().self);
    only.step();
    EXPECT_GT(only.parts()[2].bytes, 1000u);
    EXPECT_GT(only.parts()[2].build_ms, 0.0);
    World all(patient, scene_with("{}"), job);
    EXPECT_EQ(names_of_parts(all), (Names{"shape", "deform", "self-contact", "obstacles"}));
    World none(patient, scene_with(R"({"tools": true, "obstacles": false})"), job);
    EXPECT_EQ(names_of_parts(none), (Names{"shape", "deform"}));
    EXPECT_FALSE(none.deform()->body().obstacles);
}

TEST(ObstaclesOfAScene, ACaseWithoutThemIsRefusedWhereTheyAreDemanded) {
    Job job;
    const World asked(small_patient(), scene_with("{}"), job);
    EXPECT_EQ(names_of_parts(asked), (std::vector<std::string>{"shape", "deform", "self-contact"}));
    try {
        const World demanded(small_patient(), scene_with(R"({"obstacles": true})"), job);
        FAIL();
    } catch (const InputError& error) {
        EXPECT_THAT(error.what(), HasSubstr("neither a liver nor a tumour"));
        EXPECT_THAT(error.what(), HasSubstr(R"("obstacles": true)"));
    }
    // Read without voxels, a case says which file it looked in.
    const auto folder = std::filesystem::path(testing::TempDir()) / "no_organs.hep";
    write_case(folder, *small_patient());
    const auto read = std::make_shared<const PatientCase>(read_case_without_voxels(folder));
    try {
        const World demanded(read, scene_with(R"({"obstacles": true})"), job);
        FAIL();
    } catch (const InputError& error) {
        EXPECT_THAT(error.what(), HasSubstr((folder / "organs.nii.gz").string()));
    }
}

TEST(ObstaclesOfAScene, AreReadFromTheCaseWhereVoxelsWereNot) {
    const auto folder = std::filesystem::path(testing::TempDir()) / "organs.hep";
    const auto patient =
        patient_with(organs_with({tumour_beside(1, 3.0, 5.0)}, Vec3::Constant(0.8)));
    write_case(folder, *patient);
    const auto read = std::make_shared<const PatientCase>(read_case_without_voxels(folder));
    ASSERT_TRUE(read->organs.voxels.empty());
    Job job;
    const SceneSpec spec = scene_with("{}");
    const World world(read, spec, job), whole(patient, spec, job);
    ASSERT_TRUE(world.deform()->body().obstacles);
    EXPECT_EQ(world.deform()->body().obstacles->all.front().surface.triangles,
              whole.deform()->body().obstacles->all.front().surface.triangles);
}

TEST(ObstaclesOfAScene, SurviveJson) {
    for (const char* text :
         {"{}", R"({"tools":true,"self":false,"obstacles":true})", R"({"tools":false,"self":true})",
          R"({"friction":0.3})", R"({"tools":false,"self":true,"friction":0.25})"})
        EXPECT_EQ(to_json(scene_with(text))["contact"].dump(), text);
    EXPECT_EQ(scene_with("{}").contact->obstacles, WantedObstacles::known);
    EXPECT_EQ(scene_with(R"({"obstacles": true})").contact->obstacles, WantedObstacles::required);
    EXPECT_FALSE(scene_with(R"({"obstacles": true})").contact->tools);
    EXPECT_TRUE(scene_with(R"({"friction": 0.3})").contact->all());
    EXPECT_EQ(scene_with("{}").contact->friction, 0.0);
}

// A box that is unticked in the lesson editor does not turn "those that there are" into a demand.
TEST(ObstaclesOfAScene, AreReadAsTheyWereWritten) {
    for (const bool tools : {false, true})
        for (const bool self : {false, true})
            for (const auto wanted :
                 {WantedObstacles::none, WantedObstacles::known, WantedObstacles::required}) {
                SceneSpec scene = scene_with("{}");
                scene.contact = ContactSpec{.tools = tools, .self = self, .obstacles = wanted};
                const std::string text = to_json(scene)["contact"].dump();
                const SceneSpec read = scene_with(text.c_str());
                EXPECT_EQ(read.contact->obstacles, wanted) << text;
                EXPECT_EQ(read.contact->tools, tools) << text;
                EXPECT_EQ(read.contact->self, self) << text;
            }
    for (const char* text : {R"({"obstacles": "all"})", R"({"obstacles": null})"})
        EXPECT_THROW(scene_with(text), InputError) << text;
}

TEST(ContactOfAScene, GivesVesselsTheirFriction) {
    Job job;
    const World rubs(small_patient(), scene_with(R"({"self": true, "friction": 0.3})"), job);
    EXPECT_EQ(rubs.deform()->body().self->friction, 0.3);
    const World slides(small_patient(), scene_with(R"({"self": true})"), job);
    EXPECT_EQ(slides.deform()->body().self->friction, 0.0);
    for (const char* text :
         {R"({"tools": true, "friction": 0.3})", R"({"self": true, "friction": -1})",
          R"({"self": true, "friction": "much"})"})
        EXPECT_THROW(scene_with(text), InputError) << text;
}

// Other organs, another play: a recording says so at its first step.
TEST(ObstaclesOfAScene, AreInTheHashOfTheState) {
    Job job;
    const SceneSpec spec = scene_with(R"({"obstacles": true})");
    const auto hash_beside = [&](double gap_mm) {
        const auto patient =
            patient_with(organs_with({tumour_beside(1, gap_mm, 5.0)}, Vec3::Constant(0.8)));
        return World(patient, spec, job).state_hash();
    };
    EXPECT_EQ(hash_beside(3.0), hash_beside(3.0));
    EXPECT_NE(hash_beside(3.0), hash_beside(4.0));
}

// A branch is pulled into the tumour beside it.
TEST(ObstaclesOfAScene, AreTouchedAndNotEntered) {
    const Ball tumour = tumour_beside(1, 1.5, 5.0);
    const auto patient = patient_with(organs_with({tumour}, Vec3::Constant(0.8)));
    Job job;
    World world(patient, scene_with(R"({"self": true, "obstacles": true})"), job);
    const Vec3 held = test::middle_of(patient->tree, 1);
    world.deform()->grab(held);
    int contacts = 0;
    for (int k = 0; k < 120; ++k) {
        if (k < 60) world.deform()->move_grab(held + (k + 1) / 60.0 * (tumour.centre_mm - held));
        contacts = std::max(contacts, world.step().obstacles.touch.contacts);
        if (k % 20 == 0) {
            ASSERT_EQ(crossing_pairs(*world.deform()), 0) << k;
        }
    }
    EXPECT_GT(contacts, 3);
    EXPECT_EQ(crossing_pairs(*world.deform()), 0);
    for (std::size_t v = 0; v < world.vertex_count(); ++v)
        EXPECT_GT((world.vertex_mm(static_cast<int>(v)) - tumour.centre_mm).norm(), 4.2);
}

// Its weight, tripled, lays a branch onto the tumour beside it.
TEST(ObstaclesOfAScene, AreSleptOn) {
    const Ball tumour = tumour_beside(1, 0.2, 5.0);
    const auto patient = patient_with(organs_with({tumour}, Vec3::Constant(0.8)));
    Job job;
    World world(patient, scene_with(R"({"obstacles": true})"), job);
    const Vec3 held = test::middle_of(patient->tree, 1);
    world.deform()->set_gravity(3.0 * units::standard_gravity *
                                (tumour.centre_mm - held).normalized());
    StepReport last;
    for (int k = 0; k < 900 && !last.asleep; ++k) last = world.step();
    EXPECT_TRUE(last.asleep);
    EXPECT_GT(last.obstacles.touch.contacts, 0);
    EXPECT_EQ(crossing_pairs(*world.deform()), 0);
}

// A probe that comes towards the vessel from behind the tumour is stopped by it; from the other
// side it comes to the vessel. Led on into the tumour from there it stays out.
TEST(ObstaclesOfAScene, StopATool) {
    const Ball tumour = tumour_beside(1, 6.0, 5.0);
    const auto patient = patient_with(organs_with({tumour}, Vec3::Constant(0.8)));
    Job job;
    World world(patient, scene_with(R"({"tools": true, "obstacles": true})"), job);
    DeformPart& body = *world.deform();
    const Vec3 place = test::middle_of(patient->tree, 1);
    const Vec3 way = (place - tumour.centre_mm).normalized();
    body.add_tool({"sphere", 1.0, 0.0, way, {}}, place);
    EXPECT_NEAR((body.tool()->centre_mm() - tumour.centre_mm).dot(way), -6.1, 0.5);
    EXPECT_EQ(body.tool_view()->force_un, Vec3(Vec3::Zero()));
    for (int k = 0; k < 60; ++k) {
        body.lead_tool(tumour.centre_mm + 0.1 * k * way);
        world.step();
        ASSERT_GT((body.tool()->centre_mm() - tumour.centre_mm).norm(), 5.5) << k;
        EXPECT_LT(body.tool_view()->force_un.dot(way), 0.0) << k;
    }
}

}  // namespace
}  // namespace hepatica
