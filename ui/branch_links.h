// SPDX-License-Identifier: GPL-3.0-or-later
// Turns branch names in messages, such as "Branch 162" of the table, into links.
#pragma once

#include <QColor>
#include <QString>
#include <optional>

namespace hepatica {

// Returns `html` with a link of this colour for each complete branch name in the window's language.
QString with_branch_links(const QString& html, const QColor& colour);

// Index of the branch that such a link names; nullopt for any other link.
std::optional<int> branch_of_link(const QString& link);

// Index of the first branch that a text names; nullopt if none.
std::optional<int> branch_named_in(const QString& text);

}  // namespace hepatica
