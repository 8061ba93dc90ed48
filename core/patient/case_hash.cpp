// SPDX-License-Identifier: GPL-3.0-or-later
// Hashes of a patient: of what the simulation reads, and of the tree before corrections
// (patient_case.h).
#include <array>

#include "core/base/hash.h"
#include "core/patient/patient_case.h"

namespace hepatica {

namespace {

void add(Hasher& hasher, const VesselTree& tree) {
    for (const VesselSegment& segment : tree.segments) {
        const std::array<int, 4> links{segment.proximal_node, segment.distal_node, segment.parent,
                                       number_of(segment.system)};
        hasher.add(std::span<const int>(links));
        for (const Vec3& point : segment.points_mm) hasher.add_bytes(point.data(), sizeof(Vec3));
        hasher.add(std::span<const double>(segment.radii_mm));
    }
}

}  // namespace

std::uint64_t hash_of_extracted(const PatientCase& patient) {
    const VesselTree& extracted = patient.corrections.extracted;
    Hasher hasher;
    add(hasher, extracted.segments.empty() ? patient.tree : extracted);
    return hasher.value();
}

std::uint64_t hash_of(const PatientCase& patient) {
    Hasher hasher;
    add(hasher, patient.tree);
    for (const Vec3& vertex : patient.mesh.vertices_mm)
        hasher.add_bytes(vertex.data(), sizeof(Vec3));
    for (const auto& tetrahedron : patient.mesh.tetrahedra)
        hasher.add(std::span<const int>(tetrahedron));
    return hasher.value();
}

}  // namespace hepatica
