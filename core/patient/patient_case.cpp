// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/patient/patient_case.h"

#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>

#include "core/base/atomic_write.h"
#include "core/base/error.h"
#include "core/base/hash.h"
#include "core/image/volume_reader.h"
#include "core/image/volume_writer.h"
#include "core/mesh/mesh_io.h"
#include "core/tree/files/tree_io.h"

namespace hepatica {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

namespace {

constexpr int case_version = 1;
constexpr const char* mask_file = "mask.nii.gz";
constexpr const char* skeleton_file = "skeleton.nii.gz";
constexpr const char* tree_file = "tree.vtp";
constexpr const char* swc_file = "tree.swc";
constexpr const char* surface_file = "surface.vtp";
constexpr const char* mesh_file = "mesh.vtu";
constexpr const char* corrections_file = "corrections.json";
constexpr const char* extracted_file = "tree_extracted.vtp";
constexpr const char* dial_file = "dial.json";

[[noreturn]] void refuse(const fs::path& place, const std::string& problem) {
    throw InputError(problem, place.string(),
                     "Reconstruct the patient again: hepatica-cli reconstruct CT --out CASE.hep");
}

Json to_json(const Vec3& vector) {
    return {vector.x(), vector.y(), vector.z()};
}

Vec3 vector_from(const Json& json) {
    return {json.at(0).get<double>(), json.at(1).get<double>(), json.at(2).get<double>()};
}

Json to_json(const Grid& grid) {
    Json directions = Json::array();
    for (int axis = 0; axis < 3; ++axis) directions.push_back(to_json(grid.direction.col(axis)));
    return {{"dims", grid.dims},
            {"spacing_mm", to_json(grid.spacing_mm)},
            {"origin_mm", to_json(grid.origin_mm)},
            {"direction", directions}};
}

Grid grid_from(const Json& json) {
    Grid grid;
    grid.dims = json.at("dims").get<Index3>();
    grid.spacing_mm = vector_from(json.at("spacing_mm"));
    grid.origin_mm = vector_from(json.at("origin_mm"));
    for (int axis = 0; axis < 3; ++axis)
        grid.direction.col(axis) = vector_from(json.at("direction").at(axis));
    return grid;
}

Json read_header(const fs::path& folder) {
    const fs::path file = folder / "case.json";
    std::ifstream in(file);
    if (!in) refuse(folder, "is not a patient's case: it holds no case.json");
    const Json header = Json::parse(in, nullptr, false);
    if (header.is_discarded() || !header.is_object()) refuse(file, "is damaged");
    if (header.value("format", "") != "hepatica-case")
        refuse(file, "was not written by this program");
    const int version = header.value("version", 0);
    if (version != case_version)
        refuse(file, "has version " + std::to_string(version) + "; this program reads version " +
                         std::to_string(case_version));
    return header;
}

void check_file(const fs::path& folder, const Json& header, const char* name) {
    const fs::path file = folder / name;
    if (!fs::is_regular_file(file)) refuse(file, "is missing");
    const std::string promised = header.at("hashes").value(name, "");
    if (to_hex(hash_of_file(file)) != promised)
        refuse(file, "is not the file that case.json was written for (its hash differs)");
}

// Whether the case holds a file that not every case has; it is checked then.
bool holds(const fs::path& folder, const Json& header, const char* name) {
    if (!header.at("hashes").contains(name)) return false;
    check_file(folder, header, name);
    return true;
}

Mask read_voxels(const fs::path& folder, const Json& header, const char* name) {
    if (!holds(folder, header, name)) return {};
    Job job;
    const LabelMap labels = read_label_map(folder / name, job);
    return narrow_labels(labels, (folder / name).string());
}

std::string text_of(const fs::path& file) {
    std::ifstream in(file, std::ios::binary);
    if (!in) refuse(file, "cannot be read");
    return {std::istreambuf_iterator<char>(in), {}};
}

Corrections read_corrections(const fs::path& folder, const Json& header) {
    Corrections corrections;
    if (holds(folder, header, corrections_file)) {
        const fs::path file = folder / corrections_file;
        const Json json = Json::parse(text_of(file));
        corrections.bridges = bridges_from_json(json.at("bridges").dump(), file.string());
        corrections.edits = edits_from_json(json.at("edits").dump(), file.string());
    }
    if (holds(folder, header, extracted_file))
        corrections.extracted = read_tree_vtp(folder / extracted_file);
    if (corrections.edits.empty() != corrections.extracted.segments.empty())
        refuse(folder, "holds edits without the tree that they were made on");
    return corrections;
}

void write_corrections(const fs::path& folder, const Corrections& corrections) {
    if (corrections.bridges.empty() && corrections.edits.empty()) return;
    const Json json{{"bridges", Json::parse(bridges_to_json(corrections.bridges))},
                    {"edits", Json::parse(edits_to_json(corrections.edits))}};
    write_text_atomically(folder / corrections_file, json.dump(1) + "\n");
    if (!corrections.edits.empty()) write_tree_vtp(folder / extracted_file, corrections.extracted);
}

PatientCase read(const fs::path& folder, bool with_voxels) {
    PatientCase patient;
    try {
        const Json header = read_header(folder);
        const Json& source = header.at("source");
        patient.source.image_path = source.at("image").get<std::string>();
        patient.source.image_grid = grid_from(source.at("grid"));
        patient.source.parameters_json = header.at("parameters").dump();
        for (const char* name : {tree_file, surface_file, mesh_file})
            check_file(folder, header, name);
        patient.corrections = read_corrections(folder, header);
        if (with_voxels) {
            patient.mask = read_voxels(folder, header, mask_file);
            patient.skeleton = read_voxels(folder, header, skeleton_file);
        }
    } catch (const nlohmann::json::exception& error) {
        refuse(folder / "case.json", std::string("is damaged (") + error.what() + ")");
    }
    patient.tree = read_tree_vtp(folder / tree_file);
    patient.surface = read_vtp(folder / surface_file);
    patient.mesh = read_vtu(folder / mesh_file);
    if (std::ifstream dial(folder / dial_file); dial)
        patient.dial_json.assign(std::istreambuf_iterator<char>(dial), {});
    return patient;
}

}  // namespace

bool is_case(const fs::path& path) {
    return fs::is_regular_file(path / "case.json");
}

void write_case(const fs::path& folder, const PatientCase& patient) {
    if (fs::exists(folder) && !is_case(folder))
        throw InputError("is there already and is not a patient's case", folder.string(),
                         "Give --out another name; only an older case is replaced");
    write_folder_atomically(folder, [&](const fs::path& temporary) {
        if (!patient.mask.voxels.empty()) write_nifti(temporary / mask_file, patient.mask);
        if (!patient.skeleton.voxels.empty())
            write_nifti(temporary / skeleton_file, patient.skeleton);
        write_tree_vtp(temporary / tree_file, patient.tree);
        write_tree_swc(temporary / swc_file, patient.tree);
        write_vtp(temporary / surface_file, patient.surface);
        write_vtu(temporary / mesh_file, patient.mesh);
        write_corrections(temporary, patient.corrections);
        if (!patient.dial_json.empty())
            write_text_atomically(temporary / dial_file, patient.dial_json);

        Json header;
        header["format"] = "hepatica-case";
        header["version"] = case_version;
        header["program"] = HEPATICA_VERSION;
        header["source"] = {{"image", patient.source.image_path},
                            {"grid", to_json(patient.source.image_grid)}};
        header["parameters"] = Json::parse(patient.source.parameters_json);
        for (const char* name : {mask_file, skeleton_file, tree_file, swc_file, surface_file,
                                 mesh_file, corrections_file, extracted_file})
            if (fs::exists(temporary / name))
                header["hashes"][name] = to_hex(hash_of_file(temporary / name));
        write_text_atomically(temporary / "case.json", header.dump(2) + "\n");
    });
}

void add_voxels(const fs::path& folder, PatientCase& patient) {
    const Json header = read_header(folder);
    patient.mask = read_voxels(folder, header, mask_file);
    patient.skeleton = read_voxels(folder, header, skeleton_file);
}

void write_dial(const fs::path& folder, const std::string& dial_json) {
    write_text_atomically(folder / dial_file, dial_json);
}

PatientCase read_case(const fs::path& folder) {
    return read(folder, true);
}

PatientCase read_case_without_voxels(const fs::path& folder) {
    return read(folder, false);
}

}  // namespace hepatica
