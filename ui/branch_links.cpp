// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/branch_links.h"

#include <QRegularExpression>

namespace hepatica {
namespace {

const QString scheme = "branch:";

// A number cut off by an ellipsis does not match.
const QRegularExpression& name_of_branch() {
    static const QRegularExpression name("\\b((?:Branch|branch|Ast) (\\d+))(?![\\d…])");
    return name;
}

}  // namespace

QString with_branch_links(const QString& html, const QColor& colour) {
    return QString(html).replace(name_of_branch(), "<a href=\"" + scheme + "\\2\" style=\"color:" +
                                                       colour.name() + "\">\\1</a>");
}

std::optional<int> branch_of_link(const QString& link) {
    bool is_number = false;
    const int number = link.mid(scheme.size()).toInt(&is_number);
    if (!link.startsWith(scheme) || !is_number || number < 1) return std::nullopt;
    return number - 1;
}

std::optional<int> branch_named_in(const QString& text) {
    const QRegularExpressionMatch match = name_of_branch().match(text);
    return match.hasMatch() ? branch_of_link(scheme + match.captured(2)) : std::nullopt;
}

}  // namespace hepatica
