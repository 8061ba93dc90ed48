// SPDX-License-Identifier: GPL-3.0-or-later
// The paper as it is printed, wherever the program offers that beside its repairs: the choices that
// the switch --as-published stands for, in one place. docs/paper.md holds them against the paper.
#pragma once

#include <vector>

#include "core/reconstruction/reconstruct.h"
#include "core/scene/scene_spec.h"
#include "core/session/command.h"

namespace hepatica {

// The pressure law under which the other fluid options default to the paper's (see FluidOptions).
inline constexpr const char* published_pressure_model = "published";

// Multi-layer segmentation (II.A.1), one recursion of the Gaussian refinement and thinning by
// templates (II.A.2). Unit width (VDSM) is part of every reconstruction.
void use_as_published(ReconstructOptions& options);

// Springs along the edges of the tetrahedra, eq. (12) taken whole, once a step, and a bare force
// limit where the vessels tear. The linear solver is chosen as ever: the paper names none, and all
// of them solve the same system.
void use_as_published(SceneSpec& scene);

// Every injection under the published pressure law, with its gas at its void fraction.
void use_as_published(std::vector<std::vector<Command>>& commands_of_steps);

}  // namespace hepatica
