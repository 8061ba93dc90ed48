// SPDX-License-Identifier: GPL-3.0-or-later
// The dial is measured beside the play, and never during it.
#include "core/study/dial_worker.h"

#include <gtest/gtest.h>

#include <chrono>

#include "tests/session/small_patient.h"

namespace hepatica {
namespace {

using namespace std::chrono_literals;
using test::small_patient;

class Told {
  public:
    DialWorker::Tell tell() {
        return [this](const std::vector<QualityPoint>& points) {
            const std::scoped_lock lock(mutex_);
            points_ = points;
            came_.notify_all();
        };
    }
    // False where so many points do not come within `most`.
    bool wait_for(std::size_t points, std::chrono::seconds most = 120s) {
        std::unique_lock lock(mutex_);
        return came_.wait_for(lock, most, [&] { return points_.size() >= points; });
    }
    std::size_t count() {
        const std::scoped_lock lock(mutex_);
        return points_.size();
    }
    std::vector<QualityPoint> points() {
        const std::scoped_lock lock(mutex_);
        return points_;
    }

  private:
    std::mutex mutex_;
    std::condition_variable came_;
    std::vector<QualityPoint> points_;
};

bool comes_to(const DialWorker& worker, DialWorker::State state) {
    const auto end = std::chrono::steady_clock::now() + 120s;
    while (worker.state() != state && std::chrono::steady_clock::now() < end)
        std::this_thread::sleep_for(1ms);
    return worker.state() == state;
}

TEST(DialWorker, MeasuresOnlyWhileNobodyPlays) {
    Told told;
    DialWorker worker(small_patient(), {}, told.tell());
    ASSERT_TRUE(comes_to(worker, DialWorker::State::waits));  // somebody plays
    EXPECT_EQ(told.count(), 0u);
    worker.allow(true);
    ASSERT_TRUE(told.wait_for(1));
    worker.allow(false);
    // A setting that was all but done may still have come, but none comes while it waits.
    ASSERT_TRUE(comes_to(worker, DialWorker::State::waits));
    const std::size_t before = told.count();
    worker.allow(true);
    EXPECT_TRUE(told.wait_for(before + 1));
}

TEST(DialWorker, EndsWhileItWaitsAndWhileItMeasures) {
    Told told;
    { const DialWorker waiting(small_patient(), {}, told.tell()); }
    {
        DialWorker measuring(small_patient(), {}, told.tell());
        measuring.allow(true);
        ASSERT_TRUE(comes_to(measuring, DialWorker::State::measures));
    }
    EXPECT_EQ(told.count(), 0u);  // neither measured a setting to its end
}

TEST(DialWorker, MeasuresAllThatIsLeftAndNothingTwice) {
    Told told;
    DialWorker worker(small_patient(), {}, told.tell());
    worker.allow(true);
    ASSERT_TRUE(comes_to(worker, DialWorker::State::ended));
    const std::vector<QualityPoint> points = told.points();
    EXPECT_GE(points.size(), 6u);
    EXPECT_FALSE(next_dial_setting(points).has_value());
    Told again;
    DialWorker idle(small_patient(), points, again.tell());
    idle.allow(true);
    ASSERT_TRUE(comes_to(idle, DialWorker::State::ended));
    EXPECT_EQ(again.count(), 0u);
}

}  // namespace
}  // namespace hepatica
