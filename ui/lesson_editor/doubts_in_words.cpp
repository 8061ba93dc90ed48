// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/lesson_editor/doubts_in_words.h"

#include <QStringList>

#include "core/base/error.h"
#include "core/lesson/lesson_doubts.h"
#include "core/lesson/lesson_file.h"
#include "core/lesson/lesson_gaps.h"
#include "core/lesson/lesson_ties.h"
#include "core/lesson/lesson_writer.h"
#include "ui/core_words.h"
#include "ui/paths.h"
#include "ui/words.h"

namespace hepatica {
namespace {

// What keeps the lesson from being played; empty if nothing does.
QStringList gaps_in_words(const Lesson& lesson) {
    QStringList lines;
    for (const std::string& gap : gaps_in(lesson)) lines << translated(gap);
    if (!lines.isEmpty()) return lines;
    try {
        lesson_of(text_of(lesson), Words::id("This lesson"));
    } catch (const InputError& error) {  // an error in a part that no page shows
        lines << QString("%1 %2. %3.")
                     .arg(translated(error.place()), translated(error.problem()),
                          translated(error.remedy()));
    }
    return lines;
}

// For the lesson's own patient, checks whether its points still lie on the vessels where they were;
// for another patient, whether the lesson fits him at all.
std::vector<std::string> place_doubts(const Lesson& lesson, const VesselTree& tree,
                                      const QString& shown) {
    if (!is_for_shown(lesson, shown)) return doubts_about_another(lesson, tree);
    std::vector<std::string> doubts = misfits(lesson, tree);
    return doubts.empty() ? doubts_about_places(lesson, tree) : doubts;
}

// True if a correction of the patient's vessels would move the lesson's places unnoticed, because
// they are not tied to the vessels, and saving will not tie them.
bool is_left_untied(const Lesson& lesson, const PatientCase* patient, const QString& shown) {
    const bool tied_by_saving = patient != nullptr && is_for_shown(lesson, shown);
    return can_be_tied(lesson) && !tied_by_saving && !is_tied(lesson);
}

}  // namespace

bool is_for_shown(const Lesson& lesson, const QString& shown) {
    return lesson.patient == "any" || lesson.patient == shown.toStdString() ||
           same_place(lesson.patient, to_path(shown));
}

QString doubts_in_words(const Lesson& lesson, const PatientCase* patient, const QString& shown) {
    QStringList lines = gaps_in_words(lesson);
    for (const std::string& doubt : doubts_about(lesson)) lines << translated(doubt);
    if (patient != nullptr)
        for (const std::string& doubt : place_doubts(lesson, patient->tree, shown))
            lines << translated(doubt);
    if (is_left_untied(lesson, patient, shown))
        lines << Words::tr(
            "Where its places lie on the vessels is not noted yet: open its "
            "patient, and save it then.");
    constexpr qsizetype most = 4;
    if (lines.size() > most)
        lines = lines.mid(0, most - 1)
                << Words::tr("and %n more", nullptr, static_cast<int>(lines.size() - most + 1));
    for (QString& line : lines) line.prepend("• ");
    return lines.join("\n");
}

}  // namespace hepatica
