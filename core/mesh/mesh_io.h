// SPDX-License-Identifier: GPL-3.0-or-later
// Bodies as VTU and surfaces as VTP (VTK XML, binary, millimetres, LPS), which ParaView and 3D
// Slicer read. Writing is atomic.
#pragma once

#include <filesystem>

#include "core/mesh/tet_mesh.h"

namespace hepatica {

// Throw InputError if the file cannot be written.
void write_vtu(const std::filesystem::path& file, const TetMesh& mesh);
void write_vtp(const std::filesystem::path& file, const TriangleMesh& surface);

// Positions are in double precision, so values are read back exactly. Throw InputError that names
// the file if it is missing or damaged, holds other cells, has a vertex beyond 10 m or is refused
// by validate() or validate_closed(), whose element is then named, too.
TetMesh read_vtu(const std::filesystem::path& file);
TriangleMesh read_vtp(const std::filesystem::path& file);

}  // namespace hepatica
