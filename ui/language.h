// SPDX-License-Identifier: GPL-3.0-or-later
// The language of the window: the chosen one, else the system's if there is a translation, else
// English. Numbers in the window follow it; files, JSON and CSV never do. UI thread only.
#pragma once

#include <QString>
#include <span>

namespace hepatica {

struct Language {
    const char* code;  // "de"; empty: the system's language
    const char* name;  // in the language itself
};

// The languages to choose from, the system's first.
std::span<const Language> languages();

// Resolves a choice to a language code; an unknown choice means the system's language.
QString language_of(const QString& chosen);

// Sets the translations of the program and of Qt and the default QLocale, for widgets made from now
// on. To be called with an application, before the first widget.
void use_language(const QString& chosen);
// Code of the language used last; "en" before.
QString spoken_language();

}  // namespace hepatica
