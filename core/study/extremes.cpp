// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/extremes.h"

#include "core/base/error.h"
#include "core/study/extreme_cases.h"

namespace hepatica {

std::vector<ExtremeCase> extreme_cases() {
    std::vector<ExtremeCase> cases;
    add_beam_grid(cases);
    add_contrast_and_shape_cases(cases);
    add_tool_cases(cases);
    add_obstacle_cases(cases);
    add_long_runs(cases);
    add_refusals(cases);
    return cases;
}

std::vector<ExtremeRow> run_extremes(const std::vector<ExtremeCase>& cases,
                                     const std::string& filter, Job& job) {
    std::vector<ExtremeCase> chosen;
    for (const ExtremeCase& extreme : cases)
        if (extreme.name.find(filter) != std::string::npos) chosen.push_back(extreme);
    std::vector<ExtremeRow> rows;
    job.begin_stage("extremes");
    for (const ExtremeCase& extreme : chosen) {
        job.advance(static_cast<double>(rows.size()) / static_cast<double>(chosen.size()));
        ExtremeRow row;
        try {
            row = extreme.run(job.stop_token());
        } catch (const Error& refusal) {
            row.note = std::string("refused: ") + refusal.what();
        }
        row.name = extreme.name;
        row.survived = row.refused || row.note.empty();
        rows.push_back(std::move(row));
    }
    return rows;
}

}  // namespace hepatica
