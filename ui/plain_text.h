// SPDX-License-Identifier: GPL-3.0-or-later
// Texts that hold names of files, patients or lessons, for widgets that guess whether a text is
// HTML: message boxes, tool tips.
#pragma once

#include <QString>
#include <QTextDocument>

namespace hepatica {

// Shows the text as it stands, also where it looks like HTML.
inline QString as_plain(const QString& text) {
    if (!Qt::mightBeRichText(text)) return text;
    return "<span>" + text.toHtmlEscaped().replace("\n", "<br>") + "</span>";
}

}  // namespace hepatica
