// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/verbs/verbs.h"

namespace hepatica {

void add_all_verbs(CommandLine& line) {
    add_bench_iterations(line);
    add_bench_peers(line);
    add_diagnose(line);
}

}  // namespace hepatica
