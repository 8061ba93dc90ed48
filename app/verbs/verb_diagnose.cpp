// SPDX-License-Identifier: GPL-3.0-or-later
// diagnose: what this computer offers the program (app/diagnosis.h).
#include "app/diagnosis.h"
#include "app/verbs/verbs.h"

namespace hepatica {

void add_diagnose(CommandLine& line) {
    line.add_verb("diagnose", "What this computer offers: processor, graphics, library versions",
                  [](Job&) { return diagnosis(); });
}

}  // namespace hepatica
