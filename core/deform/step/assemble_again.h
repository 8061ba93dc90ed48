// SPDX-License-Identifier: GPL-3.0-or-later
// Assembles the matrix of an earlier step, eq. (12), once more from its inputs, so that a solver
// that continues from a checkpoint can compute its factor to the same bits.
#pragma once

#include "core/deform/body/body.h"
#include "core/deform/step/incremental_potential.h"
#include "core/deform/step/solver_checkpoint.h"

namespace hepatica {

// Requires `checkpoint.made_from`. Leaves the potential at that step's positions, with its held
// nodes frozen and its setting for collapsed elements; the caller restores both. Throws InputError
// where the checkpoint is not of this body.
void assemble_again(const Body& body, IncrementalPotential& potential,
                    const SolverCheckpoint& checkpoint);

}  // namespace hepatica
