// SPDX-License-Identifier: GPL-3.0-or-later
// What of the blood that is lost at the stumps is drug. Behind its front the drug fills the lumen,
// so that what leaks out of a stump that it has reached is drug.
#pragma once

#include <vector>

#include "core/scene/frame.h"

namespace hepatica {

struct DrugLeak {
    double total_g_s = 0.0;      // in time of the scene, not of the drug's clock
    std::vector<double> shares;  // of it, per stump; empty where there is no drug
};

// `arrival_s` says per stump when the drug reaches it; `leaks_g_s` are the losses of blood there,
// as many. An upper bound: all that bleeds there from then on, but no more than is injected.
// Nothing while the drug's clock stands.
DrugLeak drug_leak(const DrugView& drug, const std::vector<float>& arrival_s,
                   const std::vector<double>& leaks_g_s);

}  // namespace hepatica
