// SPDX-License-Identifier: GPL-3.0-or-later
// Reads and writes case.json in versions 1 to 3.
#include "core/patient/case_header.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "core/base/atomic_write.h"
#include "core/base/error.h"
#include "core/base/hash.h"
#include "core/base/json_number.h"
#include "core/base/json_problem.h"
#include "core/base/quoted_name.h"
#include "core/base/sha256.h"
#include "core/base/text_file.h"
#include "core/patient/doubts_json.h"
#include "core/patient/format_1.h"
#include "core/patient/liver_segments.h"
#include "core/patient/painted_tumours.h"
#include "core/tree/files/tree_json.h"

namespace hepatica {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

namespace {

constexpr const char* how_to_make_case =
    "Reconstruct the patient again: hepatica-cli reconstruct CT --out CASE.hep";
constexpr int oldest_version = 1;
constexpr int usual_version = 2;
constexpr int painted_version = 3;  // holds edits that older programs do not know

Json to_json(const Grid& grid) {
    Json directions = Json::array();
    for (int axis = 0; axis < 3; ++axis)
        directions.push_back(Json(json_of(Vec3(grid.direction.col(axis)))));
    return {{"dims", grid.dims},
            {"spacing_mm", json_of(grid.spacing_mm)},
            {"origin_mm", json_of(grid.origin_mm)},
            {"direction", directions}};
}

Grid grid_from(const Json& json) {
    Grid grid;
    for (std::size_t axis = 0; axis < 3; ++axis)
        grid.dims[axis] = whole_number<int>(json.at("dims").at(axis));
    grid.spacing_mm = vec3_from(json.at("spacing_mm"));
    grid.origin_mm = vec3_from(json.at("origin_mm"));
    for (int axis = 0; axis < 3; ++axis)
        grid.direction.col(axis) = vec3_from(json.at("direction").at(axis));
    return grid;
}

Json to_json(const VesselTree& tree) {
    return {{"segments", tree.segments.size()},
            {"bifurcations", bifurcation_count(tree)},
            {"ends", end_count(tree)},
            {"length_mm", length_mm(tree)},
            {"bridged_mm", bridged_length_mm(tree)},
            {"systems", json_of(systems_of(tree))}};
}

void read_warnings(const Json& json, CaseHeader& header) {
    header.warnings = json.at("warnings").get<std::vector<std::string>>();
    header.warnings_of_image =
        std::min(whole_number<std::size_t>(json.value("warnings_of_image", Json(0))),
                 header.warnings.size());
}

void write_warnings(const PatientCase& patient, Json& json) {
    if (patient.warnings.empty()) return;
    for (const std::string& warning : patient.warnings)
        json["warnings"].push_back(without_names(warning));
    json["warnings_of_image"] = patient.warnings_of_image;
}

CaseHeader header_from(const Json& json, int version) {
    CaseHeader header;
    header.version = version;
    const Json& source = json.at("source");
    header.source.image_grid = grid_from(source.at("grid"));
    if (version == 1) {
        header.source.parameters_json = parameters_of_format_1(json.at("parameters").dump());
        header.digests = json.at("hashes").get<std::map<std::string, std::string>>();
        return header;
    }
    header.source.name = json.value("name", "");
    if (json.contains("mask_grid")) header.mask_grid = grid_from(json.at("mask_grid"));
    if (json.contains("doubts")) header.doubts = doubts_from(json.at("doubts"));
    if (json.contains("warnings")) read_warnings(json, header);
    header.source.image_sha256 = source.at("image_sha256").get<std::string>();
    header.source.parameters_json = json.at("parameters").dump();
    header.digests = json.at("sha256").get<std::map<std::string, std::string>>();
    return header;
}

}  // namespace

void refuse_case(const fs::path& place, const std::string& problem) {
    throw InputError(problem, place.string(), how_to_make_case);
}

CaseHeader read_case_header(const fs::path& folder) {
    const fs::path file = folder / case_file::header;
    std::error_code ignored;
    if (!fs::exists(folder, ignored))
        throw InputError("does not exist", folder.string(),
                         "Check the path: a case is a folder NAME.hep or one file NAME.hepz");
    if (!fs::exists(file, ignored))
        refuse_case(folder, "is not a patient's case: it holds no case.json");
    const Json json = Json::parse(read_text_file(file, how_to_make_case), nullptr, false);
    if (json.is_discarded() || !json.is_object()) refuse_case(file, "is damaged");
    try {
        if (json.value("format", "") != "hepatica-case")
            refuse_case(file, "was not written by this program");
        const int version = whole_number<int>(json.value("version", Json(0)));
        if (version < oldest_version || version > painted_version)
            refuse_case(file, "has version " + std::to_string(version) +
                                  "; this program reads versions " +
                                  std::to_string(oldest_version) + " to " +
                                  std::to_string(painted_version));
        return header_from(json, version);
    } catch (const Json::exception& error) {
        refuse_case(file, json_problem(error));
    }
}

void check_case_file(const fs::path& folder, const CaseHeader& header, const char* name) {
    const fs::path file = folder / name;
    if (!fs::is_regular_file(file)) refuse_case(file, "is missing");
    const auto promised = header.digests.find(name);
    const std::string found =
        header.version == 1 ? to_hex(hash_of_file(file)) : sha256_of_file(file);
    if (promised == header.digests.end() || found != promised->second)
        refuse_case(file, "is not the file that case.json was written for (its hash differs)");
}

void write_case_header(const fs::path& folder, const PatientCase& patient) {
    using namespace case_file;
    Json json;
    json["format"] = "hepatica-case";
    json["version"] = std::ranges::all_of(patient.corrections.edits, changes_tree, &TreeEdit::kind)
                          ? usual_version
                          : painted_version;
    json["program"] = HEPATICA_VERSION;
    if (!patient.source.name.empty()) json["name"] = patient.source.name;
    json["source"] = {{"image_sha256", patient.source.image_sha256},
                      {"grid", to_json(patient.source.image_grid)}};
    json["parameters"] = Json::parse(patient.source.parameters_json);
    if (!patient.mask.voxels.empty()) json["mask_grid"] = to_json(patient.mask.grid);
    json["tree"] = to_json(patient.tree);
    if (!patient.couinaud.voxels.empty()) json["segments_ml"] = segments_ml_json(patient.couinaud);
    if (patient.doubts) json["doubts"] = json_of(*patient.doubts);
    write_warnings(patient, json);
    for (const char* name : {mask, skeleton, organs, unpainted, couinaud, tree, swc, surface, mesh,
                             corrections, extracted})
        if (fs::exists(folder / name)) json["sha256"][name] = sha256_of_file(folder / name);
    write_text_atomically(folder / case_file::header, json.dump(2) + "\n");
}

}  // namespace hepatica
