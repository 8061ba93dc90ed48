// SPDX-License-Identifier: GPL-3.0-or-later
// bench contacts: steps with growing numbers of contacts (core/study/contact_study.h).
#include <memory>

#include "app/verbs/verbs.h"
#include "core/study/contact_study.h"

namespace hepatica {

namespace {

Json json_row(const ContactRow& row) {
    return {{"backend", "cpu"},
            {"method", row.kind == "tool" ? "in the matrix" : "conjugate gradients"},
            {"kind", row.kind},
            {"contacts", row.contacts},
            {"rows", row.rows},
            {"rows_as_the_paper_counts", row.rows_as_published()},
            {"step_ms", row.step_ms},
            {"step_ms_p95", row.step_ms_p95},
            {"linear_iterations", row.linear_iterations},
            {"in_time", row.in_time},
            {"tetrahedra", row.tetrahedra},
            {"peer", nullptr},
            {"peer_ms", nullptr}};
}

}  // namespace

void add_bench_contacts(CommandLine& line) {
    const auto options = std::make_shared<ContactStudyOptions>();
    CLI::App& verb = line.add_verb("bench", "Benchmarks", "contacts",
                                   "Steps with more and more contacts, of surfaces and of a tool",
                                   [options](Job& job) {
                                       Json rows = Json::array();
                                       for (const ContactRow& row : study_contacts(*options, job))
                                           rows.push_back(json_row(row));
                                       return Json{{"threads", options->threads}, {"rows", rows}};
                                   });
    verb.add_option("--steps", options->steps, "Measured, after the bodies have come to rest")
        ->check(CLI::Range(5, 100000))
        ->capture_default_str();
    verb.add_option("--threads", options->threads, "Of ours")
        ->check(CLI::Range(1, 256))
        ->capture_default_str();
    verb.add_option("--budget-ms", options->budget_ms, "Of a step in time")
        ->check(CLI::Range(0.01, 1e4))
        ->capture_default_str();
}

}  // namespace hepatica
