// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/file_name.h"

#include <QDir>
#include <QFileInfo>
#include <QRegularExpression>

namespace hepatica {

QString as_file_name(const QString& name, const QString& otherwise) {
    static const QRegularExpression refused(R"([/\\:*?"<>|\x{00}-\x{1f}\x{7f}]+)");
    // Names that begin with a dot are hidden; Windows drops dots and spaces at the end.
    static const QRegularExpression ends(R"(^[. ]+|[. ]+$)");
    constexpr qsizetype most_bytes = 180;  // of 255 that file systems take
    QString clean = QString(name).replace(refused, " ").simplified();
    while (clean.toUtf8().size() > most_bytes) {
        clean.chop(1);
        if (!clean.isEmpty() && clean.back().isHighSurrogate()) clean.chop(1);
    }
    clean.remove(ends);
    return clean.isEmpty() ? otherwise : clean;
}

QString free_name(const QString& folder, const QString& name) {
    const QFileInfo wanted(name);
    QString free = name;
    for (int n = 2; QFileInfo::exists(QDir(folder).filePath(free)); ++n)
        free = QString("%1 (%2).%3").arg(wanted.completeBaseName()).arg(n).arg(wanted.suffix());
    return free;
}

}  // namespace hepatica
