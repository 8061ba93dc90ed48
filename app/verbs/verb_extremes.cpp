// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <memory>

#include "app/verbs/verbs.h"
#include "core/base/error.h"
#include "core/study/extremes.h"

namespace hepatica {

namespace {

Json json_row(const ExtremeRow& row) {
    Json json{{"name", row.name},
              {"survived", row.survived},
              {"refused", row.refused},
              {"energy_made", row.energy_made},
              {"touched_steps", row.touched_steps},
              {"splits", row.splits},
              {"inverted_splits", row.inverted_splits},
              {"touching_splits", row.touching_splits},
              {"degraded_steps", row.degraded_steps},
              {"audit_gap", row.audit_gap},
              {"unresolved_steps", row.unresolved_steps}};
    if (!row.reference.empty()) {
        json["error"] = row.error;
        json["reference"] = row.reference;
    }
    if (!row.note.empty()) json["note"] = row.note;
    return json;
}

}  // namespace

void add_extremes(CommandLine& line) {
    const auto filter = std::make_shared<std::string>();
    const auto suite = std::make_shared<std::string>("stability");
    const auto campaign = std::make_shared<Campaign>();
    CLI::App& verb =
        line.add_verb("extremes", "The stability suite: bodies and scenes at the edge, a row each",
                      [filter, suite, campaign](Job& job) {
                          Json rows = Json::array(), failed = Json::array();
                          int survived = 0, splits = 0;
                          job.expect_stages(1);
                          const auto cases = *suite == "touch"  ? touch_cases(*campaign)
                                             : *suite == "tear" ? tear_cases(*campaign)
                                                                : extreme_cases();
                          for (const ExtremeRow& row : run_extremes(cases, *filter, job)) {
                              rows.push_back(json_row(row));
                              survived += row.survived;
                              splits += row.splits;
                              if (!row.survived)
                                  failed.push_back({{"name", row.name}, {"note", row.note}});
                          }
                          if (rows.empty())
                              throw InputError("no row's name contains \"" + *filter + "\"",
                                               "--filter", "Leave it out to see all names");
                          return Json{{"cases", rows.size()},
                                      {"survived", survived},
                                      {"splits", splits},
                                      {"failed", failed},
                                      {"rows", rows}};
                      });
    verb.add_option("--suite", *suite,
                    "stability, or a campaign on random trees: touch (in contact) or tear")
        ->check(CLI::IsMember({"stability", "touch", "tear"}))
        ->capture_default_str();
    verb.add_option("--seed", campaign->seed, "Of the campaign")->capture_default_str();
    verb.add_option("--trials", campaign->trials, "Of the campaign")
        ->check(CLI::Range(1, 1000000))
        ->capture_default_str();
    verb.add_option("--steps", campaign->steps, "Of each trial of the campaign")
        ->check(CLI::Range(1, 1000000))
        ->capture_default_str();
    verb.add_option("--filter", *filter, "Only rows whose name contains this");
}

}  // namespace hepatica
