// SPDX-License-Identifier: GPL-3.0-or-later
// Whatever a person clicks, in whatever order and however long the jobs take: no correction is lost
// unless it was undone, cancelled, refused with a word, or given up in answer to a question. The
// test keeps its own account of what must be there and holds screen and disk against it.
#include <gtest/gtest.h>

#include <QCoreApplication>
#include <QTest>
#include <algorithm>
#include <random>
#include <set>

#include "tests/ui/patients/fake_ward.h"

namespace hepatica {
namespace {

using testing::edit;
using testing::FakeWard;
using testing::numbers_of;
using Numbers = std::vector<int>;

class AnyOrder {
  public:
    explicit AnyOrder(unsigned seed) : random_(seed) {
        ward_.on_question = [this](const std::string&) { answer_question(); };
        ward_.before_show = [this](bool corrected) {
            if (!corrected) patient_left();
        };
    }

    void run() {
        for (int click = 0; click < 60 && !::testing::Test::HasFailure(); ++click) {
            do_something();
            hear();
            check_screen();
        }
        ward_.disk_full = false;
        EXPECT_TRUE(ward_.finish());
        hear();
        check_screen();
        EXPECT_FALSE(ward_.workspace().awaits_body());
        if (ward_.workspace().has_patient() && !ward_.workspace().dirty()) check_disk();
    }

    int departures() const { return departures_; }
    int departures_with_corrections() const { return departures_with_corrections_; }
    std::string story() const { return story_; }

  private:
    int pick(int count) { return std::uniform_int_distribution(0, count - 1)(random_); }
    std::string some_case() { return std::string(1, static_cast<char>('a' + pick(3))) + ".hep"; }
    void tell(const std::string& what) { story_ += what + "; "; }

    void do_something() {
        ward_.slowness_us = pick(3) == 0 ? 2000 : 0;
        ward_.disk_full = pick(10) == 0;
        switch (pick(14)) {
            case 0:
            case 1:
            case 2:
            case 3:
                return add(++last_number_);
            case 4:
                return add(-++last_number_);
            case 5:
                return undo();
            case 6:
                return redo();
            case 7:
                tell("save");
                ward_.place = pick(3) == 0 ? std::nullopt : std::optional(some_case());
                ward_.keeper().save();
                return;
            case 8:
                tell("save as");
                ward_.keeper().save_as(FakeWard::path_of(some_case()));
                return;
            case 9:
                return open_another();
            case 10:
                return close();
            case 11:
                tell("cancel");
                ward_.keeper().cancel();
                return;
            case 12:
                tell("wait");
                EXPECT_TRUE(ward_.finish());
                return;
            default:
                tell("pause");
                QTest::qWait(1 + pick(4));
        }
    }

    void add(int number) {
        if (!ward_.workspace().has_patient()) return;
        tell("add " + std::to_string(number));
        wanted_.push_back(number);
        undone_.clear();
        ward_.keeper().add(edit(number));
    }
    void undo() {
        if (wanted_.empty()) return;
        tell("undo");
        undone_.push_back(wanted_.back());
        wanted_.pop_back();
        ward_.keeper().undo();
    }
    void redo() {
        if (undone_.empty() || !ward_.workspace().can_redo()) return;
        tell("redo");
        wanted_.push_back(undone_.back());
        undone_.pop_back();
        ward_.keeper().redo();
    }

    void open_another() {
        if (pick(3) == 0) {
            tell("open built-in");
            return ward_.open_built_in();
        }
        const std::string name = pick(2) == 0 ? some_case() : "ct" + std::to_string(pick(3));
        tell("open " + name);
        ward_.open(name);
    }

    // The end of the program; the next one begins with the built-in patient.
    void close() {
        tell("close");
        ward_.keeper().leave([this] {
            tell("closed");
            patient_left();
            ward_.keeper().leave([] {});
            closed_ = true;
        });
    }

    void answer_question() {
        const int answer = pick(3);
        ward_.answer = answer == 0   ? UnsavedAnswer::save
                       : answer == 1 ? UnsavedAnswer::discard
                                     : UnsavedAnswer::cancel;
        tell(answer == 0 ? "(save)" : answer == 1 ? "(discard)" : "(stay)");
        ward_.place = pick(3) == 0 ? std::nullopt : std::optional(some_case());
        hear();
        if (answer == 1) given_up_ = wanted_;
    }

    // What the keeper told the person since: only this may change what is wanted beside clicks.
    void hear() {
        const Numbers now = numbers_of(ward_.workspace().edits());
        if (ward_.failures.size() > failures_heard_ || ward_.said.size() > said_heard_) {
            const bool taken_back =
                std::find(ward_.said.begin() + static_cast<std::ptrdiff_t>(said_heard_),
                          ward_.said.end(), "The correction was taken back") != ward_.said.end();
            const bool refused =
                std::any_of(ward_.failures.begin() + static_cast<std::ptrdiff_t>(failures_heard_),
                            ward_.failures.end(),
                            [](const std::string& text) { return text.starts_with("Correcting"); });
            failures_heard_ = ward_.failures.size();
            said_heard_ = ward_.said.size();
            // Cancelled: all that has no body. Refused: the impossible ones alone.
            if (taken_back) {
                wanted_ = now;
            } else if (refused) {
                for (const int number : wanted_)
                    if (number > 0) {
                        EXPECT_TRUE(std::ranges::count(now, number)) << number << " is gone";
                    }
                wanted_ = now;
            }
            if (taken_back || refused) undone_.clear();
        }
    }

    // A patient gives way: to another, or to the end.
    void patient_left() {
        if (!ward_.workspace().has_patient()) return;
        hear();
        ++departures_;
        if (!wanted_.empty()) ++departures_with_corrections_;
        if (given_up_ != wanted_ &&
            (!wanted_.empty() || ward_.workspace().dirty() || !ward_.workspace().folder().empty()))
            check_disk();
        given_up_.reset();
        leaving_ = true;
    }

    void check_screen() {
        if (leaving_ && !closed_) {
            wanted_ = numbers_of(ward_.workspace().edits());
            undone_.clear();
        }
        if (closed_) ward_.keeper().leave([] {});
        leaving_ = closed_ = false;
        EXPECT_EQ(numbers_of(ward_.workspace().edits()), wanted_);
    }
    void check_disk() {
        const std::string name = ward_.workspace().folder().filename().string();
        const bool nothing_to_lose = name.empty() && wanted_.empty();
        if (nothing_to_lose) {
            EXPECT_FALSE(ward_.workspace().dirty());
            return;
        }
        ASSERT_FALSE(name.empty());
        EXPECT_EQ(ward_.on_disk(name), wanted_);
    }

    std::mt19937 random_;
    FakeWard ward_;
    std::string story_;
    Numbers wanted_;
    Numbers undone_;
    std::optional<Numbers> given_up_;
    std::size_t failures_heard_ = 0;
    std::size_t said_heard_ = 0;
    int last_number_ = 0;
    int departures_ = 0;
    int departures_with_corrections_ = 0;
    bool leaving_ = false;
    bool closed_ = false;
};

TEST(AnyOrder, of_clicks_loses_no_correction) {
    testing::need_event_loop();
    int departures = 0, with_corrections = 0;
    for (unsigned seed = 1; seed <= 120 && !::testing::Test::HasFailure(); ++seed) {
        AnyOrder person(seed);
        person.run();
        departures += person.departures();
        with_corrections += person.departures_with_corrections();
        EXPECT_FALSE(::testing::Test::HasFailure()) << "seed " << seed << ": " << person.story();
    }
    // The test is about them.
    EXPECT_GT(departures, 200);
    EXPECT_GT(with_corrections, 50);
}

}  // namespace
}  // namespace hepatica
