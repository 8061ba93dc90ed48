// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/quality_panel.h"

#include <QCheckBox>
#include <QComboBox>
#include <QFormLayout>
#include <QGroupBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <QSlider>
#include <QStringList>
#include <QVBoxLayout>
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "core/base/units.h"
#include "core/scene/measured_dial.h"
#include "core/scene/scene_spec.h"
#include "ui/core_words.h"
#include "ui/decimal_spin_box.h"
#include "ui/lesson_tools.h"
#include "ui/words.h"

namespace hepatica {
namespace {

// Initial stiffness of scenes: see DeformSpec.
const double tissue_pa_per_mm2 = DeformSpec{}.tether_pa_per_mm2;

// Named as on the command line. The last one is offered only if it was chosen there.
constexpr std::array<std::pair<const char*, const char*>, 4> back_ends{{
    {"cpu", Words::id("Processor")},
    {"cuda", Words::id("CUDA device")},
    {"auto", Words::id("CUDA, else processor")},
    {"cuda-emulated", Words::id("CUDA device, emulated")},
}};

// `iterations` of the linear solver in a step; 0: it is direct.
QString words_of_solver(int iterations, bool degraded) {
    return (iterations == 0 ? Words::tr("Each step is solved directly")
                            : Words::tr("%n pass(es) of the solver a step", nullptr, iterations)) +
           (degraded ? Words::tr("; the last step was simplified to stay stable") : QString());
}

// A label with room for its longest texts. One that grows with every simplified step would squash
// what stands below it until all the layouts around have followed.
class RoomyLabel : public QLabel {
  public:
    RoomyLabel(QStringList longest, QWidget* parent)
        : QLabel(parent), longest_(std::move(longest)) {
        setWordWrap(true);
    }
    int heightForWidth(int width) const override {
        int height = QLabel::heightForWidth(width);
        for (const QString& text : longest_) {
            const QRect room(0, 0, width, QWIDGETSIZE_MAX);
            height =
                std::max(height, fontMetrics().boundingRect(room, Qt::TextWordWrap, text).height());
        }
        return height;
    }

  private:
    QStringList longest_;
};

}  // namespace

QString percent_text(double share) {
    const double percent = 100.0 * share;
    const int decimals = percent >= 10.0 ? 0 : percent >= 1.0 ? 1 : 2;
    return QLocale().toString(percent, 'f', decimals) + " %";
}

QualityPanel::QualityPanel(std::function<void(Command)> post, QWidget* parent)
    : QWidget(parent), post_(std::move(post)) {
    auto* column = new QVBoxLayout(this);
    column->addWidget(make_dial());
    body_ = make_body();
    column->addWidget(body_);
    column->addStretch(1);
    show_statistics({});
}

QWidget* QualityPanel::make_dial() {
    auto* box = new QGroupBox(Words::tr("Speed or accuracy"), this);
    auto* column = new QVBoxLayout(box);
    automatic_ = new QCheckBox(Words::tr("Automatic: as accurate as this computer can"), box);
    automatic_->setObjectName("automatic");
    automatic_->setChecked(true);
    automatic_->setToolTip(Words::tr(
        "Picks the most accurate setting whose frames are in time; moving the dial ends it"));
    connect(automatic_, &QCheckBox::clicked, this, [this](bool on) {
        post_(on ? Command(SetAutomaticQuality{true})
                 : Command(SetQuality{dial_->value() / 100.0}));
    });
    column->addWidget(automatic_);
    dial_ = new QSlider(Qt::Horizontal, box);
    dial_->setObjectName("dial");
    dial_->setRange(0, 100);
    dial_->setValue(50);
    dial_->setAccessibleName(Words::tr("Speed or accuracy"));
    connect(dial_, &QSlider::valueChanged, this, [this](int value) {
        automatic_->setChecked(false);
        post_(SetQuality{value / 100.0});
    });
    column->addWidget(dial_);
    auto* ends = new QHBoxLayout;
    ends->addWidget(new QLabel(Words::tr("fastest"), box));
    ends->addWidget(new QLabel(Words::tr("most accurate"), box), 0, Qt::AlignRight);
    column->addLayout(ends);
    error_ = new QLabel(box);
    error_->setWordWrap(true);
    column->addWidget(error_);
    constexpr int many = 999;
    solver_ = new RoomyLabel({words_of_solver(0, true), words_of_solver(many, true)}, box);
    solver_->setObjectName("quiet");
    solver_->setAlignment(Qt::AlignLeft | Qt::AlignTop);
    column->addWidget(solver_);
    column->addWidget(make_back_ends(box));
    return box;
}

QWidget* QualityPanel::make_back_ends(QWidget* parent) {
    auto* rows = new QWidget(parent);
    auto* form = new QFormLayout(rows);
    form->setContentsMargins(0, 0, 0, 0);
    back_ends_ = new QComboBox(rows);
    back_ends_->setObjectName("back_end");
    back_ends_->setAccessibleName(Words::tr("Computed by"));
    back_ends_->setToolTip(
        Words::tr("What makes the steps; a change begins the play anew. On a device the dial "
                  "offers the settings that were measured on it, and with \"else processor\" "
                  "those of the processor beside them"));
    back_ends_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    show_back_end("cpu");
    connect(back_ends_, &QComboBox::activated, this,
            [this] { on_back_end(back_ends_->currentData().toString().toStdString()); });
    form->addRow(Words::tr("Computed by"), back_ends_);
    device_ = new QLabel(rows);
    device_->setObjectName("device");
    device_->setWordWrap(true);
    now_ = new QLabel(Words::tr("Now"), rows);
    now_->setObjectName("deviceHeading");
    form->addRow(now_, device_);
    return rows;
}

void QualityPanel::show_back_end(const std::string& name) {
    back_ends_->clear();
    for (const auto& [known, words] : back_ends)
        if (name == known || &known != &back_ends.back().first)
            back_ends_->addItem(Words::tr(words), QString(known));
    back_ends_->setCurrentIndex(back_ends_->findData(QString::fromStdString(name)));
}

QWidget* QualityPanel::make_body() {
    auto* box = new QGroupBox(Words::tr("The vessels, and what acts on them"), this);
    auto* column = new QVBoxLayout(box);
    gravity_ = new QCheckBox(Words::tr("Gravity (patient on the back)"), box);
    gravity_->setObjectName("gravity");
    connect(gravity_, &QCheckBox::toggled, this,
            [this](bool on) { post_(SetGravity{Vec3(0, on ? units::standard_gravity : 0.0, 0)}); });
    column->addWidget(gravity_);
    tether_ = new QCheckBox(Words::tr("Tissue holds the vessels"), box);
    tether_->setObjectName("tissue");
    tether_->setChecked(true);
    connect(tether_, &QCheckBox::toggled, this,
            [this](bool on) { post_(SetTether{on ? tissue_pa_per_mm2 : 0.0}); });
    column->addWidget(tether_);
    wall_ = new DecimalSpinBox(0.0, thickest_wall_mm, 0.0, 2, "mm", box);
    wall_->setObjectName("wall");
    wall_->setAccessibleName(Words::tr("Thickness of the vessels' wall"));
    wall_->setSpecialValueText(Words::tr("solid"));
    wall_->setSingleStep(0.1);
    wall_->setToolTip(
        Words::tr("Vessels bend like pipes with a wall this thick, from %L1 to %L2 mm; "
                  "0, or more than the radius, is solid")
            .arg(thinnest_wall_mm)
            .arg(thickest_wall_mm));
    connect(wall_, &QDoubleSpinBox::valueChanged, this,
            [this](double wall_mm) { post_(SetWall{wall_mm}); });
    auto* form = new QFormLayout;
    form->addRow(Words::tr("Vessel wall"), wall_);
    column->addLayout(form);
    return box;
}

QualityPanel::Choices QualityPanel::choices() const {
    return {automatic_->isChecked(), gravity_->isChecked(), tether_->isChecked(), dial_->value(),
            wall_->value()};
}

void QualityPanel::show_choices(const Choices& choices) {
    const QSignalBlocker of_dial(dial_), of_gravity(gravity_), of_tether(tether_), of_wall(wall_);
    automatic_->setChecked(choices.automatic);
    dial_->setValue(choices.dial);
    gravity_->setChecked(choices.gravity);
    tether_->setChecked(choices.tether);
    wall_->setValue(choices.wall_mm);
}

void QualityPanel::post_choices() {
    if (!automatic_->isChecked()) post_(SetQuality{dial_->value() / 100.0});
    if (gravity_->isChecked()) post_(SetGravity{Vec3(0, units::standard_gravity, 0)});
    if (!tether_->isChecked()) post_(SetTether{0.0});
    if (wall_->value() > 0.0) post_(SetWall{wall_->value()});
}

void QualityPanel::allow_settings(bool allowed) {
    set_allowed(*body_, allowed);
}

void QualityPanel::show_statistics(const FrameStatistics& statistics) {
    show_error(statistics);
    if (automatic_->isChecked() && statistics.automatic && !dial_->isSliderDown()) {
        const QSignalBlocker silent(dial_);
        dial_->setValue(static_cast<int>(std::lround(100.0 * statistics.quality)));
    }
    solver_->setText(statistics.setting.empty()
                         ? QString()
                         : words_of_solver(statistics.linear_iterations, statistics.degraded));
    device_->setText(statistics.setting.empty()  ? QString()
                     : statistics.device.empty() ? Words::tr("the processor")
                                                 : translated(statistics.device));
    // Nothing is computed where no vessels move: a label alone would promise something.
    now_->setVisible(!device_->text().isEmpty());
    device_->setVisible(!device_->text().isEmpty());
    solver_->setToolTip(Words::tr("Setting of the solver: %1").arg(translated(statistics.setting)));
}

// Errors on the dial are those of the patient's own body against one reference motion; without such
// measurements none is shown.
void QualityPanel::show_error(const FrameStatistics& statistics) {
    const bool on_dial = statistics.expected_error > 0.0;
    const bool own = on_dial && is_of_own_body(statistics.error_reference);
    error_->setText(own ? Words::tr("Expected error %1 of the motion")
                              .arg(percent_text(statistics.expected_error))
                    : on_dial ? Words::tr("Expected error: not measured on these vessels yet")
                              : Words::tr("Expected error: not measured for this scene"));
    error_->setToolTip(
        own ? words_of_reference(statistics.error_reference)
        : on_dial
            ? Words::tr("It is measured while nobody plays: one setting of the dial after the "
                        "other, all against the same motion of these vessels")
            : QString());
}

QString words_of_reference(const std::string& reference) {
    return Words::tr(
               "How far vessels are beside where the slowest, most exact computation of the "
               "same pull has them, as a share of their motion. Each setting of the dial is "
               "compared with that one. It is: %1")
        .arg(translated(reference));
}

}  // namespace hepatica
