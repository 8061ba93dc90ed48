// SPDX-License-Identifier: GPL-3.0-or-later
// Translates what core says. Core composes errors, warnings, stages and names in English; the
// English text, with %1, %2 for inserted parts, is the id of its translation. Untranslated text is
// shown as it is. Places, which core writes as coordinates, are said as radiologists read them.
#pragma once

#include <QString>
#include <string>

namespace hepatica {

// Numbers get the language's decimal sign, and inserted parts are translated too. A sentence that
// is unknown is returned unchanged.
QString translated(const std::string& english);

}  // namespace hepatica
