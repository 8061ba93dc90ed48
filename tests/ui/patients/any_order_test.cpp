// SPDX-License-Identifier: GPL-3.0-or-later
// Whatever a person clicks, in whatever order and however long the jobs take: no correction is lost
// unless it was undone, cancelled, refused with a word, or given up in answer to a question. The
// test keeps its own account of what must be there, from the clicks and from what the person was
// told, and holds screen and disk against it.
#include <gtest/gtest.h>

#include <QTest>
#include <algorithm>
#include <iterator>
#include <random>

#include "tests/ui/patients/fake_ward.h"

namespace hepatica {
namespace {

using testing::edit;
using testing::FakeWard;
using testing::numbers_of;
using Numbers = std::vector<int>;

// Departures of patients, by what they had to lose.
struct Departures {
    int of_saved_corrections = 0;
    int of_given_up_corrections = 0;
    int of_saved_reconstructions = 0;
};

class Person {
  public:
    Person(unsigned seed, Departures& departures) : random_(seed), departures_(departures) {
        ward_.on_question = [this](const std::string&) { answer_question(); };
        ward_.on_word = [this] { listen(); };
        ward_.before_show = [this](bool corrected) {
            if (!corrected) meet_next_patient();
        };
    }

    void click_about() {
        for (int click = 0; click < 80 && !::testing::Test::HasFailure(); ++click) {
            do_something();
            EXPECT_EQ(numbers_of(ward_.workspace().edits()), wanted_);
        }
        EXPECT_TRUE(ward_.finish());
        EXPECT_EQ(numbers_of(ward_.workspace().edits()), wanted_);
        EXPECT_FALSE(ward_.workspace().awaits_body());
        if (!ward_.workspace().dirty()) expect_nothing_to_lose();
    }

    const std::string& story() const { return story_; }

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
                return save();
            case 8:
                return save_as();
            case 9:
                return open_another();
            case 10:
                return close();
            case 11:
                tell("cancel");
                return ward_.keeper().cancel();
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
        if (undone_.empty()) return;
        tell("redo");
        wanted_.push_back(undone_.back());
        undone_.pop_back();
        ward_.keeper().redo();
    }
    void save() {
        tell("save");
        ward_.place = pick(3) == 0 ? std::nullopt : std::optional(some_case());
        ward_.keeper().save();
    }
    void save_as() {
        const std::string name = some_case();
        tell("save as " + name);
        ward_.keeper().save_as(FakeWard::path_of(name));
    }
    void open_another() {
        given_up_.reset();
        if (pick(4) == 0) {
            tell("open built-in");
            return ward_.open_built_in();
        }
        const std::string name = pick(2) == 0 ? some_case() : "ct" + std::to_string(pick(3));
        tell("open " + name);
        ward_.open(name);
    }
    // The end of the program would lose what is not saved now.
    void close() {
        given_up_.reset();
        tell("close");
        ward_.keeper().leave([this] {
            tell("closed");
            expect_nothing_to_lose();
            given_up_.reset();
        });
    }

    void answer_question() {
        const int answer = pick(3);
        ward_.place = pick(3) == 0 ? std::nullopt : std::optional(some_case());
        ward_.answer = answer == 0   ? UnsavedAnswer::save
                       : answer == 1 ? UnsavedAnswer::discard
                                     : UnsavedAnswer::cancel;
        tell(answer == 0 ? "(save)" : answer == 1 ? "(discard)" : "(stay)");
        if (answer == 1) given_up_ = wanted_;
    }

    // What the person was told since: only this may change what must be there beside the clicks.
    void listen() {
        for (; said_heard_ < ward_.said.size(); ++said_heard_) {
            const std::string& said = ward_.said[said_heard_];
            if (said.starts_with("Saved ")) {
                name_ = said.substr(said.rfind('/') + 1);
                never_saved_ = false;
            } else if (said.find("taken back; Redo makes them again") != std::string::npos ||
                       said.starts_with("Cancelled: what was undone is there again")) {
                give_up_what_waits();
            }
        }
        for (; failures_heard_ < ward_.failures.size(); ++failures_heard_)
            if (ward_.failures[failures_heard_].starts_with("Correcting"))
                std::erase_if(wanted_, [](int number) { return number < 0; });
    }

    // What the body lacks can be redone, in its order. Only where nothing of that kind waits is
    // what was undone of the body there again; then what was done after that Undo fits no more.
    void give_up_what_waits() {
        const Numbers made = numbers_of(ward_.workspace().patient()->corrections.edits);
        auto [undone, younger] = std::ranges::mismatch(made, wanted_);
        if (younger != wanted_.end()) {
            std::reverse_copy(younger, wanted_.end(), std::back_inserter(undone_));
            wanted_.erase(younger, wanted_.end());
            return;
        }
        for (; undone != made.end(); ++undone) {
            if (undone_.empty() || undone_.back() != *undone) {
                undone_.clear();
                break;
            }
            undone_.pop_back();
        }
        wanted_ = made;
    }

    void meet_next_patient() {
        expect_nothing_to_lose();
        given_up_.reset();
        const Workspace& next = ward_.workspace();
        tell("now " + next.title());
        name_ = next.folder().filename().string();
        never_saved_ = next.title().starts_with("ct");
        wanted_ = numbers_of(next.edits());
        undone_.clear();
        has_patient_ = true;
    }

    void expect_nothing_to_lose() {
        if (!has_patient_) return;
        if (given_up_ == wanted_) {
            departures_.of_given_up_corrections += wanted_.empty() ? 0 : 1;
        } else if (name_.empty()) {
            EXPECT_TRUE(wanted_.empty()) << "corrections that never were on disk";
            EXPECT_FALSE(never_saved_) << "a reconstruction that never was on disk";
        } else {
            EXPECT_FALSE(never_saved_);
            EXPECT_EQ(ward_.on_disk(name_), wanted_);
            departures_.of_saved_corrections += wanted_.empty() ? 0 : 1;
            departures_.of_saved_reconstructions += wanted_.empty() ? 1 : 0;
        }
    }

    std::mt19937 random_;
    Departures& departures_;
    std::string story_;
    // The account: of the patient that is seen.
    bool has_patient_ = false;
    std::string name_;  // of the case on disk
    bool never_saved_ = false;
    Numbers wanted_;
    Numbers undone_;
    std::optional<Numbers> given_up_;
    std::size_t failures_heard_ = 0;
    std::size_t said_heard_ = 0;
    int last_number_ = 0;
    FakeWard ward_;
};

TEST(AnyOrder, of_clicks_loses_no_correction) {
    Departures departures;
    for (unsigned seed = 1; seed <= 200 && !::testing::Test::HasFailure(); ++seed) {
        Person person(seed, departures);
        person.click_about();
        EXPECT_FALSE(::testing::Test::HasFailure()) << "seed " << seed << ": " << person.story();
    }
    // They are what the test is about.
    EXPECT_GT(departures.of_saved_corrections, 40);
    EXPECT_GT(departures.of_given_up_corrections, 30);
    EXPECT_GT(departures.of_saved_reconstructions, 10);
}

}  // namespace
}  // namespace hepatica
