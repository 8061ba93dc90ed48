// SPDX-License-Identifier: GPL-3.0-or-later
// The paper's table of contacts: time of a step over the number of contacts. A block rests on a
// slab (self), a bar along another (vessels), or a slab on a ball (tool), under gravity. The
// touching area grows from row to row; the tetrahedra grow with the block on the slab, and stay the
// same in the other rows.
#pragma once

#include <string>
#include <vector>

#include "core/base/job.h"

namespace hepatica {

struct ContactStudyOptions {
    int steps = 30;  // measured, after 60 steps in which the bodies come to rest
    int threads = 2;
    double budget_ms = 16.7;  // limit of a step in time
    bool to_budget = false;   // stop each kind at its first row that is not in time
};

struct ContactRow {
    std::string kind;      // "self", "vessels" or "tool"
    int contacts = 0;      // contact points in a tool's pad, or pairs of surface features
    int rows = 0;          // constraint rows: the normal one, and against a tool two of friction
    double step_ms = 0.0;  // median; see FrameTime::cost_ms
    double step_ms_p95 = 0.0;
    double linear_iterations = 0.0;
    bool in_time = false;  // whether the median step is
    int tetrahedra = 0;

    // Six constraints per contact point, as the paper counts them.
    int rows_as_published() const { return 6 * contacts; }
};

// Begins three stages of the job. Throws Cancelled.
std::vector<ContactRow> study_contacts(const ContactStudyOptions& options, Job& job);

// The row of this kind with the most contacts among those in time; all 0 where there is none.
ContactRow most_in_time(const std::vector<ContactRow>& rows, const std::string& kind);

}  // namespace hepatica
