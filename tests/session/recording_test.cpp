// SPDX-License-Identifier: GPL-3.0-or-later
// Recordings on disk, and replays that begin at a keyframe: the same bits, or the reason why not.
#include "core/session/recording_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <filesystem>
#include <fstream>
#include <functional>
#include <sstream>
#include <thread>

#include "core/base/error.h"
#include "core/scene/flow_part.h"
#include "core/scene/world.h"
#include "core/session/replay.h"
#include "tests/session/new_session.h"
#include "tests/session/recorded.h"
#include "tests/session/small_patient.h"

namespace hepatica {
namespace {

namespace fs = std::filesystem;
using test::keep_recording;
using test::middle_of;
using test::new_session;
using test::play;
using test::small_patient;
using testing::AllOf;
using testing::HasSubstr;

// 1300 steps with all that a keyframe has to hold: another tether, wall, gravity and setting, a
// hand, a pause, a drug whose clock runs at another speed, parts of the body that sleep.
std::shared_ptr<Recording> eventful_recording() {
    static const std::shared_ptr<Recording> recording = [] {
        const VesselTree& tree = small_patient()->tree;
        const auto session = new_session();
        auto kept = keep_recording(*session);
        session->post(SetTether{35.0});
        session->post(SetWall{0.6});
        session->post(SetDrugSpeed{0.25});
        session->post(InjectDrug{.point_mm = tree.nodes[0].position_mm});
        play(*session, 100);
        session->post(SetPaused{true});
        play(*session, 30);
        session->post(SetPaused{false});
        session->post(UseSetting{{.newton_iterations = 2, .substeps = 2}});
        session->post(SetGravity{Vec3(0, 1000, 0)});
        play(*session, 300);
        session->post(SetGravity{Vec3::Zero()});
        session->post(GrabPoint{middle_of(tree, 4)});
        for (int i = 0; i < 250; ++i) {
            session->post(MoveGrab{middle_of(tree, 4) + Vec3(0.02 * i, 0, 0)});
            session->step();
        }
        play(*session, 100);  // over the first keyframe with a closed hand
        session->post(ReleaseGrab{});
        session->post(InjectDrug{
            .point_mm = tree.nodes[0].position_mm, .void_fraction = 0.4, .second_phase = "gas"});
        play(*session, 480);  // over the second with an injection that is being computed
        session->post(FinishInjection{});
        session->post(GrabPoint{middle_of(tree, 1)});
        session->post(MoveGrab{middle_of(tree, 1) + Vec3(0, 4, 0)});
        play(*session, 40);
        return kept;
    }();
    return recording;
}

std::vector<std::uint64_t> keyframes_of(const Recording& recording) {
    std::vector<std::uint64_t> steps;
    for (const RecordedStep& step : recording.steps)
        if (step.keyframe) steps.push_back(step.keyframe->step);
    return steps;
}

std::string written(const Recording& recording) {
    const fs::path file = fs::path(testing::TempDir()) / "written.hrec";
    write_recording(file, recording);
    std::ostringstream text;
    text << std::ifstream(file).rdbuf();
    return text.str();
}

// What reading it says; empty where it is read.
std::string refusal_of(const std::string& text) {
    const fs::path file = fs::path(testing::TempDir()) / "refused.hrec";
    std::ofstream(file) << text;
    try {
        read_recording(file);
    } catch (const InputError& error) {
        return error.what();
    }
    return "";
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
    const std::size_t at = text.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    return text.replace(at, from.size(), to);
}

Recording few_steps() {
    const auto session = new_session();
    const auto recording = keep_recording(*session);
    session->post(GrabPoint{middle_of(small_patient()->tree, 1)});
    play(*session, 4);
    return *recording;
}

TEST(Keyframes, AreTakenEveryTenSecondsOfPlay) {
    const Recording& recording = *eventful_recording();
    EXPECT_EQ(recording.steps.size(), 1300u);
    EXPECT_EQ(keyframes_of(recording), (std::vector<std::uint64_t>{630, 1230}));  // 30 were paused
}

TEST(Keyframes, AReplayFromOneGoesOnWithTheSameBits) {
    const fs::path file = fs::path(testing::TempDir()) / "eventful.hrec";
    write_recording(file, *eventful_recording());
    const Recording recording = read_recording(file);
    EXPECT_TRUE(recording.warnings.empty());
    ASSERT_EQ(keyframes_of(recording), keyframes_of(*eventful_recording()));
    EXPECT_TRUE(recording.steps[629].keyframe->world.deform->hold.has_value());
    EXPECT_TRUE(recording.steps[1229].keyframe->world.flow->computing.has_value());
    Job job;
    for (const auto& [from, begins] : {std::pair<std::uint64_t, std::uint64_t>{0, 0},
                                       {630, 630},
                                       {700, 630},
                                       {1229, 630},
                                       {1230, 1230},
                                       {1300, 1230}}) {
        const ReplayResult result = replay(recording, small_patient(), job, from);
        EXPECT_EQ(result.began_at, begins);
        EXPECT_EQ(result.steps, 1300u);
        EXPECT_FALSE(result.diverged_at.has_value())
            << "from " << from << ": step " << *result.diverged_at;
        EXPECT_EQ(result.state_hash, recording.steps.back().state_hash);
    }
    EXPECT_THROW(replay(recording, small_patient(), job, 1301), InputError);
    Recording begun = recording;
    begun.steps.resize(635);
    EXPECT_EQ(replay(begun, small_patient(), job, 629).began_at, 0u);
}

// The session takes itself back after an error of its watch: that is no reason to call the
// recording another one, nor to hide the error.
TEST(Replay, EndsWithTheErrorOfItsWatch) {
    const auto session = new_session();
    const auto recording = keep_recording(*session);
    play(*session, 8);
    Job job;
    int seen = 0;
    try {
        replay(*recording, small_patient(), job, 0, cpu_back_end(),
               [&](const std::vector<Command>&, const Frame&, const std::stop_token&) {
                   if (++seen == 5) throw InputError("cannot flow", "the fifth frame", "Look away");
                   return true;
               });
        FAIL() << "the error is lost";
    } catch (const InputError& error) {
        EXPECT_EQ(error.problem(), "cannot flow");
    }
    EXPECT_EQ(seen, 5);
}

// Who judges a play has nothing to judge from there on.
TEST(Replay, StopsAtTheFirstStepThatDiffersWhereAskedTo) {
    const auto session = new_session();
    const auto recording = keep_recording(*session);
    play(*session, 8);
    recording->steps[2].state_hash ^= 1;
    Job job;
    const ReplayResult stopped =
        replay(*recording, small_patient(), job, 0, cpu_back_end(), {}, AfterDivergence::stop);
    EXPECT_EQ(stopped.diverged_at, 3u);
    EXPECT_EQ(stopped.steps, 3u);
    const ReplayResult whole = replay(*recording, small_patient(), job);
    EXPECT_EQ(whole.diverged_at, 3u);
    EXPECT_EQ(whole.steps, 8u);
}

// Of everything that a keyframe holds, whatever is changed is found: by the hash of its state or by
// what reading it says.
TEST(Keyframes, ADamagedOneIsRefused) {
    Recording recording = *eventful_recording();
    const Keyframe whole = *recording.steps[629].keyframe;
    Job job;
    const auto refused = [&](const std::function<void(Keyframe&)>& damage) {
        auto keyframe = std::make_shared<Keyframe>(whole);
        damage(*keyframe);
        recording.steps[629].keyframe = keyframe;
        try {
            replay(recording, small_patient(), job, 630);
        } catch (const InputError&) {
            return true;
        }
        return false;
    };
    EXPECT_FALSE(refused([](Keyframe&) {}));
    EXPECT_TRUE(
        refused([](Keyframe& k) { k.world.deform->stepper.nodes.positions_mm[5].x() += 1e-9; }));
    EXPECT_TRUE(refused([](Keyframe& k) { k.world.deform->settings.tether_pa_per_mm2 = 34.0; }));
    EXPECT_TRUE(refused([](Keyframe& k) { k.world.deform->settings.wall_mm = 0.5; }));
    EXPECT_TRUE(refused([](Keyframe& k) { k.world.deform->settings.stepper.substeps = 1; }));
    EXPECT_TRUE(refused([](Keyframe& k) { k.world.deform->hold.reset(); }));
    EXPECT_TRUE(refused([](Keyframe& k) { k.world.deform->hold->target_mm.x() += 0.1; }));
    EXPECT_TRUE(refused([](Keyframe& k) { k.world.deform->hold->vertices[0] = 1 << 30; }));
    EXPECT_TRUE(refused([](Keyframe& k) { k.world.flow->time_s += 0.1; }));
    EXPECT_TRUE(refused([](Keyframe& k) { k.world.flow->speed = 1.0; }));
    EXPECT_TRUE(refused([](Keyframe& k) { k.world.flow->playing = false; }));
    EXPECT_TRUE(refused([](Keyframe& k) { k.world.flow->injected->mass_flow_g_s = 1.0; }));
    EXPECT_TRUE(refused([](Keyframe& k) { k.world.flow->injected->at.segment = 99; }));
    EXPECT_TRUE(refused([](Keyframe& k) { k.world.flow->injected.reset(); }));
    EXPECT_TRUE(refused([](Keyframe& k) { k.world.flow.reset(); }));
}

TEST(RecordingFile, NamesNobody) {
    auto patient = std::make_shared<PatientCase>(*small_patient());
    patient->source.name = "/home/Doe^John/DOE_JOHN_1970";
    Job job;
    Session session(patient, default_scene(), job);
    const auto recording = keep_recording(session);
    play(session, 3);
    const std::string text = written(*recording);
    for (const char* name : {"Doe", "DOE", "john", "1970", "/home"})
        EXPECT_EQ(text.find(name), std::string::npos) << name;
}

TEST(RecordingFile, HoldsTheDateThatItWasGivenAndNoOther) {
    Recording recording = few_steps();
    EXPECT_EQ(written(recording).find("played_at"), std::string::npos);
    EXPECT_EQ(written(recording), written(few_steps())) << "the same play has the same bytes";
    recording.played_at = "2024-05-06T12:00:00Z";
    const fs::path file = fs::path(testing::TempDir()) / "dated.hrec";
    write_recording(file, recording);
    EXPECT_EQ(read_recording(file, RecordingPart::header).played_at, "2024-05-06T12:00:00Z");
    EXPECT_THAT(refusal_of(replaced(written(recording), "\"2024-05-06T12:00:00Z\"", "7")),
                HasSubstr("line 1"));
}

TEST(RecordingFile, OfAnotherVersionIsRefusedWithTheReason) {
    const std::string text = written(few_steps());
    EXPECT_EQ(refusal_of(text), "");
    EXPECT_THAT(refusal_of(replaced(text, "\"version\":2", "\"version\":1")),
                HasSubstr("is of format 1, and this program reads format 2"));
    EXPECT_THAT(refusal_of(replaced(text, "\"version\":2", "\"version\":9")),
                HasSubstr("was made by a newer version of the program, in format 9"));
    EXPECT_THAT(refusal_of(replaced(text, "\"program\":\"" + program_version() + "\"",
                                    "\"program\":\"0.0.7\"")),
                HasSubstr("was recorded by version 0.0.7"));
    EXPECT_THAT(refusal_of("{\"format\": \"else\"}\n"), HasSubstr("is not a recording"));
    EXPECT_THAT(refusal_of("a text"), HasSubstr("is not a recording"));
    EXPECT_THAT(refusal_of(""), HasSubstr("is empty"));
    EXPECT_THAT(refusal_of(text.substr(0, 40)), HasSubstr("is not a recording"));
}

TEST(RecordingFile, OfAnotherBackEndIsNotReplayed) {
    Recording recording = few_steps();
    require_back_end(recording, cpu_back_end());
    recording.back_end = "cuda";
    EXPECT_THROW(require_back_end(recording, cpu_back_end()), InputError);
}

// Wherever a program dies while it writes its last line.
TEST(RecordingFile, ATornLastLineIsLeftOutWithAWarning) {
    const Recording recording = few_steps();
    const std::string text = written(recording);
    const std::size_t last_line = text.rfind('\n', text.size() - 2) + 1;
    const fs::path file = fs::path(testing::TempDir()) / "torn.hrec";
    for (std::size_t length = last_line; length < text.size(); ++length) {
        std::ofstream(file) << text.substr(0, length);
        const Recording read = read_recording(file);
        const bool torn = length > last_line && length + 1 < text.size();
        EXPECT_EQ(read.steps.size(), length + 1 < text.size() ? 3u : 4u) << length;
        EXPECT_EQ(read.warnings.size(), torn ? 1u : 0u) << length;
        if (torn) {
            EXPECT_THAT(read.warnings[0], HasSubstr("line 5"));
        }
    }
}

// A list of recordings needs no keyframes, which are most of the file.
TEST(RecordingFile, IsReadInPart) {
    const fs::path file = fs::path(testing::TempDir()) / "in_part.hrec";
    const Recording whole = *eventful_recording();
    write_recording(file, whole);
    const Recording header = read_recording(file, RecordingPart::header);
    EXPECT_EQ(header.patient_hash, whole.patient_hash);
    EXPECT_TRUE(header.steps.empty());
    const Recording commands = read_recording(file, RecordingPart::commands);
    ASSERT_EQ(commands.steps.size(), whole.steps.size());
    std::size_t given = 0;
    for (std::size_t i = 0; i < whole.steps.size(); ++i) {
        EXPECT_EQ(commands.steps[i].keyframe, nullptr);
        EXPECT_EQ(commands.steps[i].commands.size(), whole.steps[i].commands.size());
        given += commands.steps[i].commands.size();
    }
    EXPECT_GT(given, 0u);
}

TEST(RecordingFile, ATornKeyframeIsLeftOutWithAWarning) {
    const fs::path file = fs::path(testing::TempDir()) / "torn_keyframe.hrec";
    const std::string eventful = written(*eventful_recording());
    const std::size_t keyframe = eventful.find("{\"keyframe\"");
    std::ofstream(file) << eventful.substr(0, keyframe + 1000);
    const Recording read = read_recording(file);
    EXPECT_EQ(read.steps.size(), 630u);
    EXPECT_EQ(read.warnings.size(), 1u);
    Job job;
    EXPECT_FALSE(replay(read, small_patient(), job).diverged_at.has_value());
}

TEST(RecordingFile, ADamagedLineInTheMiddleIsRefusedByItsNumber) {
    const std::string text = written(few_steps());
    const std::size_t second = text.find('\n') + 1;
    const std::size_t third = text.find('\n', second) + 1;
    EXPECT_THAT(refusal_of(text.substr(0, third) + "{\"hash\": \n" + text.substr(third)),
                HasSubstr("line 3"));
    EXPECT_THAT(refusal_of(text.substr(0, third) + "{\"hash\": \"12\"}\n" + text.substr(third)),
                HasSubstr("line 3"));
    EXPECT_THAT(refusal_of(text + "{\"hash\": \"12\"}\n"), HasSubstr("line 6"));
    EXPECT_THAT(refusal_of(text + "{\"keyframe\": 9, \"played_steps\": 9, \"automatic\": false, "
                                  "\"world\": {\"time_s\": 1}}\n"),
                HasSubstr("a keyframe of step 9 stands behind step 4"));
    EXPECT_THAT(refusal_of(text + "{\"keyframe\": 4, \"played_steps\": 4, \"automatic\": false, "
                                  "\"world\": {}}\n"),
                HasSubstr("line 6"));
    // Telling of this vertex by recursion would overflow the stack.
    const std::string deep = std::string(200000, '[') + std::string(200000, ']');
    EXPECT_THAT(refusal_of(text.substr(0, third) +
                           "{\"hash\": \"0123456789abcdef\", \"commands\": [{\"command\": "
                           "\"grab_vertex\", \"vertex\": " +
                           deep + "}]}\n" + text.substr(third)),
                HasSubstr("line 3"));
}

TEST(RecordingFile, ALongTextInPlaceOfAHashIsCutInTheMessage) {
    const std::string text = written(few_steps());
    const std::string said =
        refusal_of(text + "{\"hash\": \"" + std::string(1'000'000, 'z') + "\"}\n");
    EXPECT_THAT(said, AllOf(HasSubstr("line 6"), HasSubstr("zzz…\" is not a hash")));
    EXPECT_LT(said.size(), 500u);
}

// A replay from there would never end.
TEST(RecordingFile, ANumberThatNoBodyCanHaveIsRefusedByLineFieldAndRange) {
    const std::string text = written(few_steps());
    const std::string key = "\"point_mm\":[";
    const std::size_t at = text.find(key) + key.size();
    const std::string far = text.substr(0, at) + "1e308" + text.substr(text.find(',', at));
    EXPECT_THAT(refusal_of(far),
                AllOf(HasSubstr("line 2"), HasSubstr("command grab_point, field point_mm"),
                      HasSubstr("is 1e+308; it must lie from -10000 to 10000")));
    const std::string scene = "\"gravity_mm_per_s2\":[";
    const std::size_t down = text.find(scene) + scene.size();
    EXPECT_THAT(refusal_of(text.substr(0, down) + "1e308" + text.substr(text.find(',', down))),
                AllOf(HasSubstr("line 1"), HasSubstr("is 1e+308; it must lie from")));
}

// Reading a process's memory from address 0 on fails: the file is not taken for an empty one, as
// one that breaks off later is not taken for a shorter play.
TEST(RecordingFile, ThatFailsToBeReadIsRefused) {
    const fs::path file = "/proc/self/mem";
    if (!fs::exists(file)) GTEST_SKIP() << "no " << file;
    try {
        read_recording(file);
        FAIL() << "it was read";
    } catch (const InputError& error) {
        EXPECT_EQ(error.problem(), "cannot be read to its end");
        EXPECT_EQ(error.place(), file.string());
    }
}

// What is in the file while the session still goes on is a recording.
TEST(RecordingFile, GrowsAsTheSessionGoes) {
    const fs::path file = fs::path(testing::TempDir()) / "growing.hrec";
    const auto session = new_session();
    RecordingWriter writer(file, session->recording_start());
    session->record([&](RecordedStep step) { writer.append(std::move(step)); });
    std::size_t seen = 0;
    for (int i = 0; i < 2000 && seen < 3; ++i) {
        session->step();
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
        seen = read_recording(file).steps.size();
    }
    EXPECT_GE(seen, 3u);
    session->post(GrabPoint{middle_of(small_patient()->tree, 1)});
    const SessionStep last = session->step();
    writer.close();
    const Recording read = read_recording(file);
    EXPECT_EQ(read.steps.size(), last.step);
    Job job;
    EXPECT_EQ(replay(read, small_patient(), job).state_hash, last.state_hash);
}

TEST(RecordingFile, SaysWhereItCannotBeWritten) {
    const auto session = new_session();
    EXPECT_THROW(RecordingWriter("/dev/null/all.hrec", session->recording_start()), InputError);
    if (!fs::exists("/dev/full")) GTEST_SKIP();
    EXPECT_THROW(write_recording("/dev/full", few_steps()), InputError);
}

// As a free play is recorded from the moment on at which somebody asks for it.
TEST(Recording, BeginsAmidAPlayAndPlaysAgainToTheSameBits) {
    const fs::path file = fs::path(testing::TempDir()) / "amid.hrec";
    const VesselTree& tree = small_patient()->tree;
    const auto session = new_session();
    session->post(SetTether{35.0});
    session->post(GrabPoint{middle_of(tree, 4)});
    session->post(MoveGrab{middle_of(tree, 4) + Vec3(3, 0, 0)});
    play(*session, 650);  // beyond a keyframe of its own
    session->post(SetPaused{true});
    play(*session, 2);
    session->record_from_now([&](const Recording& start) {
        EXPECT_EQ(start.steps.size(), 0u);
        auto writer = std::make_shared<RecordingWriter>(file, start);
        return [writer](RecordedStep step) { writer->append(std::move(step)); };
    });
    play(*session, 3);
    session->post(SetPaused{false});
    play(*session, 20);
    session->post(RestoreSnapshot{});  // to where the recording began
    play(*session, 20);
    session->post(MoveGrab{middle_of(tree, 4) + Vec3(0, 5, 0)});
    play(*session, 600);  // over a keyframe
    session->record_from_now({});
    play(*session, 5);

    const Recording recording = read_recording(file);
    ASSERT_NE(recording.begin, nullptr);
    ASSERT_EQ(recording.steps.size(), 643u);
    EXPECT_FALSE(keyframes_of(recording).empty());
    Job job;
    for (const std::uint64_t from : {std::uint64_t{0}, keyframes_of(recording).front()}) {
        const ReplayResult again = replay(recording, small_patient(), job, from);
        EXPECT_FALSE(again.diverged_at) << "from " << from << ", at " << *again.diverged_at;
        EXPECT_EQ(again.steps, 643u);
        EXPECT_EQ(again.state_hash, recording.steps.back().state_hash);
    }
}

}  // namespace
}  // namespace hepatica
