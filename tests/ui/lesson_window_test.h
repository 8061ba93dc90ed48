// SPDX-License-Identifier: GPL-3.0-or-later
// What tests of lessons in the whole window share: the small patient, lessons in files, and what
// the panel says.
#pragma once

#include <QLabel>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "tests/session/small_patient.h"
#include "tests/ui/window_test.h"
#include "ui/lesson_dock.h"
#include "ui/paths.h"

namespace hepatica::testing {

// The small patient is whatever is opened.
class LessonWindowTest : public WindowTest {
  protected:
    LessonWindowTest()
        : WindowTest({[](const OpenRequest& request, Job& job) {
                          LoadedPatient loaded = play(test::small_patient(), job);
                          if (request.built_in)
                              loaded.title = built_in_title;
                          else
                              loaded.folder = request.reconstruct.ct;
                          return loaded;
                      },
                      [](const std::filesystem::path&, const PatientCase&) {}}) {}

    std::string lesson_file(const std::string& goal) {
        const std::string file = folder_.filePath("lesson.json").toStdString();
        std::ofstream(file) << R"({"format": "hepatica-lesson", "version": 1, "name": "Take hold",
            "scene": {"name": "take hold", "deform": {}}, "tools": ["pull"],
            "marks": {"the mark": {"share_of_longest_path": 0.2}},
            "steps": [{"text": "Take the vessel", "goal": [)"
                            << goal << R"(]}, {"text": "Let it go",
                 "goal": [{"what": "holding", "at_most": 0}]}]})";
        return file;
    }
    // Who has read the task lets the clock run.
    void start_clock() {
        ASSERT_TRUE(wait_for([&] {
            return window_.lessons().playing() && !window_.busy() &&
                   window_.frame().statistics.paused;
        }));
        window_.actions()[ActionId::pause_simulation].trigger();
    }
    QString shown(const char* name) { return window_.lessons().findChild<QLabel*>(name)->text(); }
    std::filesystem::path only_recording() {
        std::vector<std::filesystem::path> files;
        for (const auto& entry :
             std::filesystem::directory_iterator(to_path(folder_.filePath("recordings"))))
            if (entry.path().extension() == ".hrec") files.push_back(entry.path());
        EXPECT_EQ(files.size(), 1u);
        return files.front();
    }
};

}  // namespace hepatica::testing
