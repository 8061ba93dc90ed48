// SPDX-License-Identifier: GPL-3.0-or-later
// Bodies as VTU and surfaces as VTP (VTK XML, binary, millimetres, LPS): ParaView and 3D Slicer
// read them. Writers are atomic.
#pragma once

#include <filesystem>

#include "core/mesh/tet_mesh.h"

namespace hepatica {

// Throw InputError where the file cannot be written.
void write_vtu(const std::filesystem::path& file, const TetMesh& mesh);
void write_vtp(const std::filesystem::path& file, const TriangleMesh& surface);

// Positions in double precision, so that what was written is read back to the last bit. Throw
// InputError that names the file where it is missing, damaged, holds other cells, or has
// a vertex beyond 10 m.
TetMesh read_vtu(const std::filesystem::path& file);
TriangleMesh read_vtp(const std::filesystem::path& file);

}  // namespace hepatica
