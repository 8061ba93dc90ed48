// SPDX-License-Identifier: GPL-3.0-or-later
// Every word that a user of the window sees goes through here: its English is its id, its
// translation stands in translations/. One context for all, as a word that is said in several
// places is translated once; where it means two things a disambiguation tells them apart.
#pragma once

#include <QCoreApplication>

namespace hepatica {

class Words {
    Q_DECLARE_TR_FUNCTIONS(Words)  // tr(english, disambiguation, n)

  public:
    // Marks an English text that is translated later, where it is shown: tables that are made
    // before a language is chosen, errors and stages of jobs.
    static constexpr const char* id(const char* english) { return english; }
};

}  // namespace hepatica
