// SPDX-License-Identifier: GPL-3.0-or-later
// The entropy of a body, eq. (13): S = -c sum p_i ln p_i, with the minus sign that is missing in
// print. p_i is the share of vertex i in the elastic energy, or in the mass where there is none; c
// = 1 gives nats.
#pragma once

#include <span>

namespace hepatica {

// Entropy of weights >= 0, as shares of their sum; 0 ln 0 = 0. 0 where all are 0. The same bits for
// any number of threads.
double entropy_nats(std::span<const double> weights);

}  // namespace hepatica
