// SPDX-License-Identifier: GPL-3.0-or-later
// What core says, in the language of the window. Core knows no language but English: it composes
// errors, warnings, stages of jobs and names of systems. Their English is their id, with %1, %2 for
// what is put in; what has no translation is shown as core said it.
#pragma once

#include <QString>
#include <string>

namespace hepatica {

// Numbers in it get the language's decimal sign; what was put in is translated as well.
QString translated(const std::string& english);

}  // namespace hepatica
