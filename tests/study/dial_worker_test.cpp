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

TEST(DialWorker, MeasuresOnlyWhileNobodyPlays) {
    Told told;
    DialWorker worker(small_patient(), {}, told.tell());
    EXPECT_FALSE(told.wait_for(1, 1s));  // somebody plays
    worker.allow(true);
    ASSERT_TRUE(told.wait_for(1));
    worker.allow(false);
    // A setting that was all but done may still come, but none after it.
    std::this_thread::sleep_for(200ms);
    const std::size_t before = told.count();
    EXPECT_FALSE(told.wait_for(before + 1, 2s));
    worker.allow(true);
    EXPECT_TRUE(told.wait_for(before + 1));
}

TEST(DialWorker, EndsWhileItWaitsAndWhileItMeasures) {
    Told told;
    const auto start = std::chrono::steady_clock::now();
    { const DialWorker waiting(small_patient(), {}, told.tell()); }
    {
        DialWorker measuring(small_patient(), {}, told.tell());
        measuring.allow(true);
        std::this_thread::sleep_for(100ms);
    }
    EXPECT_LT(std::chrono::steady_clock::now() - start, 10s);
    EXPECT_EQ(told.count(), 0u);
}

TEST(DialWorker, MeasuresAllThatIsLeftAndNothingTwice) {
    Told told;
    DialWorker worker(small_patient(), {}, told.tell());
    worker.allow(true);
    ASSERT_TRUE(told.wait_for(6));
    std::vector<QualityPoint> points;
    do {
        points = told.points();
        std::this_thread::sleep_for(50ms);
    } while (next_dial_setting(points));
    Told again;
    DialWorker idle(small_patient(), points, again.tell());
    idle.allow(true);
    EXPECT_FALSE(again.wait_for(1, 1s));
}

}  // namespace
}  // namespace hepatica
