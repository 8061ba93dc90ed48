// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/lesson_editor/doubts_in_words.h"

#include <QStringList>

#include "core/base/error.h"
#include "core/lesson/lesson_doubts.h"
#include "core/lesson/lesson_file.h"
#include "core/lesson/lesson_gaps.h"
#include "core/lesson/lesson_writer.h"
#include "ui/core_words.h"
#include "ui/paths.h"
#include "ui/words.h"

namespace hepatica {
namespace {

// What keeps it from being played; empty: nothing.
QStringList gaps_in_words(const Lesson& lesson) {
    QStringList lines;
    for (const std::string& gap : gaps_in(lesson)) lines << translated(gap);
    if (!lines.isEmpty()) return lines;
    try {
        lesson_of(text_of(lesson), Words::id("This lesson"));
    } catch (const InputError& error) {  // of what no page shows
        lines << QString("%1 %2. %3.")
                     .arg(translated(error.place()), translated(error.problem()),
                          translated(error.remedy()));
    }
    return lines;
}

// Whether its points lie on the patient who is shown, or on another one.
std::vector<std::string> place_doubts(const Lesson& lesson, const VesselTree& tree,
                                      const QString& shown) {
    const bool its_own = lesson.patient == "any" || lesson.patient == shown.toStdString() ||
                         same_place(lesson.patient, to_path(shown));
    return its_own ? doubts_about_places(lesson, tree) : doubts_about_another(lesson, tree);
}

}  // namespace

QString doubts_in_words(const Lesson& lesson, const PatientCase* patient, const QString& shown) {
    QStringList lines = gaps_in_words(lesson);
    for (const std::string& doubt : doubts_about(lesson)) lines << translated(doubt);
    if (patient != nullptr)
        for (const std::string& doubt : place_doubts(lesson, patient->tree, shown))
            lines << translated(doubt);
    constexpr qsizetype most = 4;
    if (lines.size() > most)
        lines = lines.mid(0, most - 1)
                << Words::tr("and %n more", nullptr, static_cast<int>(lines.size() - most + 1));
    for (QString& line : lines) line.prepend("• ");
    return lines.join("\n");
}

}  // namespace hepatica
