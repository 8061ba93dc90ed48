// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/contact_study.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/study/touching_blocks.h"

namespace hepatica {
namespace {

TEST(ContactStudy, EndsEachKindWithItsFirstRowThatIsNotInTime) {
    Job job;
    ContactStudyOptions options{.steps = 5, .to_budget = true};
    options.budget_ms = 0.0;
    const auto rows = study_contacts(options, job);
    ASSERT_EQ(rows.size(), 3u);
    EXPECT_EQ(rows[0].kind, "self");
    EXPECT_EQ(rows[1].kind, "vessels");
    EXPECT_EQ(rows[2].kind, "tool");
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

// The bodies of the rows "vessels" differ in what touches, not in size.
TEST(ContactStudy, BarsLieAlongEachOtherWithTheSameTetrahedra) {
    for (const int along : {6, 48, 96}) {
        const TouchingBlocks bars = bar_along_bar(192 - along, along);
        const auto& vertices = bars.body.mesh.vertices_mm;
        const auto upper = vertices.begin() + bars.first_of_block;
        const auto z = [](const Vec3& a, const Vec3& b) { return a.z() < b.z(); };
        const auto x = [](const Vec3& a, const Vec3& b) { return a.x() < b.x(); };
        EXPECT_EQ(bars.body.mesh.tetrahedra.size(), 10368u);
        EXPECT_NEAR(std::min_element(upper, vertices.end(), z)->z() -
                        std::max_element(vertices.begin(), upper, z)->z(),
                    study_gap_mm, 1e-12);
        EXPECT_NEAR(std::max_element(upper, vertices.end(), x)->x() -
                        std::min_element(upper, vertices.end(), x)->x(),
                    along * study_cell_mm, 1e-9);
        EXPECT_EQ(std::ranges::count(bars.body.fixed, 1), 4 * (193 - along));
    }
}

// 128 points are 768 constraints.
TEST(ContactStudy, CountsConstraintsAsThePaperDoes) {
    ContactRow row;
    row.contacts = 128;
    EXPECT_EQ(row.rows_as_published(), 768);
}

}  // namespace
}  // namespace hepatica
