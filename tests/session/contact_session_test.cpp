// SPDX-License-Identifier: GPL-3.0-or-later
// Contact that is switched while a session plays: what comes is what a scene that had it from its
// beginning does, and all of it plays again.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "core/patient/patient_case.h"
#include "core/scene/deform_part.h"
#include "core/scene/world.h"
#include "core/scene/world_checkpoint.h"
#include "tests/session/new_session.h"
#include "tests/session/recorded.h"

namespace hepatica {
namespace {

using test::keep_recording;
using test::middle_of;
using test::new_session;
using test::play;
using test::small_patient;
using testing::HasSubstr;

SceneSpec moving(const std::optional<ContactSpec>& contact = {}) {
    SceneSpec spec = default_scene();
    spec.flow.reset();
    spec.contact = contact;
    return spec;
}

// Half a second in which a branch is pulled aside.
void pull(Session& session) {
    const Vec3 held = middle_of(small_patient()->tree, 1);
    session.post(GrabPoint{held});
    session.post(MoveGrab{held + Vec3(6, 4, 0), 0.3});
    play(session, 30);
}

// After a step.
const Frame& frame_of(Session& session) {
    session.update_frame();
    return session.frame();
}

TEST(ContactSession, VesselsThatTouchFromNowOnDoWhatAScenesDo) {
    const auto switched = new_session(moving());
    const auto of_scene =
        new_session(moving(ContactSpec{.tools = false, .self = true, .friction = 0.2}));
    const auto other =
        new_session(moving(ContactSpec{.tools = false, .self = true, .friction = 0.3}));
    pull(*switched);
    switched->post(UseContact{.self = true, .friction = 0.2});
    switched->step();
    EXPECT_EQ(frame_of(*switched).self_friction, 0.2);
    EXPECT_FALSE(switched->world().deform()->holding());
    of_scene->step();
    other->step();
    EXPECT_EQ(switched->state_hash(), of_scene->state_hash()) << "at rest again";
    for (Session* session : {switched.get(), of_scene.get(), other.get()}) pull(*session);
    EXPECT_EQ(switched->state_hash(), of_scene->state_hash());
    EXPECT_NE(switched->state_hash(), other->state_hash()) << "another friction is another play";
    switched->post(UseContact{.self = true, .friction = 0.2});
    switched->step();
    of_scene->step();
    EXPECT_EQ(switched->state_hash(), of_scene->state_hash()) << "nothing is new";
    switched->post(UseContact{.self = false});
    switched->step();
    EXPECT_FALSE(frame_of(*switched).self_friction);
    const auto plain = new_session(moving());
    plain->step();
    EXPECT_EQ(switched->state_hash(), plain->state_hash());
}

TEST(ContactSession, IsSwitchedInTheListOfParts) {
    const auto session = new_session(moving());
    const auto names = [&] {
        std::vector<std::string> found;
        for (const PartCost& part : session->world().parts()) found.push_back(part.name);
        return found;
    };
    using Names = std::vector<std::string>;
    EXPECT_EQ(names(), (Names{"shape", "deform"}));
    session->post(UseContact{});
    session->step();
    EXPECT_EQ(names(), (Names{"shape", "deform", "self-contact"}));
    EXPECT_GT(session->world().parts()[2].bytes, 0u);
    session->post(UseContact{.self = false});
    session->step();
    EXPECT_EQ(names(), (Names{"shape", "deform"}));
}

TEST(ContactSession, SaysWhatCannotBe) {
    const auto session = new_session(moving());
    session->post(UseContact{.self = true, .obstacles = true});
    session->step();
    EXPECT_THAT(frame_of(*session).statistics.message, HasSubstr("neither liver nor tumours"));
    EXPECT_TRUE(frame_of(*session).self_friction) << "the rest of it is done";
    EXPECT_FALSE(frame_of(*session).obstacles);
    session->post(UseContact{.self = true, .friction = -0.5});
    session->step();
    EXPECT_THAT(frame_of(*session).statistics.message,
                HasSubstr("Give a coefficient from 0 to 10"));
    EXPECT_EQ(frame_of(*session).self_friction, 0.0);
}

TEST(ContactSession, PlaysAgainFromItsStartAndFromItsKeyframes) {
    const auto session = new_session(moving());
    const auto recording = keep_recording(*session);
    play(*session, 560);
    session->post(UseContact{.self = true, .friction = 0.4});
    pull(*session);
    play(*session, 40);  // over the keyframe at 600
    session->post(RestoreSnapshot{});
    play(*session, 20);
    EXPECT_EQ(frame_of(*session).self_friction, 0.4);
    test::expect_to_play_again(*session, *recording, {620});
}

// A recording that begins amid a play has its keyframe alone to know what is touched.
TEST(ContactSession, GoesOnFromACheckpointWithObstacles) {
    auto patient = std::make_shared<PatientCase>(*small_patient());
    const Vec3 beside = middle_of(patient->tree, 1) + Vec3(0, 0, 14);
    Grid grid{{20, 20, 20}};
    grid.origin_mm = beside - Vec3::Constant(9.5);
    patient->organs = Mask(grid);
    for (std::size_t i = 0; i < patient->organs.voxels.size(); ++i) {
        const auto [x, y, z] = grid.index_of(i);
        if ((grid.to_mm(x, y, z) - beside).norm() <= 5.0)
            patient->organs.voxels[i] = organ_label::first_tumour;
    }
    Job job;
    World world(patient, moving(), job);
    EXPECT_TRUE(world.use_contact(true, true, 0.1));
    ASSERT_TRUE(world.deform()->body().obstacles);
    world.deform()->grab(middle_of(patient->tree, 1));
    world.deform()->move_grab(middle_of(patient->tree, 1) + Vec3(0, 0, 4));
    for (int i = 0; i < 10; ++i) world.step();
    World again(patient, moving(), job);
    again.restore(world_checkpoint_from_json(to_json(world.checkpoint())));
    EXPECT_EQ(again.state_hash(), world.state_hash());
    for (int i = 0; i < 5; ++i) {
        world.step();
        again.step();
    }
    EXPECT_EQ(again.state_hash(), world.state_hash());
    EXPECT_EQ(again.parts().size(), 4u);
    EXPECT_TRUE(world.use_contact(false, false, 0.0));
    EXPECT_EQ(world.deform()->body().obstacles, nullptr);
}

}  // namespace
}  // namespace hepatica
