// SPDX-License-Identifier: GPL-3.0-or-later
// Date and time in the language of the window.
#pragma once

#include <QDateTime>
#include <QLocale>

#include "ui/words.h"

namespace hepatica {

// "26 Nov 2026, 10:30", in German "26. Nov. 2026, 10:30".
inline QString date_words(const QDateTime& when) {
    return QLocale().toString(when, Words::tr("d MMM yyyy, hh:mm"));
}

}  // namespace hepatica
