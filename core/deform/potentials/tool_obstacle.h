// SPDX-License-Identifier: GPL-3.0-or-later
// An obstacle to a tool: it stops the tool as vessels do and presses on its pad. A solid always
// does. A shell does only while the whole tool is inside: tools come in through the wall, as
// through a port, and may reach out of it.
#pragma once

#include <vector>

#include "core/deform/body/obstacles.h"
#include "core/deform/potentials/tool_pad.h"

namespace hepatica {

// Keeps a reference to the obstacle.
class ToolObstacle {
  public:
    explicit ToolObstacle(const Obstacle& obstacle);

    bool stops(const Tool& tool) const;
    // Whether it is a solid and part of the tool is inside.
    bool entered_by(const Tool& tool) const;
    StandingSurface surface() const { return {pad_.surface(), obstacle_.surface.vertices_mm}; }
    // See ToolPad.
    std::vector<PadContact> contacts(const Tool& tool, std::span<const Capsule> shapes) const;
    double least_gap_mm(const Tool& tool) const;

  private:
    bool meets(const ToolPart& part) const;
    bool holds(const ToolPart& part) const;

    const Obstacle& obstacle_;
    ToolPad pad_;
    std::vector<Box> boxes_;    // of all patches
    std::vector<int> patches_;  // their numbers
};

}  // namespace hepatica
