// SPDX-License-Identifier: GPL-3.0-or-later
// Vessel trees in files that other programs open: VTP (3D Slicer, VMTK, SimVascular, ParaView), SWC
// (neuron and vessel tracers) and JSON. Positions are millimetres; written in LPS in all of them.
// System is the number of vascular_system.h; a number that is none of these is read as unknown.
// Files of this program that do not name their systems are older than those numbers: there 0 was
// the portal vein in some trees and no system in others. One that holds 0 and others is refused.
#pragma once

#include <filesystem>
#include <optional>

#include "core/tree/vessel_tree.h"

namespace hepatica {

// Writers replace the file as a whole or leave it as it was; they throw InputError where it cannot
// be written. Readers throw InputError, naming the file, for whatever is not a vessel tree.

// Which way the axes of a file run: x to the left, y to the back (LPS), or both the other way
// (RAS).
enum class PatientSpace { lps, ras };

// What a file of another program may leave open, as its user states it. Where a file does say it
// and something else, it is refused.
struct TreeFileFacts {
    std::optional<PatientSpace> space{};
    std::optional<double> radius_mm{};  // of every vessel, in a VTP without radii; 0.001 to 1000
    // The file lies in a case, whose format says what its System numbers mean.
    bool in_case = false;
};

// One polyline per segment. Field data SPACE = LPS and NodeRadius; point arrays
// MaximumInscribedSphereRadius, Radius (mm), Bridged (1 where a gap was), and SimVascular's Path
// (distance from the root, mm) and CenterlineSectionArea; cell arrays SegmentId, ParentId, System,
// SystemName, Confidence (of the system, 0 where nothing is known), StrahlerOrder, ClosesLoop,
// ProximalNode, DistalNode, VMTK's GroupIds, CenterlineIds, TractIds, Blanking, and SimVascular's
// BranchId, BifurcationId, CenterlineId.
void write_tree_vtp(const std::filesystem::path& file, const VesselTree& tree);

// Reads its own files back to the bit. From files of other programs the tree is rebuilt: polylines
// that share points (or positions within a micrometre) meet in nodes, radii are taken from the
// first point or cell array whose name speaks of a radius, and each component begins at its widest
// end. The field data SPACE say LPS or RAS, which is turned into LPS. A file without SPACE or
// without radii is refused unless `facts` say what it leaves open.
VesselTree read_tree_vtp(const std::filesystem::path& file, const TreeFileFacts& facts = {});

// One sample per line (number, type, x, y, z, radius, parent). Types: 5 portal vein, 6 hepatic
// veins, 7 artery, 0 unknown; a comment in the file says so, and only then are they read back.
// What SWC cannot say: the radius with which a branch leaves its parent (read back as the parent's
// last) and the link that closes a loop (a chain that ends at the place of another sample; read
// back as a loop).
void write_tree_swc(const std::filesystem::path& file, const VesselTree& tree);

// Also reads files of other programs: lines of seven numbers, comments after #, samples in any
// order. A sample without parent is a root, samples at one place (to a micrometre) are one. The
// format has no field for the axes: they are LPS unless `facts` say RAS.
VesselTree read_tree_swc(const std::filesystem::path& file, const TreeFileFacts& facts = {});

// Everything there is, with the names of vessel_tree.h; comes back to the bit.
void write_tree_json(const std::filesystem::path& file, const VesselTree& tree);
VesselTree read_tree_json(const std::filesystem::path& file);

// By the file's extension: .vtp, .swc or .json. Throws InputError for any other.
void write_tree(const std::filesystem::path& file, const VesselTree& tree);
VesselTree read_tree(const std::filesystem::path& file, const TreeFileFacts& facts = {});

}  // namespace hepatica
