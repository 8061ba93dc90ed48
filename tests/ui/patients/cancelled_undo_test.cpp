// SPDX-License-Identifier: GPL-3.0-or-later
// Cancel while an Undo is still being made: the list of corrections, the vessels and what Undo and
// Redo lead to stay in agreement, and never is there a state that nobody has made.
#include <gtest/gtest.h>

#include <QTest>
#include <random>
#include <set>

#include "tests/ui/patients/keeper_test.h"

namespace hepatica {
namespace {

using testing::KeeperTest;
using testing::numbers_of;
using Numbers = std::vector<int>;

class CancelledUndo : public KeeperTest {
  protected:
    void wait_for_body() {
        ward.hold_corrections = false;
        EXPECT_TRUE(ward.finish());
        ward.hold_corrections = true;
    }
    // Cancels the body that is being made, and waits until that is heard.
    void cancel() {
        const std::size_t before = ward.said.size();
        ward.keeper().cancel();
        EXPECT_TRUE(QTest::qWaitFor([&] { return ward.said.size() > before; }, 20000));
    }
    Numbers of_vessels() const { return numbers_of(ward.workspace().patient()->corrections.edits); }
    // The lists that Redo, again and again, leads to.
    std::vector<Numbers> redone() const {
        std::vector<Numbers> lists;
        for (Workspace copy = ward.workspace(); copy.next_redo();) {
            copy.redo();
            lists.push_back(numbers_of(copy.edits()));
        }
        return lists;
    }
    std::vector<Numbers> undone() const {
        std::vector<Numbers> lists;
        for (Workspace copy = ward.workspace(); copy.next_undo();) {
            copy.undo();
            lists.push_back(numbers_of(copy.edits()));
        }
        return lists;
    }
};

TEST_F(CancelledUndo, takes_back_only_what_is_younger) {
    add(1);
    add(2);
    wait_for_body();
    ward.keeper().undo();
    add(3);
    cancel();
    EXPECT_EQ(edits(), Numbers{1}) << "the Undo is not cancelled";
    EXPECT_TRUE(
        ward.said.back().starts_with("1 correction(s) taken back; Redo makes them again. "
                                     "The Undo before them goes on"))
        << ward.said.back();
    EXPECT_EQ(redone(), (std::vector<Numbers>{{1, 3}}));
    wait_for_body();
    EXPECT_EQ(of_vessels(), Numbers{1});
    EXPECT_EQ(redone(), (std::vector<Numbers>{{1, 3}}));
}

TEST_F(CancelledUndo, comes_back_by_the_next_cancel_with_nothing_that_does_not_follow_it) {
    add(1);
    add(2);
    wait_for_body();
    ward.keeper().undo();
    add(3);
    cancel();
    cancel();
    EXPECT_EQ(edits(), (Numbers{1, 2}));
    EXPECT_EQ(of_vessels(), (Numbers{1, 2}));
    EXPECT_TRUE(redone().empty()) << "1, 2, 3 never was";
    EXPECT_TRUE(ward.said.back().ends_with("cannot be made again")) << ward.said.back();
}

TEST_F(CancelledUndo, leaves_what_was_undone_before_it) {
    for (const int number : {1, 2, 3}) add(number);
    wait_for_body();
    ward.keeper().undo();
    wait_for_body();
    ward.keeper().undo();
    cancel();
    EXPECT_EQ(edits(), (Numbers{1, 2}));
    EXPECT_EQ(redone(), (std::vector<Numbers>{{1, 2, 3}}));
}

TEST_F(CancelledUndo, a_save_that_waits_holds_what_is_left) {
    add(1);
    add(2);
    wait_for_body();
    ward.keeper().undo();
    add(3);
    save_as("b.hep");
    cancel();
    wait_for_body();
    EXPECT_EQ(ward.on_disk("b.hep"), Numbers{1});
}

TEST_F(CancelledUndo, in_any_order_leaves_list_vessels_and_steps_in_agreement) {
    int cancelled_undos = 0, redone_after_cancel = 0;
    for (unsigned seed = 1; seed <= 60 && !HasFailure(); ++seed) {
        std::mt19937 random(seed);
        std::string story;
        std::set<Numbers> were;
        bool after_cancel = false;
        ward.open("ct");
        ASSERT_TRUE(ward.finish());
        ward.hold_corrections = true;
        were.insert(edits());
        for (int number = 1; number <= 40; ++number) {
            const int deed = static_cast<int>(random() % 10);
            const Numbers before = edits();
            const bool waited = ward.workspace().awaits_body();
            if (deed < 3) {
                story += "add " + std::to_string(number) + "; ";
                add(number);
                were.insert(edits());
                after_cancel = false;
            } else if (deed < 6) {
                story += "undo; ";
                ward.keeper().undo();
            } else if (deed == 6) {
                story += "redo; ";
                ward.keeper().redo();
                redone_after_cancel += after_cancel && edits() != before;
            } else if (deed < 9) {
                if (!waited) continue;
                story += "cancel; ";
                cancelled_undos += of_vessels().size() > before.size();
                cancel();
                after_cancel = true;
            } else {
                story += "wait; ";
                wait_for_body();
            }
            EXPECT_TRUE(were.contains(edits())) << "seed " << seed << ": " << story;
            for (const auto& lists : {undone(), redone()})
                for (const Numbers& list : lists)
                    EXPECT_TRUE(were.contains(list)) << "seed " << seed << ": " << story;
            if (!ward.keeper().makes_vessels()) {
                EXPECT_EQ(edits(), of_vessels()) << "seed " << seed << ": " << story;
                EXPECT_FALSE(ward.workspace().awaits_body());
            }
            if (HasFailure()) break;
        }
        wait_for_body();
        EXPECT_EQ(edits(), of_vessels()) << "seed " << seed << ": " << story;
        ward.answer = UnsavedAnswer::discard;
    }
    EXPECT_GT(cancelled_undos, 30);
    EXPECT_GT(redone_after_cancel, 10);
}

}  // namespace
}  // namespace hepatica
