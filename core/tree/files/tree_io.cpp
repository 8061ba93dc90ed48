// SPDX-License-Identifier: GPL-3.0-or-later
// Selects readers and writers by file extension, and validates what was read.
#include "core/tree/files/tree_io.h"

#include <algorithm>
#include <iterator>
#include <sstream>
#include <system_error>

#include "core/base/error.h"
#include "core/base/file_extension.h"
#include "core/base/patient_space.h"
#include "core/base/text_file.h"
#include "core/tree/files/tree_files.h"

namespace hepatica {

std::string read_text(const std::filesystem::path& file) {
    return read_text_file(file, "Give a tree in a .vtp, .swc or .json file");
}

// Capillaries, the thinnest vessels, have radii of 0.003 mm; the aorta has 15.
void require_plausible_radius(double radius_mm, const std::string& what, const std::string& place) {
    constexpr double least_mm = 0.001, most_mm = 1000.0;
    if (radius_mm >= least_mm && radius_mm <= most_mm) return;
    std::ostringstream problem;
    problem << "has " << what << " of radius " << radius_mm << " mm";
    throw InputError(problem.str(), place,
                     "Give radii in millimetres, from 0.001 to 1000, at every point");
}

void require_unambiguous_systems(const std::vector<int>& numbers,
                                 const std::filesystem::path& file) {
    const auto zeros = std::ranges::count(numbers, 0);
    if (zeros == 0 || zeros == std::ssize(numbers)) return;
    throw InputError(
        "counts its vascular systems from 0 and does not name them, as older versions did",
        file.string(),
        "Make the tree anew: phantom and reconstruct give the same one from the same options; or "
        "open the case that it was taken from");
}

void validate_from_file(const VesselTree& tree, const std::filesystem::path& file) {
    if (tree.segments.empty())
        throw InputError("holds no vessel", file.string(),
                         "The tree file is damaged or not a vessel tree");
    for (const VesselNode& node : tree.nodes)
        require_in_patient_space(node.position_mm, "a node", file.string());
    for (const VesselSegment& segment : tree.segments) {
        for (const Vec3& point : segment.points_mm)
            require_in_patient_space(point, "a point", file.string());
        for (const double radius_mm : segment.radii_mm)
            require_plausible_radius(radius_mm, "a vessel", file.string());
    }
    try {
        validate(tree);
    } catch (const InputError& error) {
        throw InputError(error.place() + " " + error.problem(), file.string(), error.remedy());
    }
}

namespace {

// A format that has radii at every point, and perhaps axes of its own, contradicts what is stated.
void require_no_contradiction(const std::filesystem::path& file, const TreeFileFacts& facts,
                              bool in_lps) {
    if (facts.radius_mm)
        throw InputError("holds radii of its own", file.string(), "Leave --radius-mm out");
    if (in_lps && facts.space == PatientSpace::ras)
        throw InputError(std::string("says itself that its axes are ") + "LPS", file.string(),
                         "Leave --tree-space out");
}

[[noreturn]] void refuse_extension(const std::filesystem::path& file) {
    throw InputError("is no format of vessel trees", file.string(),
                     "Choose a name that ends in .vtp, .swc or .json");
}

}  // namespace

void write_tree(const std::filesystem::path& file, const VesselTree& tree) {
    const std::string extension = extension_of(file);
    if (extension == ".vtp") return write_tree_vtp(file, tree);
    if (extension == ".swc") return write_tree_swc(file, tree);
    if (extension == ".json") return write_tree_json(file, tree);
    refuse_extension(file);
}

VesselTree read_tree(const std::filesystem::path& file, const TreeFileFacts& facts) {
    std::error_code error;
    const std::filesystem::file_status status = std::filesystem::status(file, error);
    if (!std::filesystem::status_known(status))  // a folder above it may not be entered, say
        throw InputError("cannot be opened (" + error.message() + ")", file.string(),
                         "Check that it exists and may be read");
    if (!std::filesystem::exists(status))
        throw InputError("does not exist", file.string(),
                         "Give a tree in a .vtp, .swc or .json file");
    const std::string extension = extension_of(file);
    if (extension == ".vtp") return read_tree_vtp(file, facts);
    if (extension != ".swc" && extension != ".json") refuse_extension(file);
    require_no_contradiction(file, facts, extension == ".json");
    return extension == ".swc" ? read_tree_swc(file, facts) : read_tree_json(file);
}

}  // namespace hepatica
