// SPDX-License-Identifier: GPL-3.0-or-later
// The paper as printed, where the program also offers corrected methods: all choices behind the
// option --as-published. docs/paper.md compares them with the paper.
#pragma once

#include <vector>

#include "core/reconstruction/reconstruct.h"
#include "core/scene/scene_spec.h"
#include "core/session/command.h"

namespace hepatica {

// The pressure law with which the other fluid options default to the paper's (see FluidOptions).
inline constexpr const char* published_pressure_model = "published";

// Multi-layer segmentation (II.A.1), one recursion of the Gaussian refinement, and thinning by
// templates (II.A.2). The unit-width skeleton (VDSM) is part of every reconstruction.
void use_as_published(ReconstructOptions& options);

// Springs along the edges of the tetrahedra, eq. (12) with the full step, once per frame step, and
// a bare force limit for tearing. The linear solver is chosen as usual: the paper names none, and
// all of them solve the same system.
void use_as_published(SceneSpec& scene);

// Gives every injection the published pressure law, gas as second phase, and the published void
// fraction. Throws InputError for commands that would change the published body or step.
void use_as_published(std::vector<std::vector<Command>>& commands_of_steps);

}  // namespace hepatica
