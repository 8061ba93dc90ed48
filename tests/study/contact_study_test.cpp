// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/contact_study.h"

#include <gtest/gtest.h>

namespace hepatica {
namespace {

TEST(ContactStudy, EndsEachKindWithItsFirstRowThatIsNotInTime) {
    Job job;
    ContactStudyOptions options{.steps = 5, .to_budget = true};
    options.budget_ms = 0.0;
    const auto rows = study_contacts(options, job);
    ASSERT_EQ(rows.size(), 2u);
    EXPECT_EQ(rows[0].kind, "self");
    EXPECT_EQ(rows[1].kind, "tool");
    for (const ContactRow& row : rows) {
        EXPECT_GT(row.contacts, 0);
        EXPECT_GT(row.step_ms, 0.0);
        EXPECT_LE(row.step_ms, row.step_ms_p95);
        EXPECT_FALSE(row.in_time);
        EXPECT_EQ(row.rows, row.contacts * (row.kind == "tool" ? 3 : 1));
        EXPECT_EQ(row.rows_as_published(), 6 * row.contacts);
    }
    EXPECT_EQ(most_in_time(rows, "tool").contacts, 0);
}

TEST(ContactStudy, TheMostInTimeIsOfItsKindAndInTime) {
    const auto row = [](const char* kind, int contacts, bool in_time) {
        ContactRow made;
        made.kind = kind;
        made.contacts = contacts;
        made.in_time = in_time;
        return made;
    };
    const std::vector<ContactRow> rows{row("self", 30, true), row("self", 45, true),
                                       row("self", 40, true), row("self", 90, false),
                                       row("tool", 400, true)};
    EXPECT_EQ(most_in_time(rows, "self").contacts, 45);
    EXPECT_EQ(most_in_time(rows, "tool").contacts, 400);
    EXPECT_EQ(most_in_time(rows, "none").contacts, 0);
}

// 128 points are 768 constraints.
TEST(ContactStudy, CountsConstraintsAsThePaperDoes) {
    ContactRow row;
    row.contacts = 128;
    EXPECT_EQ(row.rows_as_published(), 768);
}

}  // namespace
}  // namespace hepatica
