// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/drug_leak.h"

#include <algorithm>

#include "core/flow/injection.h"

namespace hepatica {

DrugLeak drug_leak(const DrugView& drug, const std::vector<float>& arrival_s,
                   const std::vector<double>& leaks_g_s) {
    DrugLeak leak;
    if (!drug.arrival_s || !drug.injection) return leak;
    leak.shares.assign(arrival_s.size(), 0.0);
    double reached_g_s = 0.0;
    for (std::size_t i = 0; i < std::min(arrival_s.size(), leaks_g_s.size()); ++i) {
        if (static_cast<double>(arrival_s[i]) > drug.time_s) continue;
        leak.shares[i] = leaks_g_s[i];
        reached_g_s += leaks_g_s[i];
    }
    if (reached_g_s <= 0.0) return leak;
    for (double& share : leak.shares) share /= reached_g_s;
    if (drug.playing)
        leak.total_g_s = std::min(reached_g_s, drug.injection->mass_flow_g_s * drug.speed);
    return leak;
}

}  // namespace hepatica
