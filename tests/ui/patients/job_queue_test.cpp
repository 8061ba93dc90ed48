// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/job_queue.h"

#include <gtest/gtest.h>

#include <QTest>
#include <atomic>
#include <stdexcept>

#include "tests/ui/patients/fake_ward.h"

namespace hepatica {
namespace {

class Queue : public ::testing::Test {
  protected:
    Queue() { testing::need_event_loop(); }

    // Ends when it is let go, or cancelled.
    QueuedJob job(JobKind kind, const std::string& title) {
        QueuedJob job;
        job.kind = kind;
        job.title = title;
        job.begin = [this, title]() -> BackgroundJob::Work {
            log_.push_back("begin " + title);
            return [this, title](Job& work) -> std::function<void()> {
                while (hold_) {
                    std::this_thread::sleep_for(std::chrono::microseconds(200));
                    work.throw_if_cancelled();
                }
                if (title == "bad") throw std::runtime_error("bad");
                worked_ = true;
                return [this, title] { log_.push_back("done " + title); };
            };
        };
        job.failed = [this, title](const Failure&) { log_.push_back("failed " + title); };
        job.cancelled = [this, title] { log_.push_back("cancelled " + title); };
        return job;
    }
    void finish() {
        hold_ = false;
        EXPECT_TRUE(QTest::qWaitFor([this] { return !queue_.busy(); }, 10000));
    }

    std::atomic<bool> hold_{true}, worked_{false};
    std::vector<std::string> log_;
    std::string title_;
    int waiting_ = -1;
    JobQueue queue_{{[this](const std::string& title) { title_ = title; },
                     [](const JobProgress&) {},
                     [this] { waiting_ = static_cast<int>(queue_.waiting_titles().size()); }}};
};

using Log = std::vector<std::string>;

TEST_F(Queue, runs_one_job_after_the_other) {
    queue_.add(job(JobKind::correct, "a"));
    queue_.add(job(JobKind::save, "b"));
    queue_.add(job(JobKind::save, "c"));
    EXPECT_EQ(log_, Log{"begin a"}) << "work is prepared only when its turn has come";
    EXPECT_EQ(waiting_, 2);
    EXPECT_EQ(queue_.waiting_titles(), (std::vector<std::string>{"b", "c"}));
    EXPECT_EQ(title_, "a");
    finish();
    EXPECT_EQ(log_, (Log{"begin a", "done a", "begin b", "done b", "begin c", "done c"}));
    EXPECT_EQ(waiting_, 0);
}

TEST_F(Queue, a_newer_job_takes_the_place_of_its_kind_and_of_no_other) {
    queue_.add(job(JobKind::correct, "a"));
    queue_.add(job(JobKind::save, "b"));
    queue_.replace(job(JobKind::correct, "a2"));
    EXPECT_EQ(title_, "a2");
    queue_.replace(job(JobKind::correct, "a3"));
    EXPECT_EQ(waiting_, 2);
    finish();
    EXPECT_EQ(log_, (Log{"begin a", "begin a3", "done a3", "begin b", "done b"}))
        << "before the save that was asked for after it, and the dropped one says nothing";
}

TEST_F(Queue, a_job_dropped_after_its_work_was_done_has_no_effect) {
    hold_ = false;
    queue_.add(job(JobKind::open, "a"));
    while (!worked_) std::this_thread::yield();  // unheard as long as no event is taken
    queue_.drop(JobKind::open);
    EXPECT_FALSE(queue_.holds(JobKind::open));
    finish();
    EXPECT_EQ(log_, Log{"begin a"});
}

TEST_F(Queue, cancel_ends_the_one_that_runs_and_the_others_go_on) {
    queue_.add(job(JobKind::correct, "a"));
    queue_.add(job(JobKind::save, "b"));
    queue_.cancel_running();
    EXPECT_TRUE(QTest::qWaitFor([this] { return log_.size() >= 3; }, 5000));
    finish();
    EXPECT_EQ(log_, (Log{"begin a", "cancelled a", "begin b", "done b"}));
}

TEST_F(Queue, cancel_means_the_one_that_stands_in_for_a_dropped_one) {
    queue_.add(job(JobKind::correct, "a"));
    queue_.replace(job(JobKind::correct, "a2"));
    queue_.cancel_running();
    finish();
    EXPECT_EQ(log_, (Log{"begin a", "cancelled a2"}));
}

TEST_F(Queue, a_failure_is_told_and_the_next_one_runs) {
    queue_.add(job(JobKind::open, "bad"));
    queue_.add(job(JobKind::save, "b"));
    finish();
    EXPECT_EQ(log_, (Log{"begin bad", "failed bad", "begin b", "done b"}));
}

TEST_F(Queue, a_report_is_written_beside_what_is_done_with_patients) {
    queue_.add(job(JobKind::report, "report"));
    queue_.add(job(JobKind::report, "next report"));
    EXPECT_EQ(title_, "report");
    EXPECT_EQ(queue_.title_beside(), "");
    queue_.add(job(JobKind::open, "a"));
    queue_.add(job(JobKind::save, "b"));
    EXPECT_EQ(log_, (Log{"begin report", "begin a"})) << "nobody waits for a report";
    EXPECT_EQ(title_, "a");
    EXPECT_EQ(queue_.title_beside(), "report");
    EXPECT_EQ(queue_.waiting_titles(), (std::vector<std::string>{"b", "next report"}));
    queue_.cancel_running();
    EXPECT_TRUE(QTest::qWaitFor([this] { return log_.size() >= 4; }, 5000));
    EXPECT_EQ(log_, (Log{"begin report", "begin a", "cancelled a", "begin b"}));
    queue_.cancel_running();
    EXPECT_TRUE(QTest::qWaitFor([this] { return title_ == "report"; }, 5000)) << "shown again";
    EXPECT_TRUE(queue_.holds(JobKind::report));
    EXPECT_FALSE(queue_.holds(JobKind::save));
    queue_.cancel_running();
    EXPECT_TRUE(QTest::qWaitFor([this] { return title_ == "next report"; }, 5000));
    finish();
    EXPECT_EQ(log_, (Log{"begin report", "begin a", "cancelled a", "begin b", "cancelled b",
                         "cancelled report", "begin next report", "done next report"}));
}

TEST_F(Queue, clearing_ends_all_without_a_word) {
    queue_.add(job(JobKind::open, "a"));
    queue_.add(job(JobKind::save, "b"));
    queue_.add(job(JobKind::report, "report"));
    queue_.clear();
    EXPECT_FALSE(queue_.busy());
    finish();
    EXPECT_EQ(log_, (Log{"begin a", "begin report"}));
}

}  // namespace
}  // namespace hepatica
