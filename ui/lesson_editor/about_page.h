// SPDX-License-Identifier: GPL-3.0-or-later
// Lesson editor page: name and purpose of the lesson, its patient, the parts of its scene and the
// tools that the trainee may use.
#pragma once

#include <array>
#include <utility>

#include "core/lesson/scene_parts.h"
#include "ui/lesson_editor/lesson_page.h"

class QCheckBox;
class QComboBox;
class QGroupBox;
class QLineEdit;
class QPlainTextEdit;

namespace hepatica {

class DecimalSpinBox;

// Value of `shown_patient` for a patient who is shown but has not been saved as a case.
inline constexpr const char* unsaved_patient = "unsaved";

class AboutPage : public LessonPage {
  public:
    // `shown_patient` returns the shown patient as a lesson names him (a path or "built-in"),
    // `unsaved_patient`, or an empty string if nobody is shown.
    AboutPage(Changes changes, std::function<QString()> shown_patient);

    // Drops the remembered settings of scene parts when another lesson is edited.
    void forget() { parts_.forget(); }

  protected:
    void fill(const Lesson& lesson) override;

  private:
    QGroupBox* make_scene();
    QGroupBox* make_tools();
    QCheckBox* add_part(QGroupBox& box, const QString& text, const char* name,
                        void (SceneParts::*set)(SceneSpec&, bool));
    void fill_patients(const std::string& patient);
    void fill_scene(const SceneSpec& scene);

    std::function<QString()> shown_patient_;
    SceneParts parts_;
    QLineEdit* name_;
    QPlainTextEdit* about_;
    QComboBox* patient_;
    QComboBox* material_ = nullptr;
    QCheckBox *moves_ = nullptr, *touches_ = nullptr, *self_ = nullptr, *obstacles_ = nullptr,
              *tears_ = nullptr, *flows_ = nullptr;
    DecimalSpinBox* drug_speed_ = nullptr;
    std::array<std::pair<LessonTool, QCheckBox*>, 9> tools_{};
};

}  // namespace hepatica
