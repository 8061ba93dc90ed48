// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tear/entropy.h"

#include <cmath>
#include <numeric>

#include "core/base/parallel.h"

namespace hepatica {

double entropy_nats(std::span<const double> weights) {
    constexpr std::size_t block = 1024;
    const double total = parallel_sum(weights.size(), block, [&](std::size_t b, std::size_t e) {
        return std::accumulate(weights.begin() + b, weights.begin() + e, 0.0);
    });
    if (!(total > 0.0)) return 0.0;
    return parallel_sum(weights.size(), block, [&](std::size_t begin, std::size_t end) {
        double sum = 0.0;
        for (std::size_t i = begin; i < end; ++i) {
            const double share = weights[i] / total;
            if (share > 0.0) sum -= share * std::log(share);
        }
        return sum;
    });
}

}  // namespace hepatica
