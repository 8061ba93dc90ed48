// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/scene_spec.h"

#include <gtest/gtest.h>

#include <cmath>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "core/base/error.h"
#include "core/scene/deform_part.h"
#include "core/scene/flow_part.h"
#include "core/scene/world.h"
#include "tests/session/small_patient.h"
#include "tests/support/asked_to_stop.h"

namespace hepatica {
namespace {

using Json = nlohmann::ordered_json;
using test::small_patient;

std::vector<std::string> part_names(const World& world) {
    std::vector<std::string> names;
    for (const PartCost& part : world.parts()) names.push_back(part.name);
    return names;
}

TEST(World, BuildsOnlyWhatTheSceneNames) {
    Job job;
    SceneSpec drag;
    drag.flow.reset();
    World dragged(small_patient(), drag, job);
    EXPECT_EQ(part_names(dragged), (std::vector<std::string>{"shape", "deform"}));
    EXPECT_NE(dragged.deform(), nullptr);
    EXPECT_EQ(dragged.flow(), nullptr);

    SceneSpec flow;
    flow.deform.reset();
    World flowing(small_patient(), flow, job);
    EXPECT_EQ(part_names(flowing), (std::vector<std::string>{"shape", "flow"}));
    EXPECT_EQ(flowing.deform(), nullptr);
    EXPECT_NE(flowing.flow(), nullptr);
    EXPECT_EQ(flowing.vertex_count(), small_patient()->surface.vertices_mm.size());
}

TEST(World, HearsAStopWhereTheFlowAfterATearIsDue) {
    Job job;
    SceneSpec spec;
    spec.deform.reset();
    World world(small_patient(), spec, job);
    FlowPart& flow = *world.flow();
    flow.inject({.at = {0, 0.0, 0.0}});
    flow.set_time(0.25 * flow.drug().end_s);
    flow.follow_tears({ThroughTear{{0, 5.0, 0.0}, 3.0}});
    for (int left = flow.steps_to_update(); left > 1; --left) world.step();
    ASSERT_TRUE(flow.computing());
    EXPECT_THROW(world.step(test::asked_to_stop()), Cancelled);
}

TEST(World, AFlowSceneNeedsNoMesh) {
    PatientCase without_mesh = *small_patient();
    without_mesh.mesh = {};
    const auto patient = std::make_shared<const PatientCase>(without_mesh);
    Job job;
    SceneSpec flow;
    flow.deform.reset();
    EXPECT_NO_THROW(World(patient, flow, job));
    EXPECT_THROW(World(patient, default_scene(), job), InputError);
}

TEST(World, FindsThePlaceOnTheTreeInTheDeformedShape) {
    Job job;
    World world(small_patient(), default_scene(), job);
    const Vec3 held = test::middle_of(small_patient()->tree, 1);
    const int segment = world.place_near(held).segment;
    EXPECT_EQ(segment, 1);
    world.deform()->grab(held);
    world.deform()->move_grab(held + Vec3(0, 8, 0));
    for (int i = 0; i < 120; ++i) world.step();
    EXPECT_EQ(world.place_near(held + Vec3(0, 8, 0)).segment, 1);
}

TEST(SceneSpec, SurvivesJson) {
    SceneSpec spec = default_scene();
    spec.deform->fixed = FixedEnds::roots;
    spec.deform->tether_pa_per_mm2 = 12.5;
    spec.dt_s = 0.01;
    const SceneSpec back = scene_from_json(Json::parse(to_json(spec).dump()));
    EXPECT_EQ(to_json(back).dump(), to_json(spec).dump());
    spec.flow.reset();
    EXPECT_FALSE(scene_from_json(to_json(spec)).flow.has_value());
}

TEST(SceneSpec, RefusesMisspeltAndImpossibleScenes) {
    for (const char* text :
         {R"({})", R"({"deform": {"qualty": 1}})", R"({"deform": {"quality": 3}})",
          R"({"deform": {"fixed": "some"}})", R"({"deform": 3})", R"({"contact": {}})",
          R"({"flow": {}, "dt_s": 0})", R"({"flow": {"drug_speed": "fast"}})"})
        EXPECT_THROW(scene_from_json(Json::parse(text)), InputError) << text;
}

TEST(SceneSpec, NumbersMayLieOnTheirBounds) {
    for (const double quality : {0.0, 1.0})
        EXPECT_EQ(scene_from_json(Json{{"deform", {{"quality", quality}}}}).deform->quality,
                  quality);
    for (const double dt_s : {1e-4, 1.0})
        EXPECT_EQ(scene_from_json(Json{{"flow", Json::object()}, {"dt_s", dt_s}}).dt_s, dt_s);
    for (const double dt_s : {0.99e-4, 1.01})
        EXPECT_THROW(scene_from_json(Json{{"flow", Json::object()}, {"dt_s", dt_s}}), InputError);
}

TEST(SceneFile, NamesItsCaseRelativeToItself) {
    const auto folder = std::filesystem::path(testing::TempDir()) / "scenes";
    std::filesystem::create_directories(folder);
    std::ofstream(folder / "a.json") << R"({"case": "p.hep", "flow": {}})";
    const SceneFile scene = read_scene(folder / "a.json");
    EXPECT_EQ(scene.patient, folder / "p.hep");
    EXPECT_FALSE(scene.spec.deform.has_value());
    for (const char* text : {"", "text", "{}", R"({"case": 3})", R"({"case": "p", "fly": {}})"}) {
        std::ofstream(folder / "bad.json") << text;
        EXPECT_THROW(read_scene(folder / "bad.json"), InputError) << text;
    }
    EXPECT_THROW(read_scene(folder / "missing.json"), InputError);
    for (const char* text : {"{\"case\":\n1e400}", "{\"case\":\nNaN}"}) {
        std::ofstream(folder / "bad.json") << text;
        try {
            read_scene(folder / "bad.json");
            ADD_FAILURE() << text;
        } catch (const InputError& error) {
            EXPECT_EQ(error.place(), (folder / "bad.json").string());
            EXPECT_NE(error.problem().find("line 2, column"), std::string::npos) << error.what();
        }
    }
    std::filesystem::remove_all(folder);
}

TEST(DeformPart, AHollowWallGivesWayWhereASolidVesselDoesNot) {
    const auto held = [](double wall_mm) {
        DeformSpec spec;
        spec.wall_mm = wall_mm;
        spec.tether_pa_per_mm2 = 0.0;
        spec.gravity_mm_per_s2 = Vec3(0, 9810, 0);
        DeformPart part(*small_patient(), spec);
        for (int i = 0; i < 60; ++i) part.step(1.0 / 60.0);
        double sag_mm = 0.0;
        const auto& rest = small_patient()->mesh.vertices_mm;
        for (std::size_t v = 0; v < rest.size(); ++v)
            sag_mm = std::max(sag_mm, (part.positions_mm()[v] - rest[v]).norm());
        return sag_mm;
    };
    const double solid_mm = held(0.0);
    EXPECT_GT(held(0.1), 1.2 * solid_mm);
    EXPECT_DOUBLE_EQ(held(50.0), solid_mm);  // thicker than the radius is solid
}

TEST(SceneSpec, NamesTheWall) {
    SceneSpec spec = default_scene();
    EXPECT_FALSE(to_json(spec)["deform"].contains("wall_mm"));
    spec.deform->wall_mm = 0.4;
    EXPECT_EQ(scene_from_json(to_json(spec)).deform->wall_mm, 0.4);
    EXPECT_THROW(scene_from_json(Json{{"deform", {{"wall_mm", -1}}}}), InputError);
}

TEST(DeformPart, TheHandPullsInProportionToItsWayAndNotAtAllWhereItTookHold) {
    DeformPart part(*small_patient(), {});
    const Vec3 held = test::middle_of(small_patient()->tree, 1);
    part.grab(held);
    EXPECT_NEAR(part.grab_view()->force_un, 0.0, 1e-6);
    EXPECT_FALSE(part.grab_view()->at_limit);
    const Vec3 from = part.grab_view()->point_mm;
    std::vector<double> force;
    for (const double way_mm : {0.001, 0.002, 9e3}) {
        part.move_grab(from + Vec3(0, way_mm, 0));
        EXPECT_LT((part.grab_view()->point_mm - from).norm(), 1e-9) << "nothing has moved yet";
        force.push_back(part.grab_view()->force_un);
    }
    EXPECT_GT(force[0], 0.0);
    EXPECT_NEAR(force[1] / force[0], 2.0, 1e-6);
    EXPECT_TRUE(part.grab_view()->at_limit);
    EXPECT_LT(force[2], 1e6 * force[0]);
}

TEST(DeformPart, RefusesAWallThatIsNone) {
    DeformPart part(*small_patient(), {});
    for (const double wall_mm : {-0.5, 1e-9, 101.0, HUGE_VAL, -HUGE_VAL, std::nan("")}) {
        DeformSpec spec;
        spec.wall_mm = wall_mm;
        EXPECT_THROW(DeformPart(*small_patient(), spec), InputError) << wall_mm;
        EXPECT_THROW(part.set_wall(wall_mm), InputError) << wall_mm;
        EXPECT_TRUE(part.body().stiffness_factor.empty());
    }
    part.set_wall(thickest_wall_mm);
    part.set_wall(thinnest_wall_mm);
    EXPECT_LT(part.body().stiffness_factor.front(), 0.1);
    part.set_wall(0.0);
    EXPECT_TRUE(part.body().stiffness_factor.empty());
}

TEST(Scene, TakesWholeVertexBudgetsAlone) {
    const auto read = [](const std::string& budget) {
        return tear_from_json(
            Json::parse(R"({"stop": "vertices", "vertex_budget": )" + budget + "}"));
    };
    EXPECT_EQ(read("7").vertex_budget, 7);
    EXPECT_EQ(read("7.0").vertex_budget, 7);
    for (const char* budget : {"2.9", "true", "1e12", "1e300", "3000000000", "-1", "\"7\""})
        EXPECT_THROW(read(budget), InputError) << budget;
    try {
        read("1e12");
    } catch (const InputError& error) {
        EXPECT_NE(error.problem().find("wrong kind"), std::string::npos) << error.problem();
    }
}

TEST(DeformPart, RefusesAMaterialThatNobodyKnows) {
    DeformSpec spec;
    spec.material = "unobtainium";
    EXPECT_THROW(DeformPart(*small_patient(), spec), InputError);
}

}  // namespace
}  // namespace hepatica
