// SPDX-License-Identifier: GPL-3.0-or-later
// Reads and writes models as JSON, and checks every value of a model that is read.
#include "core/links/link_model.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <string_view>
#include <vector>

#include "core/base/atomic_write.h"
#include "core/base/error.h"
#include "core/base/json_number.h"
#include "core/base/json_problem.h"
#include "core/base/number_text.h"
#include "core/base/program_files.h"
#include "core/base/text_file.h"

namespace hepatica {

namespace {

constexpr std::string_view format_name = "hepatica-links";
constexpr int format_version = 1;
const std::string remedy = "Give a model that hepatica-cli train has made, or none";

ForestNode node_of(const nlohmann::json& json, const std::string& place) {
    if (json.size() == 1) return {-1, json.at(0).get<double>(), -1, -1};
    const ForestNode node{whole_number<int>(json.at(0)), json.at(1).get<double>(),
                          whole_number<int>(json.at(2)), whole_number<int>(json.at(3))};
    if (node.feature < 0 || json.size() != 4)
        throw InputError("holds the node " + json.dump(), place, remedy);
    return node;
}

void require_format(const nlohmann::json& json, const std::string& place) {
    if (json.value("format", "") != format_name)
        throw InputError("is no model of links", place, remedy);
    if (const int version = whole_number<int>(json.at("version")); version != format_version)
        throw InputError("has version " + std::to_string(version) + " instead of " +
                             std::to_string(format_version),
                         place, remedy);
    const auto names = json.at("features").get<std::vector<std::string>>();
    if (!std::ranges::equal(names, piece_feature_names))
        throw InputError("was made for other features than this program measures", place, remedy);
}

void require_between(const char* name, double value, double low, double high,
                     const std::string& place) {
    if (!(value >= low && value <= high))
        throw InputError(std::string(name) + " is " + number_text(value) + ", not from " +
                             number_text(low) + " to " + number_text(high),
                         place, remedy);
}

LinkModel model_of(const nlohmann::json& json, const std::string& place) {
    require_format(json, place);
    LinkModel model;
    model.made_by = json.at("made_by").get<std::string>();
    model.line_share = json.at("line_share").get<double>();
    model.kept_share = json.at("kept_share").get<double>();
    require_between("line_share", model.line_share, 0.3, 1.5, place);
    require_between("kept_share", model.kept_share, 0.0, 1.0, place);
    for (const auto& nodes : json.at("trees")) {
        std::vector<ForestNode>& tree = model.forest.trees.emplace_back();
        for (const auto& node : nodes) tree.push_back(node_of(node, place));
    }
    if (model.forest.trees.empty()) throw InputError("holds no tree", place, remedy);
    validate(model.forest, place);
    return model;
}

std::string text_of(const ForestNode& node) {
    if (node.feature < 0) return "[" + number_text(node.value) + "]";
    return "[" + std::to_string(node.feature) + "," + number_text(node.value) + "," +
           std::to_string(node.up_to) + "," + std::to_string(node.above) + "]";
}

}  // namespace

LinkModel read_link_model(const std::filesystem::path& file) {
    const std::string text = read_text_file(file, remedy);
    try {
        return model_of(nlohmann::json::parse(text), file.string());
    } catch (const nlohmann::json::exception& error) {
        throw InputError(json_problem(error), file.string(), remedy);
    }
}

void write_link_model(const std::filesystem::path& file, const LinkModel& model) {
    nlohmann::ordered_json names = nlohmann::json::array();
    for (const std::string_view name : piece_feature_names) names.push_back(std::string(name));
    std::string text = "{\"format\": \"" + std::string(format_name) +
                       "\", \"version\": " + std::to_string(format_version) +
                       ",\n\"made_by\": " + nlohmann::json(model.made_by).dump() +
                       ",\n\"line_share\": " + number_text(model.line_share) +
                       ", \"kept_share\": " + number_text(model.kept_share) +
                       ",\n\"features\": " + names.dump() + ",\n\"trees\": [\n";
    for (std::size_t t = 0; t < model.forest.trees.size(); ++t) {
        text += t == 0 ? "[" : ",\n[";
        const auto& tree = model.forest.trees[t];
        for (std::size_t i = 0; i < tree.size(); ++i)
            text += (i == 0 ? "" : ",") + text_of(tree[i]);
        text += "]";
    }
    write_text_atomically(file, text + "]}\n");
}

std::filesystem::path shipped_link_model() {
    return asset("models/links.json");
}

}  // namespace hepatica
