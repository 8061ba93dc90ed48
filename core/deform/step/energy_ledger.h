// SPDX-License-Identifier: GPL-3.0-or-later
// The energy ledger over several steps. What a body has gained must equal what was put in less what
// was lost:  change of (kinetic + elastic + grab) =
//   gravity_work + tool_work - damping_loss - integrator_loss - unfolding_loss + solver_work +
//   imbalance.
#pragma once

#include "core/deform/stepper/stepper.h"

namespace hepatica {

// The second step after the first: energies of the end, works and losses summed.
EnergyLedger in_sequence(const EnergyLedger& first, const EnergyLedger& second);
StepReport in_sequence(const StepReport& first, const StepReport& second);

// Sum of the sizes of all terms but the imbalance [nJ].
double energy_handled(const EnergyLedger& ledger);
// |imbalance| over that; 0 where all are 0.
double relative_imbalance(const EnergyLedger& ledger);

}  // namespace hepatica
