// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/standing_warnings.h"

#include <algorithm>
#include <utility>

#include "core/flow/flow_shares.h"
#include "core/mesh/manifold_attempts.h"
#include "core/patient/corrections.h"
#include "ui/window_words.h"

namespace hepatica {
namespace {

bool holds(const std::vector<std::string>& list, const std::string& text) {
    return std::ranges::find(list, text) != list.end();
}

}  // namespace

std::vector<std::string> said_of_vessels(const PatientCase& patient) {
    if (patient.tree.segments.empty()) return {};
    std::vector<std::string> said = warnings_of_ends(patient.tree, flow_shares(patient.tree));
    for (const auto& doubts : {doubts_of_links(patient), sentences(patient.doubts, patient.tree)})
        for (const std::string& doubt : doubts) said.push_back(in_window_words(doubt));
    for (const std::string& warning : patient.warnings)
        if (is_of_unclosed(warning)) said.push_back(in_window_words(warning));
    return said;
}

std::vector<std::string> said_of_remade(const PatientCase& patient,
                                        const std::vector<double>& shares,
                                        std::vector<std::string> warnings) {
    std::vector<std::string> said = warnings_of_ends(patient.tree, shares);
    for (std::string& doubt : doubts_of_links(patient))
        said.push_back(in_window_words(std::move(doubt)));
    for (std::string& warning : warnings) said.push_back(in_window_words(std::move(warning)));
    return said;
}

std::vector<std::string> still_standing(const std::vector<std::string>& told,
                                        const std::vector<std::string>& said_before,
                                        const std::vector<std::string>& said_now) {
    std::vector<std::string> standing;
    for (const std::string& text : said_now)
        if (!holds(said_before, text) && !holds(told, text)) standing.push_back(text);
    for (const std::string& text : told)
        if (!holds(said_before, text) || holds(said_now, text)) standing.push_back(text);
    return standing;
}

}  // namespace hepatica
