// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/patient_space.h"
#include "core/mesh/mesh_io.h"
#include "core/mesh/surface.h"
#include "core/tree/files/tree_io.h"
#include "tests/fuzz/input_file.h"
#include "tests/fuzz/readers.h"
#include "tests/fuzz/refuse_or.h"

namespace hepatica::fuzz {

namespace {

void read_tree_of(Bytes bytes, const char* name) {
    const auto file = file_of(bytes, name);
    for (const TreeFileFacts& facts : {TreeFileFacts{}, TreeFileFacts{PatientSpace::ras, 2.0}})
        refuse_or([&] {
            const VesselTree tree = read_tree(file, facts);
            validate(tree);
            for (const VesselSegment& segment : tree.segments)
                for (const Vec3& point : segment.points_mm)
                    promise(is_in_patient_space(point), "points in the room");
        });
}

void read_vtp_tree(Bytes bytes) {
    read_tree_of(bytes, "tree.vtp");
}
void read_swc(Bytes bytes) {
    read_tree_of(bytes, "tree.swc");
}

void read_mesh(Bytes bytes) {
    const auto file = file_of(bytes, "mesh.vtu");
    refuse_or([&] { validate(read_vtu(file)); });
}
void read_surface(Bytes bytes) {
    const auto file = file_of(bytes, "surface.vtp");
    refuse_or([&] { validate_closed(read_vtp(file)); });
}

constexpr Reader all[] = {{"tree_vtp", read_vtp_tree},
                          {"tree_swc", read_swc},
                          {"mesh_vtu", read_mesh},
                          {"surface_vtp", read_surface}};

}  // namespace

std::span<const Reader> tree_readers() {
    return all;
}

}  // namespace hepatica::fuzz
