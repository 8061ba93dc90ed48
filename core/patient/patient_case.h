// SPDX-License-Identifier: GPL-3.0-or-later
// One patient on disk: NAME.hep, a folder of open formats, or NAME.hepz, the same in one file
// (case_archive.h), which is unpacked among the temporary files whenever it is read.
//   case.json (version, digest of the CT, parameters, the tree in numbers, SHA-256 of the rest),
//   mask.nii.gz (numbers of systems), skeleton.nii.gz, organs.nii.gz, couinaud.nii.gz, tree.vtp,
//   tree.swc, surface.vtp, mesh.vtu, and where it was corrected by hand corrections.json (bridges
//   offered, edits), tree_extracted.vtp (the tree before the edits) and, where tumours were
//   painted, organs_unpainted.nii.gz (the organs before that); where somebody measured,
//   measurements.json
// The CT is not copied, and no path of it or of a mask is kept: folders are often called after the
// patient. This is format 2; format 1 is read, too (format_1.h).
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/image/volume.h"
#include "core/mesh/tet_mesh.h"
#include "core/patient/doubts.h"
#include "core/patient/measurement.h"
#include "core/tree/editing/tree_edit.h"
#include "core/tree/extraction/gap_bridging.h"
#include "core/tree/vessel_tree.h"

namespace hepatica {

// Where a case came from and how it was made.
struct CaseSource {
    std::string name;                    // what the user wants it called; may be empty
    std::string image_sha256;            // content of the CT (image_digest.h); empty: not known
    Grid image_grid;                     // geometry of the CT
    std::string parameters_json = "{}";  // options of the reconstruction, one JSON object
};

// The vessels were made anew from painted voxels: behind so many edits, with so many strokes of a
// brush where these were counted, else 0.
struct Rebuilding {
    std::size_t after_edits = 0, strokes = 0;
    bool operator==(const Rebuilding&) const = default;
};

// What may be corrected by hand and what was; see corrections.h.
struct Corrections {
    std::vector<Bridge> bridges;  // gaps found: bridged by the reconstruction, or only offered
    std::vector<TreeEdit> edits;  // in order; they made `tree` out of `extracted`
    VesselTree extracted;         // the tree before the first edit; empty where there are none
    // The organs before the first stroke at a tumour (painted_tumours.h), all 0 where there were
    // none; empty without strokes, and where the patient was read without voxels.
    Mask unpainted;
    std::vector<Rebuilding> rebuilt;  // the oldest first; only told of: their voxels are the mask
};

// Labels of organs.nii.gz.
namespace organ_label {
inline constexpr std::uint8_t liver = 1;
inline constexpr std::uint8_t cava = 2;
inline constexpr std::uint8_t first_tumour = 10;  // one label each, from here on
}  // namespace organ_label

struct PatientCase {
    CaseSource source;
    Mask mask;      // numbers of vascular systems, on the grid they were segmented on; may be empty
    Mask skeleton;  // its unit-width skeleton, same grid; may be empty
    Mask organs;    // organ_label, on a grid of its own; empty where there are none
    // Couinaud's segments 1 to 8 of the liver, on the grid of `organs`, by the portal vein of
    // `tree`; empty where either is missing. See liver_segments.h.
    Mask couinaud;
    VesselTree tree;
    TriangleMesh surface;  // boundary of `mesh`
    TetMesh mesh;
    Corrections corrections;
    // Of the reconstruction, before anything was corrected; none in cases of older programs.
    std::optional<Doubts> doubts;
    // The dial as measured on this mesh, one JSON object (see core/scene/measured_dial.h); empty
    // where it was not measured. Kept in dial.json, which may be removed.
    std::string dial_json;
    // What a person measured, kept in measurements.json, which may be removed.
    std::vector<KeptMeasurement> measured;
    // Where he was read from without his voxels, which lie there; empty: he has those that there
    // are. Known in memory alone.
    std::filesystem::path voxels_at;
};

// A folder that holds a case.json, or a file NAME.hepz. Says nothing about whether it can be read.
bool is_case(const std::filesystem::path& path);

// A case that write_case() would replace: a folder or an archive that holds a case.json.
bool is_replaceable_case(const std::filesystem::path& place);

// A file of a case, by its path below the case's folder; others belong to somebody else.
bool is_of_a_case(const std::filesystem::path& file);

// Writes the whole case or nothing, in one file where the place is called NAME.hepz; a case that
// stood there is replaced. What else lies in its folder stays.
// Throws InputError where the place cannot be written or the disk is full.
void write_case(const std::filesystem::path& place, const PatientCase& patient);

// Reads and checks a case of this format or an older one. Throws InputError that says why where the
// version is not known, a file is missing, or a file's digest is not the one that case.json holds.
PatientCase read_case(const std::filesystem::path& place);

// The same without the voxels (mask, skeleton, organs, couinaud stay empty): simulation needs none
// of them.
PatientCase read_case_without_voxels(const std::filesystem::path& place);

// Reads a case's voxels into a patient that was read without them. Throws InputError as above, and
// where the place holds a case of another CT or other parameters by now: of `patient` only
// `source` is compared.
void add_voxels(const std::filesystem::path& place, PatientCase& patient);

// The labels of organs: his own, or those of the case that he was read from without them, as it is
// on disk now; empty where there are none. Throws InputError as above.
Mask organs_of(const PatientCase& patient);

// Leaves a measured dial in a case that is there already, and nothing else of it changed. Throws
// InputError where it cannot be written.
void write_dial(const std::filesystem::path& place, const std::string& dial_json);

// Hash of what the simulation reads (tree and mesh): a recording names the case that it belongs to.
std::uint64_t hash_of(const PatientCase& patient);

// Hash of his tree as it was extracted, which no correction changes: the same corrections can be
// made again where it is the same.
std::uint64_t hash_of_extracted(const PatientCase& patient);

}  // namespace hepatica
