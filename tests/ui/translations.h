// SPDX-License-Identifier: GPL-3.0-or-later
// Reads the translations as Qt's tools write them.
#pragma once

#include <QString>
#include <QStringList>
#include <vector>

namespace hepatica::testing {

struct Translation {
    QString source;
    QStringList forms;  // one; of those that are numbered one for each plural
    bool numbered = false;
    bool finished = false;
};

QString translation_file(const char* language);
std::vector<Translation> translations_in(const QString& file);

}  // namespace hepatica::testing
