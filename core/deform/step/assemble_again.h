// SPDX-License-Identifier: GPL-3.0-or-later
// Assembles the matrix of an earlier step, eq. (12), once more from what determined it, so that a
// solver that goes on from a checkpoint can make its factor to the same bits.
#pragma once

#include "core/deform/body/body.h"
#include "core/deform/step/incremental_potential.h"
#include "core/deform/step/solver_checkpoint.h"

namespace hepatica {

// `checkpoint.made_from` must be there. Leaves the potential at that step's positions, with its
// held nodes frozen and its collapsed elements counted: the caller sets both back. Throws
// InputError where the checkpoint is not of this body.
void assemble_again(const Body& body, IncrementalPotential& potential,
                    const SolverCheckpoint& checkpoint);

}  // namespace hepatica
