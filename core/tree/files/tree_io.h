// SPDX-License-Identifier: GPL-3.0-or-later
// Vessel trees in files of other programs: VTP (3D Slicer, VMTK, SimVascular, ParaView), SWC
// (neuron and vessel tracers) and JSON. Positions are millimetres, written in LPS. System is the
// number of vascular_system.h; other numbers are read as unknown. Files of this program that do not
// name their systems are older than those numbers: there 0 was the portal vein in some trees and no
// system in others. Such a file with both 0 and other numbers is refused.
#pragma once

#include <filesystem>
#include <optional>

#include "core/tree/vessel_tree.h"

namespace hepatica {

// Writers replace the file atomically and throw InputError where it cannot be written. Readers
// throw InputError, naming the file, for anything that is not a valid vessel tree.

// Directions of a file's axes: x to the left and y to the back (LPS), or both opposite (RAS).
enum class PatientSpace { lps, ras };

// Facts that a file of another program may leave open, stated by the user. A file that contradicts
// them is refused.
struct TreeFileFacts {
    std::optional<PatientSpace> space{};
    std::optional<double> radius_mm{};  // radius of every vessel, for a VTP without radii; 0.001 to
                                        // 1000
    // The file belongs to a case, whose format defines its System numbers.
    bool in_case = false;
};

// One polyline per segment. Field data SPACE = LPS and NodeRadius; point arrays
// MaximumInscribedSphereRadius, Radius (mm), Bridged (1 where a gap was), and SimVascular's Path
// (distance from the root, mm) and CenterlineSectionArea; cell arrays SegmentId, ParentId, System,
// SystemName, Confidence (of the system, 0 where nothing is known), StrahlerOrder, ClosesLoop,
// ProximalNode, DistalNode, VMTK's GroupIds, CenterlineIds, TractIds, Blanking, and SimVascular's
// BranchId, BifurcationId, CenterlineId.
void write_tree_vtp(const std::filesystem::path& file, const VesselTree& tree);

// Reads files of this program back exactly. From files of other programs the tree is rebuilt:
// polylines that share points (or positions rounded to a micrometre) meet in nodes, radii come from
// the first point or cell array with "radius" in its name, and each component begins at its widest
// end. The field data SPACE states LPS or RAS; RAS is converted. A file without SPACE or without
// radii is refused unless `facts` state them.
VesselTree read_tree_vtp(const std::filesystem::path& file, const TreeFileFacts& facts = {});

// One sample per line (number, type, x, y, z, radius, parent). Types: 5 portal vein, 6 hepatic
// veins, 7 artery, 0 unknown; a comment in the file says so, and only then are they read back. SWC
// cannot store the radius with which a branch leaves its parent (read back as the parent's last
// one) or the segment that closes a loop (written as a chain that ends at the position of another
// sample, and read back as a loop).
void write_tree_swc(const std::filesystem::path& file, const VesselTree& tree);

// Also reads files of other programs: lines of seven numbers, comments after #, samples in any
// order. A sample without a parent is a root; samples at one position (rounded to a micrometre) are
// merged. The format does not state the axes: LPS unless `facts` say RAS.
VesselTree read_tree_swc(const std::filesystem::path& file, const TreeFileFacts& facts = {});

// All fields under the names of vessel_tree.h; reads back exactly. A file that states another
// "format" or another "space" than LPS is refused; it may state neither.
void write_tree_json(const std::filesystem::path& file, const VesselTree& tree);
VesselTree read_tree_json(const std::filesystem::path& file);

// By the file's extension: .vtp, .swc or .json. Throws InputError for any other.
void write_tree(const std::filesystem::path& file, const VesselTree& tree);
VesselTree read_tree(const std::filesystem::path& file, const TreeFileFacts& facts = {});

}  // namespace hepatica
