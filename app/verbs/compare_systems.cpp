// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/verbs/compare_systems.h"

#include <algorithm>
#include <cmath>

#include "app/verbs/truth_place.h"
#include "core/accuracy/system_scores.h"
#include "core/base/error.h"
#include "core/image/volume_reader.h"
#include "core/patient/patient_case.h"
#include "core/tree/files/tree_json.h"

namespace hepatica {

namespace fs = std::filesystem;

namespace {

struct NamedMask {
    VascularSystem system;
    fs::path file;
};

std::vector<NamedMask> parse(const std::vector<std::string>& texts) {
    std::vector<NamedMask> masks;
    for (const std::string& text : texts) {
        if (!names_a_system(text))
            throw UsageError("\"" + text + "\" does not say which vessels it holds", "--truth-mask",
                             "Give NAME=FILE with portal, hepatic or artery as the name, or add "
                             "--truth-tree");
        const std::size_t sign = text.find('=');
        if (sign + 1 == text.size())
            throw UsageError("\"" + text + "\" names no file", "--truth-mask",
                             "Give NAME=FILE: the mask of these vessels");
        masks.push_back({*system_named(text.substr(0, sign)), text.substr(sign + 1)});
    }
    return masks;
}

void unite(Mask& mask, const Mask& with) {
    for (std::size_t i = 0; i < mask.voxels.size(); ++i) mask.voxels[i] |= with.voxels[i];
}

// Several masks of one system are united.
std::vector<SystemTruth> read_truths(const std::vector<NamedMask>& masks,
                                     const PatientCase& patient, const fs::path& place, Job& job) {
    std::vector<SystemTruth> truths;
    for (const NamedMask& named : masks) {
        Mask mask = read_mask(named.file, job);
        require_overlap(box_of(patient.tree), place, box_of(mask), named.file);
        if (!truths.empty())
            mask = on_grid_of(truths[0].mask.grid, std::move(mask), named.file.string());
        const auto same = std::ranges::find(truths, named.system, &SystemTruth::system);
        if (same == truths.end())
            truths.push_back({named.system, std::move(mask), {}});
        else
            unite(same->mask, mask);
    }
    return truths;
}

std::optional<Mask> read_organ(const fs::path& file, const Grid& grid, Job& job) {
    if (file.empty()) return std::nullopt;
    return on_grid_of(grid, read_mask(file, job), file.string());
}

Json value_of(std::optional<double> value) {
    return value ? Json(*value) : Json();
}

Json score_of(const SystemScore& score) {
    Json by_radius = Json::array();
    for (const RadiusClass& size : score.by_radius)
        by_radius.push_back({{"from_mm", size.from_mm},
                             {"to_mm", std::isfinite(size.to_mm) ? Json(size.to_mm) : Json()},
                             {"truth_length_mm", size.truth_length_mm},
                             {"tree_length_mm", size.tree_length_mm},
                             {"length_recall", value_of(size.length_recall)},
                             {"length_precision", value_of(size.length_precision)}});
    return {{"length_recall", score.length_recall},
            {"length_precision", score.length_precision},
            {"surface_dice", value_of(score.surface_dice)},
            {"dice", value_of(score.dice)},
            {"root_error_mm", value_of(score.root_error_mm)},
            {"trunk_at_mm", score.trunk_at_mm ? Json(json_of(*score.trunk_at_mm)) : Json()},
            {"truth_length_mm", score.truth_length_mm},
            {"tree_length_mm", score.tree_length_mm},
            {"by_radius", std::move(by_radius)}};
}

}  // namespace

bool names_a_system(const std::string& truth_mask) {
    const std::size_t sign = truth_mask.find('=');
    if (sign == std::string::npos) return false;
    const auto system = system_named(truth_mask.substr(0, sign));
    return system && *system != VascularSystem::unknown;
}

Json compare_systems(const SystemsToCompare& request, Job& job) {
    const std::vector<NamedMask> masks = parse(request.truth_masks);
    job.expect_stages(static_cast<int>(masks.size()) + !request.liver_mask.empty() +
                      !request.cava_mask.empty() + 1);
    const PatientCase patient = read_case(request.patient);
    const std::vector<SystemTruth> truths = read_truths(masks, patient, request.patient, job);
    const Grid& grid = truths[0].mask.grid;
    const std::optional<Mask> liver = read_organ(request.liver_mask, grid, job);
    const std::optional<Mask> cava = read_organ(request.cava_mask, grid, job);
    job.begin_stage("Comparing");
    const SystemScores scores =
        judge_systems(patient.tree, patient.mask, truths, liver ? &*liver : nullptr,
                      cava ? &*cava : nullptr, {}, job);
    Json systems = Json::object();
    for (const SystemScore& score : scores.systems)
        systems[name_of(score.system)] = score_of(score);
    Json vessels = score_of(scores.vessels);
    for (const char* of_one_system : {"root_error_mm", "trunk_at_mm"}) vessels.erase(of_one_system);
    return {{"systems", std::move(systems)},
            {"vessels", std::move(vessels)},
            {"system_right", scores.system_right},
            {"attributed_mm", scores.attributed_mm},
            {"false_joins", scores.false_joins},
            {"breaks", scores.breaks},
            {"loops", scores.loops}};
}

Json tables_of_systems(const Json& answer) {
    Json rows = Json::array(), sizes = Json::array();
    const auto add = [&](const std::string& name, const Json& score) {
        Json row{{"vessels", name}};
        for (const auto& [key, value] : score.items())
            if (key != "by_radius") row[key] = value;
        rows.push_back(std::move(row));
        for (const Json& size : score.at("by_radius")) {
            Json line{{"vessels", name}};
            line.update(size);
            sizes.push_back(std::move(line));
        }
    };
    for (const auto& [name, score] : answer.at("systems").items()) add(name, score);
    add("all", answer.at("vessels"));
    Json table{{"systems", std::move(rows)}, {"by_radius", std::move(sizes)}};
    for (const char* key : {"system_right", "attributed_mm", "false_joins", "breaks", "loops"})
        table[key] = answer.at(key);
    return table;
}

}  // namespace hepatica
