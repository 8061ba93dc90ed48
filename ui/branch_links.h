// SPDX-License-Identifier: GPL-3.0-or-later
// Branches that a message names, as a way to them: "Branch 162" of the table is a link.
#pragma once

#include <QColor>
#include <QString>
#include <optional>

namespace hepatica {

// `html` with a link about each branch that it names whole, in the window's language, of this
// colour.
QString with_branch_links(const QString& html, const QColor& colour);

// Which branch of the tree, from 0, such a link stands for; none where it is another link.
std::optional<int> branch_of_link(const QString& link);

// The first that a text names.
std::optional<int> branch_named_in(const QString& text);

}  // namespace hepatica
