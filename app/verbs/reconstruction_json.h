// SPDX-License-Identifier: GPL-3.0-or-later
// The parts of the answer that reconstruct, edit and remake share.
#pragma once

#include <vector>

#include "app/command_line.h"
#include "core/mesh/tet_mesh.h"
#include "core/tree/extraction/gap_bridging.h"

namespace hepatica {

Json to_json(const VesselTree& tree);
Json to_json(const TetMesh& mesh);
// Confidence, length and ends of each bridge, and whether it is built already.
Json to_json(const std::vector<Bridge>& bridges);

}  // namespace hepatica
