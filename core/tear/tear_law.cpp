// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tear/tear_law.h"

#include <cmath>
#include <sstream>

#include "core/base/error.h"

namespace hepatica {

void validate(const TearLaw& law) {
    const auto check = [](bool good, const char* name, double value, const char* range) {
        if (good) return;
        std::ostringstream problem;
        problem << "is " << value;
        throw InputError(problem.str(), name, std::string("Give a value ") + range);
    };
    const auto positive = [](double value) { return value > 0.0 && std::isfinite(value); };
    check(positive(law.strength_pa), "strength [Pa]", law.strength_pa, "greater than 0");
    check(positive(law.fracture_energy_j_m2), "fracture energy [J/m2]", law.fracture_energy_j_m2,
          "greater than 0");
    check(law.tear_factor > 0.0, "tear factor", law.tear_factor, "greater than 0");
    check(law.entropy_budget_nats >= 0.0, "entropy budget", law.entropy_budget_nats,
          "of 0 or more");
    check(law.vertex_budget >= 0, "vertex budget", law.vertex_budget, "of 0 or more");
}

}  // namespace hepatica
