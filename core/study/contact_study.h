// SPDX-License-Identifier: GPL-3.0-or-later
// The paper's table of contacts: how long a step takes with more and more of them. A block rests on
// another (self), or a slab on a ball (tool), under its weight; the touching area grows from row to
// row, the tetrahedra do not.
#pragma once

#include <string>
#include <vector>

#include "core/base/job.h"

namespace hepatica {

struct ContactStudyOptions {
    int steps = 30;  // measured, after the bodies have come to rest
    int threads = 2;
    double budget_ms = 16.7;  // of a step in time
    bool to_budget = false;   // each kind ends with its first row that is not in time
};

struct ContactRow {
    std::string kind;      // "self" or "tool"
    int contacts = 0;      // points in a tool's pad, or pairs of features of surfaces
    int rows = 0;          // of constraint: the normal, and against a tool two of friction
    double step_ms = 0.0;  // median; see FrameTime::cost_ms
    double step_ms_p95 = 0.0;
    double linear_iterations = 0.0;
    bool in_time = false;  // the median step is
    int tetrahedra = 0;

    // Six constraints a point, as the paper counts them.
    int rows_as_published() const { return 6 * contacts; }
};

// Begins two stages of the job. Throws Cancelled.
std::vector<ContactRow> study_contacts(const ContactStudyOptions& options, Job& job);

// The row with the most contacts in time; all 0 where none is. `kind` as above.
ContactRow most_in_time(const std::vector<ContactRow>& rows, const std::string& kind);

}  // namespace hepatica
