// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/lesson_editor/about_page.h"

#include <QCheckBox>
#include <QComboBox>
#include <QFileInfo>
#include <QFormLayout>
#include <QGridLayout>
#include <QGroupBox>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QVBoxLayout>
#include <algorithm>
#include <utility>

#include "core/deform/body/material.h"
#include "ui/core_words.h"
#include "ui/decimal_spin_box.h"
#include "ui/lesson_editor/tool_words.h"
#include "ui/words.h"

namespace hepatica {
namespace {

// Keeps the tools in the order of LessonTool, whatever the order of the clicks.
void allow(Lesson& lesson, LessonTool tool, bool allowed) {
    std::erase(lesson.tools, tool);
    if (allowed) lesson.tools.push_back(tool);
    std::ranges::sort(lesson.tools);
}

}  // namespace

AboutPage::AboutPage(Changes changes, std::function<QString()> shown_patient)
    : LessonPage(std::move(changes)),
      shown_patient_(std::move(shown_patient)),
      name_(new QLineEdit),
      about_(new QPlainTextEdit),
      patient_(new QComboBox) {
    auto* form = new QFormLayout;
    form->addRow(Words::tr("&Name"), name_);
    name_->setObjectName("lessonName");
    connect(name_, &QLineEdit::textChanged, this, [this](const QString& text) {
        change_value("name", [&](Lesson& lesson) {
            lesson.name = text.toStdString();
            // Recordings of different lessons are told apart by the scene's name.
            if (!lesson.name.empty()) lesson.scene.name = lesson.name;
        });
    });
    form->addRow(Words::tr("What &for"), about_);
    about_->setObjectName("lessonAbout");
    about_->setPlaceholderText(Words::tr("For the trainee, before it begins. May be empty."));
    about_->setTabChangesFocus(true);
    about_->setMaximumHeight(90);
    connect(about_, &QPlainTextEdit::textChanged, this, [this] {
        change_value("about",
                     [&](Lesson& lesson) { lesson.about = about_->toPlainText().toStdString(); });
    });
    form->addRow(Words::tr("&Patient"), patient_);
    patient_->setObjectName("lessonPatient");
    connect(patient_, &QComboBox::activated, this, [this] {
        change_value("", [&](Lesson& lesson) {
            lesson.patient = patient_->currentData().toString().toStdString();
        });
    });
    auto* column = new QVBoxLayout(this);
    column->addLayout(form);
    column->addWidget(make_scene());
    column->addWidget(make_tools());
    column->addStretch(1);
}

QCheckBox* AboutPage::add_part(QGroupBox& box, const QString& text, const char* name,
                               void (SceneParts::*set)(SceneSpec&, bool)) {
    auto* check = new QCheckBox(text);
    check->setObjectName(name);
    box.layout()->addWidget(check);
    connect(check, &QCheckBox::toggled, this, [this, set](bool on) {
        change_shape([&](Lesson& lesson) { (parts_.*set)(lesson.scene, on); });
    });
    return check;
}

// A part whose box is not ticked is not built.
QGroupBox* AboutPage::make_scene() {
    auto* box = new QGroupBox(Words::tr("The scene"));
    auto* column = new QVBoxLayout(box);
    moves_ = add_part(*box, Words::tr("The vessels &move"), "lessonMoves", &SceneParts::set_moves);
    auto* form = new QFormLayout;
    form->setContentsMargins(24, 0, 0, 0);
    material_ = new QComboBox;
    material_->setObjectName("lessonMaterial");
    for (const MaterialPreset& preset : material_presets())
        material_->addItem(translated(preset.name), QString::fromStdString(preset.name));
    connect(material_, &QComboBox::activated, this, [this] {
        change_value("", [&](Lesson& lesson) {
            lesson.scene.deform->material = material_->currentData().toString().toStdString();
        });
    });
    form->addRow(Words::tr("Material"), material_);
    column->addLayout(form);
    touches_ =
        add_part(*box, Words::tr("&Tools touch them"), "lessonTouches", &SceneParts::set_touches);
    self_ =
        add_part(*box, Words::tr("They touch &each other"), "lessonSelf", &SceneParts::set_self);
    obstacles_ = add_part(*box, Words::tr("They touch the &liver's surface and tumours"),
                          "lessonObstacles", &SceneParts::set_obstacles);
    tears_ =
        add_part(*box, Words::tr("They te&ar and bleed"), "lessonTears", &SceneParts::set_tears);
    flows_ =
        add_part(*box, Words::tr("A &drug can be injected"), "lessonFlows", &SceneParts::set_flows);
    drug_speed_ = new DecimalSpinBox(0.1, 100.0, 1.0, 1, Words::tr("times as fast as it flows"));
    drug_speed_->setObjectName("lessonDrugSpeed");
    connect(drug_speed_, &DecimalSpinBox::valueChanged, this, [this](double speed) {
        change_value("drug speed", [&](Lesson& lesson) { lesson.scene.flow->drug_speed = speed; });
    });
    auto* drug = new QFormLayout;
    drug->setContentsMargins(24, 0, 0, 0);
    drug->addRow(Words::tr("Its clock runs"), drug_speed_);
    column->addLayout(drug);
    return box;
}

QGroupBox* AboutPage::make_tools() {
    auto* box = new QGroupBox(Words::tr("What the trainee may use"));
    auto* grid = new QGridLayout(box);
    for (std::size_t i = 0; i < tool_words.size(); ++i) {
        const LessonTool tool = tool_words[i].first;
        auto* check = new QCheckBox(Words::tr(tool_words[i].second));
        check->setObjectName(QString("lessonTool_") + name_of(tool));
        connect(check, &QCheckBox::toggled, this, [this, tool](bool on) {
            change_value("", [&](Lesson& lesson) { allow(lesson, tool, on); });
        });
        tools_[i] = {tool, check};
        const int at = static_cast<int>(i);
        tool == LessonTool::settings ? grid->addWidget(check, at / 3 + 1, 0, 1, 3)
                                     : grid->addWidget(check, at / 3, at % 3);
    }
    return box;
}

void AboutPage::fill_patients(const std::string& patient) {
    patient_->clear();
    patient_->addItem(Words::tr("Any patient"), "any");
    patient_->addItem(Words::tr("The built-in patient"), "built-in");
    const QString shown = shown_patient_();
    if (!shown.isEmpty() && shown != "built-in" && shown != unsaved_patient)
        patient_->addItem(Words::tr("The one that is shown: %1").arg(QFileInfo(shown).fileName()),
                          shown);
    if (shown == unsaved_patient) {
        patient_->addItem(Words::tr("The one that is shown: save his case first (Ctrl+S)"));
        patient_->setItemData(patient_->count() - 1, 0, Qt::UserRole - 1);  // cannot be chosen
    }
    const QString chosen = QString::fromStdString(patient);
    if (patient_->findData(chosen) < 0)
        patient_->addItem(QFileInfo(chosen).fileName() + " (" + chosen + ")", chosen);
    patient_->setCurrentIndex(patient_->findData(chosen));
}

void AboutPage::fill_scene(const SceneSpec& scene) {
    moves_->setChecked(scene.deform.has_value());
    for (QWidget* part :
         std::initializer_list<QWidget*>{material_, touches_, self_, obstacles_, tears_})
        part->setEnabled(scene.deform.has_value());
    if (scene.deform)
        material_->setCurrentIndex(
            material_->findData(QString::fromStdString(scene.deform->material)));
    touches_->setChecked(scene.contact && scene.contact->tools);
    self_->setChecked(scene.contact && scene.contact->self);
    obstacles_->setChecked(scene.contact && scene.contact->obstacles != WantedObstacles::none);
    tears_->setChecked(scene.tear.has_value());
    flows_->setChecked(scene.flow.has_value());
    drug_speed_->setEnabled(scene.flow.has_value());
    if (scene.flow) drug_speed_->setValue(scene.flow->drug_speed);
}

void AboutPage::fill(const Lesson& lesson) {
    // A text that has not changed is not set again, so that the cursor keeps its place.
    const QString name = QString::fromStdString(lesson.name);
    if (name_->text() != name) name_->setText(name);
    const QString about = QString::fromStdString(lesson.about);
    if (about_->toPlainText() != about) about_->setPlainText(about);
    fill_patients(lesson.patient);
    fill_scene(lesson.scene);
    for (const auto& [tool, check] : tools_)
        check->setChecked(std::ranges::find(lesson.tools, tool) != lesson.tools.end());
}

}  // namespace hepatica
