// SPDX-License-Identifier: GPL-3.0-or-later
// extremes: the stability suite and its campaigns, one row per case (core/study/extremes.h).
#include <spdlog/spdlog.h>

#include <memory>
#include <string>

#include "app/verbs/verbs.h"
#include "core/base/error.h"
#include "core/patient/patient_case.h"
#include "core/scene/deform_part.h"
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

struct ExtremesChoices {
    std::vector<const CLI::Option*> of_campaigns;  // that no suite but a campaign has
    std::string filter;
    std::string suite = "stability";
    Campaign campaign;
    std::vector<std::string> patients;
    bool verify = false;
};

// The body that a scene makes of the patient.
std::shared_ptr<const BodyDescription> body_of_case(const std::string& place) {
    const DeformPart part(read_case_without_voxels(place), DeformSpec{});
    return std::make_shared<const BodyDescription>(part.body());
}

std::vector<ExtremeCase> cases_of(const ExtremesChoices& choices) {
    if (choices.suite == "stability") {
        for (const CLI::Option* option : choices.of_campaigns)
            if (option->count() > 0)
                throw UsageError("is for a campaign alone", option->get_name(),
                                 "Give --suite touch or tear, too, or leave it out");
        return extreme_cases();
    }
    Campaign campaign = choices.campaign;
    for (const std::string& place : choices.patients)
        campaign.patients.push_back(body_of_case(place));
    return choices.suite == "touch" ? touch_cases(campaign) : tear_cases(campaign);
}

Json run_suite(const ExtremesChoices& choices, Job& job) {
    Json rows = Json::array(), failed = Json::array();
    int survived = 0, splits = 0;
    job.expect_stages(1);
    for (const ExtremeRow& row : run_extremes(cases_of(choices), choices.filter, job)) {
        rows.push_back(json_row(row));
        survived += row.survived;
        splits += row.splits;
        if (row.survived) continue;
        failed.push_back({{"name", row.name}, {"note", row.note}});
        if (choices.verify) spdlog::error("{}: {}", row.name, row.note);
    }
    if (rows.empty())
        throw InputError("no row's name contains \"" + choices.filter + "\"", "--filter",
                         "Leave it out to see all names");
    if (choices.verify && !failed.empty())
        throw InputError(
            std::to_string(failed.size()) + " of " + std::to_string(rows.size()) + " rows fail",
            "the suite", "Without --verify their numbers are told");
    return Json{{"cases", rows.size()},
                {"survived", survived},
                {"splits", splits},
                {"failed", failed},
                {"rows", rows}};
}

}  // namespace

void add_extremes(CommandLine& line) {
    auto choices = std::make_shared<ExtremesChoices>();
    CLI::App& verb =
        line.add_verb("extremes", "The stability suite: bodies and scenes at the edge, a row each",
                      [choices](Job& job) { return run_suite(*choices, job); });
    verb.add_option("--suite", choices->suite,
                    "stability, or a campaign on random trees: touch (in contact) or tear")
        ->check(CLI::IsMember({"stability", "touch", "tear"}))
        ->capture_default_str();
    choices->of_campaigns = {
        verb.add_option("--seed", choices->campaign.seed, "Of the campaign")
            ->check(whole_number_from(0))
            ->capture_default_str(),
        verb.add_option("--trials", choices->campaign.trials, "Of the campaign")
            ->check(CLI::Range(1, 1000000))
            ->capture_default_str(),
        verb.add_option("--steps", choices->campaign.steps, "Of each trial of the campaign")
            ->check(CLI::Range(1, 1000000))
            ->capture_default_str(),
        verb.add_option("--case", choices->patients,
                        "A case that the campaign is played on in the place of random trees; "
                        "several take turns"),
        verb.add_flag("--touching", choices->campaign.touching,
                      "Surfaces touch each other in the campaign of tears, as they always do in "
                      "that of touch")};
    verb.add_option("--filter", choices->filter, "Only rows whose name contains this");
    verb.add_flag("--verify", choices->verify, "Fail (exit code 1) where a row does");
}

}  // namespace hepatica
