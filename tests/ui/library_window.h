// SPDX-License-Identifier: GPL-3.0-or-later
// A window whose library holds one case, and what its tests ask of it.
#pragma once

#include <QLabel>
#include <QListWidget>
#include <QPushButton>
#include <QTreeWidget>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "core/patient/patient_case.h"
#include "tests/session/small_patient.h"
#include "tests/ui/window_test.h"
#include "ui/lesson_dock.h"
#include "ui/library_dialog.h"
#include "ui/paths.h"

namespace hepatica::testing {

namespace fs = std::filesystem;

// Of a vessel to be taken hold of.
inline void write_lesson_for(const fs::path& file, const std::string& name,
                             const std::string& patient) {
    std::ofstream(file) << R"({"format": "hepatica-lesson", "version": 1, "about": "Take <it>.",
        "name": ")" << name
                        << R"(", "patient": ")" << patient
                        << R"(", "scene": {"name": "take hold", "deform": {}},
        "tools": ["pull"], "marks": {"the mark": {"share_of_longest_path": 0.2}},
        "steps": [{"text": "Take it", "goal": [{"what": "holding", "at_least": 1}]}]})";
}

class LibraryTest : public WindowTest {
  protected:
    LibraryTest()
        : WindowTest({[this](const OpenRequest& request, Job& job) {
                          opened_ = request.reconstruct.ct;
                          LoadedPatient loaded = play(test::small_patient(), job);
                          loaded.packed_lessons = packed_;
                          return loaded;
                      },
                      [](const fs::path&, const PatientCase&) {}}),
          cases_(to_path(folder_.filePath("cases"))) {
        fs::create_directory(cases_);
        write_case(cases_ / "first.hep", *test::small_patient());
        settings_.set_library_folder(to_text(cases_));
    }
    LibraryDialog& dialog() { return window_.library(); }
    void open_library() {
        window_.actions()[ActionId::open_library].trigger();
        ASSERT_TRUE(wait_for([this] { return !dialog().busy() && !dialog().cases().empty(); }));
    }
    // The chosen case in one file of this name.
    fs::path given_away(const char* name) {
        const fs::path file = to_path(folder_.filePath(name));
        dialog().give_away(file);
        EXPECT_TRUE(wait_for([&] { return fs::exists(file) && !dialog().busy(); }));
        return file;
    }
    QTreeWidget& lessons() { return *dialog().findChild<QTreeWidget*>("caseLessons"); }
    QPushButton& begin_button() { return *dialog().findChild<QPushButton*>("caseLessonBegin"); }
    // "part: lesson, lesson", one a line.
    QStringList listed() {
        QStringList lines;
        for (int i = 0; i < lessons().topLevelItemCount(); ++i) {
            const QTreeWidgetItem* part = lessons().topLevelItem(i);
            QStringList names;
            for (int k = 0; k < part->childCount(); ++k) names << part->child(k)->text(0);
            lines << part->text(0) + ": " + names.join(", ");
        }
        return lines;
    }
    QPoint place_of(int part, int lesson) {
        return lessons().visualItemRect(lessons().topLevelItem(part)->child(lesson)).center();
    }
    // The lesson of this name runs on the patient of that case.
    bool plays(const QString& name) {
        return window_.lessons().playing() &&
               window_.lessons().findChild<QLabel*>("lessonTitle")->text().contains(name);
    }

    fs::path cases_, opened_;
    std::vector<std::string> packed_;  // lessons in the file of who is opened
};

}  // namespace hepatica::testing
