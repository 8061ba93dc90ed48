// SPDX-License-Identifier: GPL-3.0-or-later
// Reads and writes trees as JSON.
#include "core/tree/files/tree_json.h"

#include <string>
#include <utility>

#include "core/base/atomic_write.h"
#include "core/base/error.h"
#include "core/base/json_number.h"
#include "core/base/json_problem.h"
#include "core/base/number_text.h"
#include "core/tree/files/tree_files.h"
#include "core/tree/files/tree_io.h"

namespace hepatica {

namespace {

constexpr int tree_version = 1;
constexpr const char* tree_format = "hepatica vessel tree";
constexpr const char* tree_space = "LPS";

// Refuses a file that says to be something else than this program writes. Older files and those
// made by hand may leave "format" and "space" out.
void require_own_format(const nlohmann::json& whole, const std::filesystem::path& file) {
    if (whole.contains("format") && whole["format"] != tree_format)
        throw InputError("is of the format " + whole["format"].dump(), file.string(),
                         std::string("Give a file of the format \"") + tree_format + "\"");
    if (whole_number<int>(whole.at("version")) != tree_version)
        throw InputError("is of version " + whole.at("version").dump(), file.string(),
                         "Write it anew with this program");
    if (whole.contains("space") && whole["space"] != tree_space)
        throw InputError("has its axes in space " + whole["space"].dump(), file.string(),
                         "Turn its positions into LPS and state \"space\": \"LPS\"");
}

VesselNode node_from(const nlohmann::json& value, const std::filesystem::path& file) {
    const VesselNode node{vec3_from(value.at("position_mm")), value.at("radius_mm").get<double>()};
    require_plausible_radius(node.radius_mm, "a node", file.string());
    return node;
}

// Other formats hold each place once; this one may contradict itself. A tenth of a millimetre is
// left to files whose numbers were rounded.
void require_ends_at_nodes(const VesselTree& tree, const std::filesystem::path& file) {
    constexpr double most_mm = 0.1;
    for (std::size_t s = 0; s < tree.segments.size(); ++s) {
        const VesselSegment& segment = tree.segments[s];
        for (const auto& [point_mm, node] :
             {std::pair(segment.points_mm.front(), segment.proximal_node),
              std::pair(segment.points_mm.back(), segment.distal_node)}) {
            const double apart_mm = (point_mm - tree.nodes[node].position_mm).norm();
            if (apart_mm <= most_mm) continue;
            throw InputError(
                "has a segment " + std::to_string(s) + " whose points end " +
                    number_text(apart_mm) + " mm away from its node " + std::to_string(node),
                file.string(), "Let its first and last point be the positions of its nodes");
        }
    }
}

}  // namespace

void write_tree_json(const std::filesystem::path& file, const VesselTree& tree) {
    nlohmann::json nodes = nlohmann::json::array(), segments = nlohmann::json::array();
    for (const VesselNode& node : tree.nodes)
        nodes.push_back(
            {{"position_mm", json_of(node.position_mm)}, {"radius_mm", node.radius_mm}});
    for (const VesselSegment& s : tree.segments) {
        segments.push_back({{"proximal_node", s.proximal_node},
                            {"distal_node", s.distal_node},
                            {"parent", s.parent},
                            {"system", number_of(s.system)},
                            {"system_name", name_of(s.system)},
                            {"confidence", s.system_confidence},
                            {"strahler_order", s.strahler_order},
                            {"closes_loop", s.closes_loop},
                            {"points_mm", json_of(s.points_mm)},
                            {"radii_mm", s.radii_mm}});
        if (!s.bridged.empty()) segments.back()["bridged"] = s.bridged;
    }
    const nlohmann::json whole{{"format", tree_format},
                               {"version", tree_version},
                               {"space", tree_space},
                               {"nodes", std::move(nodes)},
                               {"segments", std::move(segments)}};
    write_text_atomically(file, whole.dump() + "\n");
}

VesselTree read_tree_json(const std::filesystem::path& file) {
    VesselTree tree;
    std::vector<int> unnamed_systems;
    try {
        const nlohmann::json whole = nlohmann::json::parse(read_text(file));
        require_own_format(whole, file);
        for (const nlohmann::json& node : whole.at("nodes"))
            tree.nodes.push_back(node_from(node, file));
        for (const nlohmann::json& value : whole.at("segments")) {
            VesselSegment& s = tree.segments.emplace_back();
            const int system = whole_number<int>(value.at("system"));
            if (!value.contains("system_name")) unnamed_systems.push_back(system);
            s.proximal_node = whole_number<int>(value.at("proximal_node"));
            s.distal_node = whole_number<int>(value.at("distal_node"));
            s.parent = whole_number<int>(value.at("parent"));
            s.system = system_numbered(system).value_or(VascularSystem::unknown);
            s.system_confidence = value.value("confidence", 0.0);
            s.strahler_order = whole_number<int>(value.at("strahler_order"));
            s.closes_loop = value.at("closes_loop").get<bool>();
            s.points_mm = path_from(value.at("points_mm"));
            s.radii_mm = value.at("radii_mm").get<std::vector<double>>();
            if (value.contains("bridged"))
                s.bridged = whole_numbers<std::uint8_t>(value.at("bridged"));
        }
    } catch (const nlohmann::json::exception& error) {
        throw InputError(json_problem(error), file.string(),
                         "Give a JSON file that holds a vessel tree");
    }
    require_unambiguous_systems(unnamed_systems, file);
    validate_from_file(tree, file);
    require_ends_at_nodes(tree, file);
    return tree;
}

}  // namespace hepatica
