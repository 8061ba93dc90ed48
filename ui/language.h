// SPDX-License-Identifier: GPL-3.0-or-later
// In which language the window speaks: the one that is chosen, or else the system's where there is
// a translation into it, or else English. Numbers in the window follow it; files, JSON and CSV
// never do.
#pragma once

#include <QString>
#include <span>

namespace hepatica {

struct Language {
    const char* code;  // "de"; empty: as the system's
    const char* name;  // in the language itself
};

// Those that can be chosen, the system's first.
std::span<const Language> languages();

// The code of the language that a choice comes to; what is no code of languages() is the system's.
QString language_of(const QString& chosen);

// For the whole program and for widgets that are made from now on: translations of the program and
// of Qt, and the default QLocale. Call with an application, before the first widget.
void use_language(const QString& chosen);
// The code of the language that was used last; "en" before.
QString spoken_language();

}  // namespace hepatica
