// SPDX-License-Identifier: GPL-3.0-or-later
// A report that is being written when the program is to end is neither cut off nor lost.
#include <QTest>
#include <atomic>
#include <stdexcept>

#include "tests/ui/patients/keeper_test.h"

namespace hepatica {
namespace {

class Leaving : public testing::KeeperTest {
  protected:
    // Its writing ends when it is let go, or cancelled.
    void begin_report() {
        QueuedJob job;
        job.kind = JobKind::report;
        job.title = "Writing the report";
        job.begin = [this]() -> BackgroundJob::Work {
            return [this](Job& work) -> std::function<void()> {
                while (hold_) {
                    std::this_thread::sleep_for(std::chrono::microseconds(200));
                    work.throw_if_cancelled();
                }
                if (broken_) throw std::runtime_error("broken");
                return [this] { log_.push_back("written"); };
            };
        };
        job.failed = [this](const Failure&) { log_.push_back("failed"); };
        job.cancelled = [this] { log_.push_back("cancelled"); };
        ward.keeper().add_report(std::move(job));
    }
    bool finish() {
        hold_ = false;
        return ward.finish();
    }

    std::atomic<bool> hold_{true}, broken_{false};
    std::vector<std::string> log_;
};

using Log = std::vector<std::string>;

TEST_F(Leaving, a_report_is_finished_before_the_end) {
    begin_report();
    begin_report();
    ward.leave();
    EXPECT_FALSE(ward.left);
    EXPECT_TRUE(ward.said.back().starts_with("The window closes as soon as the report is written"))
        << ward.said.back();
    ASSERT_TRUE(finish());
    EXPECT_TRUE(ward.left);
    EXPECT_EQ(log_, (Log{"written", "written"}));
}

TEST_F(Leaving, a_failed_report_can_be_read_before_the_end) {
    begin_report();
    ward.leave();
    broken_ = true;
    ASSERT_TRUE(finish());
    EXPECT_EQ(log_, Log{"failed"});
    EXPECT_FALSE(ward.left);
    ward.leave();
    EXPECT_TRUE(ward.left);
}

TEST_F(Leaving, a_cancelled_report_keeps_nobody) {
    begin_report();
    ward.leave();
    ward.keeper().cancel();
    ASSERT_TRUE(ward.finish());
    EXPECT_EQ(log_, Log{"cancelled"});
    EXPECT_TRUE(ward.left);
}

TEST_F(Leaving, another_patient_is_opened_beside_a_report) {
    const std::size_t shown = ward.shown.size();
    begin_report();
    ward.open("a.hep");
    EXPECT_TRUE(QTest::qWaitFor([&] { return ward.shown.size() == shown + 1; }, 20000));
    ASSERT_TRUE(finish());
    EXPECT_EQ(log_, Log{"written"});
}

}  // namespace
}  // namespace hepatica
