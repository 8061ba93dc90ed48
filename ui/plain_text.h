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

// Likewise in lines of a readable width: a tool tip of plain text is one long line, which the edge
// of the screen pushes over whatever lies beside the view.
inline QString in_short_lines(const QString& text) {
    return "<p>" + text.toHtmlEscaped().replace("\n", "<br>") + "</p>";
}

}  // namespace hepatica
