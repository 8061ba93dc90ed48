// SPDX-License-Identifier: GPL-3.0-or-later
// The meeting places of the window's threads, under load from both sides. In release they show lost
// or torn values; ./test runs them under the thread sanitizer, too, which sees the races
// themselves.
#include <gtest/gtest.h>

#include <QCoreApplication>
#include <atomic>
#include <chrono>
#include <functional>
#include <string>
#include <thread>
#include <vector>

#include "tests/session/small_patient.h"
#include "ui/job_queue.h"
#include "ui/simulation_thread.h"

// Qt hands events over by futexes of its own, which the thread sanitizer does not see: what the
// poster wrote into the event then looks like a race with the thread that takes it. What a job
// itself hands over goes through a std::future, in files that are watched.
extern "C" const char* __tsan_default_suppressions() {  // NOLINT: the sanitizer's name
    return "race:ui/background_job.cpp\n";
}

namespace hepatica {
namespace {

using test::middle_of;
using test::small_patient;
using Clock = std::chrono::steady_clock;

// True as soon as the condition holds; false where it does not within a minute.
bool comes_true(const std::function<bool()>& condition) {
    for (const auto end = Clock::now() + std::chrono::minutes(1); Clock::now() < end;) {
        if (condition()) return true;
        std::this_thread::sleep_for(std::chrono::microseconds(200));
    }
    return false;
}

std::unique_ptr<SimulationThread> new_simulation() {
    Job job;
    return std::make_unique<SimulationThread>(
        std::make_unique<Session>(small_patient(), default_scene(), job));
}

// Reads all of a frame, as the view does.
double sum_of(const Frame& frame) {
    double sum = frame.time_s + frame.statistics.step_ms + frame.drug.time_s;
    for (const float coordinate : frame.positions_mm) sum += coordinate;
    if (frame.drug.arrival_s)
        for (const float arrival : *frame.drug.arrival_s) sum += arrival < 1e6F ? arrival : 0.0F;
    return sum + static_cast<double>(frame.statistics.message.size());
}

TEST(SimulationThread, PlaysWhileTheWindowReadsItsFramesAndPostsCommands) {
    const auto simulation = new_simulation();
    const VesselTree& tree = small_patient()->tree;
    const Vec3 start = middle_of(tree, 1);
    simulation->post(GrabPoint{start});
    simulation->post(InjectDrug{.point_mm = tree.nodes[0].position_mm});
    std::uint64_t last = 0;
    int frames = 0;
    double pulled_mm = 0.0;
    ASSERT_TRUE(comes_true([&] {
        simulation->set_drawing_ms(1.0);
        simulation->post(MoveGrab{start + Vec3(pulled_mm += 0.01, 0.0, 0.0)});
        if (!simulation->update_frame()) return false;
        const Frame& frame = simulation->frame();
        EXPECT_GE(frame.step, last);
        EXPECT_TRUE(std::isfinite(sum_of(frame)));
        last = frame.step;
        return ++frames >= 30;
    }));
    ASSERT_TRUE(comes_true([&] {
        simulation->update_frame();
        return simulation->frame().grab && simulation->frame().drug.arrival_s;
    })) << "what was posted shows";
}

TEST(SimulationThread, TakesCommandsFromSeveralThreads) {
    const auto simulation = new_simulation();
    {
        std::vector<std::jthread> people;
        for (int person = 0; person < 3; ++person)
            people.emplace_back([&] {
                for (int i = 0; i < 100; ++i) {
                    simulation->post(SetPaused{i % 2 == 0});
                    simulation->set_drawing_ms(i);
                }
            });
    }
    simulation->post(SetPaused{true});
    EXPECT_TRUE(comes_true([&] {
        simulation->update_frame();
        return simulation->frame().statistics.paused;
    }));
}

TEST(SimulationThread, EndsInTheMiddleOfAPlay) {
    for (int i = 0; i < 5; ++i) {
        const auto simulation = new_simulation();
        simulation->post(GrabPoint{middle_of(small_patient()->tree, 1)});
        std::this_thread::yield();
    }
}

TEST(JobQueueThreads, HandResultsAndProgressToTheWindow) {
    int argc = 1;
    std::string name = "threads";
    std::vector<char*> argv{name.data(), nullptr};
    const QCoreApplication application(argc, argv.data());

    std::atomic<int> looks{0};
    std::vector<std::string> log;
    double furthest = 0.0;
    JobQueue queue({[&](const std::string& title) { log.push_back("began " + title); },
                    [&](const JobProgress& now) { furthest = std::max(furthest, now.fraction); },
                    [] {}});
    const auto work = [&](const std::string& title, bool endless) {
        QueuedJob job;
        job.kind = JobKind::save;
        job.title = title;
        job.begin = [&, title, endless]() -> BackgroundJob::Work {
            return [&, title, endless](Job& own) -> std::function<void()> {
                std::vector<int> made;
                own.begin_stage(title);
                for (int i = 0; i < 100 || endless; ++i) {
                    made.push_back(i);
                    own.advance(std::min(1.0, 0.01 * i));
                    ++looks;
                    std::this_thread::sleep_for(std::chrono::milliseconds(1));
                }
                return [&, title, made] {
                    log.push_back(title + " made " + std::to_string(made.size()));
                };
            };
        };
        job.failed = [&](const Failure& failure) { log.push_back(failure.problem); };
        job.cancelled = [&, title] { log.push_back(title + " cancelled"); };
        return job;
    };
    queue.add(work("first", false));
    queue.add(work("second", true));
    const auto until = [&](const std::function<bool()>& condition) {
        return comes_true([&] {
            QCoreApplication::processEvents();
            return condition();
        });
    };
    ASSERT_TRUE(until([&] { return log.size() >= 3; }));
    queue.cancel_running();
    ASSERT_TRUE(until([&] { return !queue.busy(); }));
    EXPECT_EQ(log, (std::vector<std::string>{"began first", "first made 100", "began second",
                                             "second cancelled"}));
    EXPECT_GT(furthest, 0.0);
    EXPECT_GE(looks, 100);
}

}  // namespace
}  // namespace hepatica
