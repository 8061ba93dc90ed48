// SPDX-License-Identifier: GPL-3.0-or-later
// A session whose steps a device makes, here the emulated one: on the dial beside the processor,
// and lost in mid-play.
#include <gtest/gtest.h>

#include <memory>
#include <string>

#include "core/base/frame_time.h"
#include "core/mesh/brick_mesh.h"
#include "core/scene/deform_part.h"
#include "core/scene/measured_dial.h"
#include "core/scene/world.h"
#include "core/session/replay.h"
#include "tests/session/new_session.h"
#include "tests/session/recorded.h"
#include "tests/support/emulated_back_end.h"

namespace hepatica {
namespace {

using test::emulated_back_end;
using test::EmulatedBackEnd;
using test::keep_recording;
using test::middle_of;
using test::play;
using test::small_patient;

void pull_trunk(Session& session) {
    session.post(GrabPoint{middle_of(small_patient()->tree, 0)});
    session.post(MoveGrab{middle_of(small_patient()->tree, 0) + Vec3(5, 0, 0)});
}

const FrameStatistics& figures(Session& session) {
    session.update_frame();
    return session.frame().statistics;
}

// The processor's setting is the cheaper, the device's the more accurate.
std::shared_ptr<const PatientCase> patient_with_both(const DeformBackEnd& device) {
    auto patient = std::make_shared<PatientCase>(*small_patient());
    StepperOptions two;
    two.substeps = 2;
    patient->dial_json = dial_json(
        {{{}, 1.0, 0.2, "this body"}, {two, 2.0, 0.1, "this body", device.name, device.device}},
        *patient);
    return patient;
}

TEST(DeviceSession, PlaysEachSettingOfTheDialWhereItWasMeasured) {
    const EmulatedBackEnd device = emulated_back_end();
    DeformBackEnd both = device.back_end;
    both.beside_processor = true;
    const auto patient = patient_with_both(both);
    Job job;
    Session session(patient, default_scene(), job, both);
    const auto recording = keep_recording(session);
    session.post(SetQuality{1.0});
    pull_trunk(session);
    play(session, 5);
    EXPECT_EQ(figures(session).device, both.device);
    EXPECT_EQ(figures(session).expected_error, 0.1);
    const long steps = device.device_steps();
    EXPECT_GE(steps, 5);

    const BodyState before = session.world().deform()->state();
    session.post(SetPaused{true});
    session.post(SetQuality{0.0});
    session.step();
    EXPECT_EQ(session.world().deform()->state().positions_mm, before.positions_mm);
    session.post(SetPaused{false});
    play(session, 5);
    EXPECT_EQ(figures(session).device, "");
    EXPECT_EQ(figures(session).expected_error, 0.2);
    EXPECT_EQ(figures(session).setting, "corotated, on the processor");
    EXPECT_EQ(device.device_steps(), steps);

    session.post(SetQuality{1.0});
    const std::uint64_t end = play(session, 5).state_hash;
    EXPECT_EQ(figures(session).device, both.device);
    EXPECT_GT(device.device_steps(), steps);
    // The recording says of each step who made it.
    const ReplayResult again =
        replay(*recording, small_patient(), job, 0, emulated_back_end().back_end);
    EXPECT_FALSE(again.diverged_at.has_value());
    EXPECT_EQ(again.state_hash, end);
}

TEST(DeviceSession, OnTheDeviceAloneOffersNoSettingOfTheProcessor) {
    const EmulatedBackEnd device = emulated_back_end();
    Job job;
    Session session(patient_with_both(device.back_end), default_scene(), job, device.back_end);
    session.post(SetQuality{0.0});
    pull_trunk(session);
    play(session, 3);
    EXPECT_EQ(figures(session).device, device.back_end.device);
    EXPECT_EQ(figures(session).setting, "corotated, 2 substeps");
}

TEST(DeviceSession, GoesOnWithTheProcessorWhereItsDeviceIsLost) {
    std::string said;
    const EmulatedBackEnd device = emulated_back_end([&](const std::string& words) {
        if (words.find("leave out tension") == words.npos) said += words;
    });
    Job job;
    Session session(small_patient(), default_scene(), job, device.back_end);
    pull_trunk(session);
    play(session, 5);
    EXPECT_EQ(figures(session).device, device.back_end.device);
    EXPECT_EQ(said, "");
    const long steps = device.device_steps();
    const double time_s = session.world().time_s();
    const Vec3 hand = session.world().deform()->hand_mm();
    device.lose();
    play(session, 5);
    EXPECT_EQ(device.device_steps(), steps);
    EXPECT_EQ(figures(session).device, "");
    EXPECT_FALSE(figures(session).diverged);
    EXPECT_EQ(
        said,
        "The processor makes the steps: the device failed (the device does not answer: it was "
        "pulled out)");
    EXPECT_GT(session.world().time_s(), time_s);
    EXPECT_TRUE(session.world().deform()->holding());
    EXPECT_EQ(session.world().deform()->hand_mm(), hand);
}

// Another back end would fail on it, too, and say so again.
TEST(DeviceSession, AChangeOfSettingMakesNoOtherBackEndOfALostDevice) {
    int said = 0;
    const EmulatedBackEnd device = emulated_back_end([&](const std::string& words) {
        said += words.find("device failed") == words.npos ? 0 : 1;
    });
    BodyDescription body;
    body.mesh = kuhn_brick(Vec3(24, 6, 6), {8, 2, 2});
    StepperOptions options;
    const auto stepper = device.back_end.make(body, options, {});
    stepper->set_gravity(Vec3(0, -9810, 0));
    stepper->step(frame_s);
    ASSERT_EQ(device.device_steps(), 1);
    device.lose();
    stepper->step(frame_s);
    EXPECT_EQ(said, 1);
    options.linear.energy_tolerance *= 2.0;
    EXPECT_TRUE(stepper->set_options(options));
    stepper->step(frame_s);
    EXPECT_EQ(said, 1);
}

}  // namespace
}  // namespace hepatica
