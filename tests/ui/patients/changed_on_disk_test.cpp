// SPDX-License-Identifier: GPL-3.0-or-later
// A case that another program has changed, moved or removed while it was open: nobody's work is
// replaced without a question, and none is lost.
#include "tests/ui/patients/keeper_test.h"

namespace hepatica {
namespace {

using testing::edit;
using testing::FakeWard;
using Numbers = std::vector<int>;

// Correction 1 is not saved, and another program has saved correction 5 in the same folder.
class ChangedOnDisk : public testing::KeeperTest {
  protected:
    ChangedOnDisk() {
        add(1);
        EXPECT_TRUE(ward.finish());
        ward.save_by_another("a.hep", {edit(5)});
    }
    void save_with(ChangedAnswer answer) {
        ward.changed_answer = answer;
        ward.keeper().save();
        ASSERT_TRUE(ward.finish());
    }
};

TEST_F(ChangedOnDisk, stays_as_it_is_where_the_user_cancels) {
    save_with(ChangedAnswer::cancel);
    EXPECT_EQ(ward.changed_asked, std::vector<std::string>{"a.hep"});
    EXPECT_EQ(ward.on_disk("a.hep"), Numbers{5});
    EXPECT_TRUE(ward.workspace().dirty());
    EXPECT_EQ(ward.said.back(), "Not saved");
}

TEST_F(ChangedOnDisk, is_replaced_where_the_user_says_so_and_then_known) {
    save_with(ChangedAnswer::replace);
    EXPECT_EQ(ward.on_disk("a.hep"), Numbers{1});
    EXPECT_FALSE(ward.workspace().dirty());
    add(2);
    save_with(ChangedAnswer::cancel);
    EXPECT_EQ(ward.on_disk("a.hep"), (Numbers{1, 2}));
    EXPECT_EQ(ward.changed_asked.size(), 1u) << "it is this program's own by then";
}

TEST_F(ChangedOnDisk, is_kept_beside_the_own_work_under_another_name) {
    ward.place = "b.hep";
    save_with(ChangedAnswer::save_as);
    EXPECT_EQ(ward.on_disk("a.hep"), Numbers{5});
    EXPECT_EQ(ward.on_disk("b.hep"), Numbers{1});
    EXPECT_EQ(ward.workspace().folder(), FakeWard::path_of("b.hep"));
    EXPECT_FALSE(ward.workspace().dirty());
}

TEST_F(ChangedOnDisk, stays_as_it_is_where_no_other_name_is_given) {
    save_with(ChangedAnswer::save_as);
    EXPECT_EQ(ward.places_asked, 1);
    EXPECT_EQ(ward.on_disk("a.hep"), Numbers{5});
    EXPECT_TRUE(ward.workspace().dirty());
}

TEST_F(ChangedOnDisk, is_asked_about_again_where_it_changes_once_more) {
    save_with(ChangedAnswer::replace);
    add(2);
    ASSERT_TRUE(ward.finish());
    ward.save_by_another("a.hep", {edit(6)});
    save_with(ChangedAnswer::cancel);
    EXPECT_EQ(ward.changed_asked.size(), 2u);
    EXPECT_EQ(ward.on_disk("a.hep"), Numbers{6});
}

TEST_F(ChangedOnDisk, keeps_the_user_from_leaving_unless_he_decides) {
    ward.answer = UnsavedAnswer::save;
    ward.leave();
    ASSERT_TRUE(ward.finish());
    EXPECT_FALSE(ward.left);
    EXPECT_EQ(ward.on_disk("a.hep"), Numbers{5});
    ward.changed_answer = ChangedAnswer::replace;
    ward.leave();
    ASSERT_TRUE(ward.finish());
    EXPECT_TRUE(ward.left);
    EXPECT_EQ(ward.on_disk("a.hep"), Numbers{1});
}

TEST_F(ChangedOnDisk, is_known_once_it_is_opened_anew) {
    ward.answer = UnsavedAnswer::discard;
    ward.open("a.hep");
    ASSERT_TRUE(ward.finish());
    add(6);
    save_with(ChangedAnswer::cancel);
    EXPECT_EQ(ward.on_disk("a.hep"), (Numbers{5, 6}));
    EXPECT_TRUE(ward.changed_asked.empty());
    ward.save_by_another("a.hep", {});
    add(7);
    save_with(ChangedAnswer::cancel);
    EXPECT_EQ(ward.on_disk("a.hep"), Numbers{});
    EXPECT_EQ(ward.changed_asked.size(), 1u) << "also of one that was opened";
}

// Unsaved work of a program that died, on what the other has saved since.
TEST_F(ChangedOnDisk, is_asked_about_where_work_on_what_was_there_before_is_taken_up) {
    ward.answer = UnsavedAnswer::discard;
    for (const std::string& known :
         {ward.digest("a.hep"), std::string("of what was there"), std::string()}) {
        ward.changed_asked.clear();
        const bool same = known == ward.digest("a.hep");
        OpenRequest request;
        request.reconstruct.ct = FakeWard::path_of("a.hep");
        request.left_edits = LeftEdits{{edit(1), edit(2)}, {}, 0, "edits.jsonl", {}, known};
        ward.keeper().open(request);
        ASSERT_TRUE(ward.finish());
        save_with(ChangedAnswer::cancel);
        EXPECT_EQ(ward.changed_asked.size(), same ? 0u : 1u) << known;
        EXPECT_EQ(ward.on_disk("a.hep"), same ? (Numbers{1, 2}) : Numbers{5}) << known;
        ward.save_by_another("a.hep", {edit(5)});
    }
}

TEST_F(ChangedOnDisk, is_not_asked_about_where_the_work_is_saved_elsewhere) {
    save_as("b.hep");
    ASSERT_TRUE(ward.finish());
    EXPECT_TRUE(ward.changed_asked.empty());
    EXPECT_EQ(ward.on_disk("a.hep"), Numbers{5});
    EXPECT_EQ(ward.on_disk("b.hep"), Numbers{1});
}

TEST_F(ChangedOnDisk, is_made_anew_with_a_word_where_it_is_gone) {
    ward.remove_by_another("a.hep");
    save_with(ChangedAnswer::cancel);
    EXPECT_TRUE(ward.changed_asked.empty());
    EXPECT_EQ(ward.on_disk("a.hep"), Numbers{1});
    EXPECT_EQ(ward.said.back(), "/disk/a.hep was not there any more: it was saved anew");
    save_with(ChangedAnswer::cancel);
    EXPECT_EQ(ward.said.back(), "Saved /disk/a.hep");
}

}  // namespace
}  // namespace hepatica
