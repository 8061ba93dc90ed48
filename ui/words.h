// SPDX-License-Identifier: GPL-3.0-or-later
// Every text that a user of the window sees goes through Words: its English is its id, its
// translation is in translations/. There is one context, so that a text used in several places is
// translated once; a disambiguation separates different meanings.
#pragma once

#include <QCoreApplication>

namespace hepatica {

class Words {
    Q_DECLARE_TR_FUNCTIONS(Words)  // tr(english, disambiguation, n)

  public:
    // Marks an English text that is translated later, when it is shown: tables made before a
    // language is chosen, errors, stages of jobs.
    static constexpr const char* id(const char* english) { return english; }
};

}  // namespace hepatica
