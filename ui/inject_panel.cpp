// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/inject_panel.h"

#include <QComboBox>
#include <QFormLayout>
#include <QGroupBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>
#include <QSlider>
#include <QVBoxLayout>
#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>
#include <utility>

#include "core/flow/fluid.h"
#include "core/scene/default_injection.h"
#include "core/scene/scene_spec.h"
#include "ui/decimal_spin_box.h"
#include "ui/folded_form.h"
#include "ui/lesson_tools.h"
#include "ui/words.h"

namespace hepatica {
namespace {

constexpr int slider_steps = 1000;
constexpr int key_step = slider_steps / 100;
constexpr int page_step = slider_steps / 10;

constexpr double least_g_s = 0.001;
constexpr double most_g_s = 100.0;

struct Preset {
    const char* name;
    const char* second_phase;
    double void_fraction;
    const char* source;
};

constexpr std::array<Preset, 3> presets{{
    {Words::id("Water-soluble carrier"), "carrier", 0.0,
     Words::id("Flows like blood: 3.5 mPa s, 1060 kg/m³.")},
    {Words::id("Lipiodol emulsion, 2 to 1"), "lipiodol", 0.67,
     Words::id("Iodised oil, 25 mPa s and 1280 kg/m³ at 37 °C: given into the hepatic artery in "
               "chemoembolization, and with glue into the portal vein before a resection.")},
    {Words::id("Gas, as in the paper"), "gas", 0.40,
     Words::id(
         "A share of gas of 0.386 to 0.433 in the paper. In blood this would be an air embolus.")},
}};

// Index of the preset that is the default injection.
int first_preset() {
    const auto found = std::ranges::find_if(presets, [](const Preset& preset) {
        return std::string_view(preset.second_phase) == default_injection::second_phase &&
               preset.void_fraction == default_injection::void_fraction;
    });
    return found == presets.end() ? 0 : static_cast<int>(found - presets.begin());
}

struct LawChoice {
    const char* name;  // as in recordings and on the command line
    const char* words;
    const char* tip;
};

constexpr std::array<LawChoice, 3> models{{
    {"regime", Words::id("laminar to turbulent"),
     Words::id("The usual one (regime): wall friction once, for laminar and for turbulent flow")},
    {"consistent", Words::id("of the paper, corrected"),
     Words::id("Consistent: equation (10) of the paper with the flux along the cone")},
    {"published", Words::id("of the paper, as printed"),
     Words::id("Published: equations (5) to (10) of the paper as printed")},
}};

}  // namespace

InjectPanel::InjectPanel(std::function<void(Command)> post, QWidget* parent)
    : QWidget(parent), post_(std::move(post)), chosen_speed_(FlowSpec{}.drug_speed) {
    auto* column = new QVBoxLayout(this);
    column->addWidget(make_settings());
    column->addWidget(make_clock());
    hover_ = new QLabel(this);
    hover_->setObjectName("quiet");
    hover_->setAccessibleName(Words::tr("Under the mouse"));
    hover_->setWordWrap(true);
    hover_->setMinimumHeight(3 * fontMetrics().height());
    hover_->setAlignment(Qt::AlignTop | Qt::AlignLeft);
    column->addWidget(hover_);
    column->addLayout(make_units());
    column->addStretch(1);
    preset_->setCurrentIndex(first_preset());
    choose_preset(first_preset());
    show_hover({});
    show_drug({});
}

QWidget* InjectPanel::make_settings() {
    auto* box = new QGroupBox(Words::tr("Next injection"), this);
    auto* form = new QFormLayout(box);
    preset_ = new QComboBox(box);
    preset_->setObjectName("drug");
    for (const Preset& preset : presets) preset_->addItem(Words::tr(preset.name));
    connect(preset_, &QComboBox::currentIndexChanged, this,
            [this](int index) { choose_preset(index); });
    form->addRow(Words::tr("Drug"), preset_);
    source_ = new QLabel(box);
    source_->setObjectName("quiet");
    source_->setWordWrap(true);
    form->addRow(source_);
    flow_ =
        new DecimalSpinBox(least_g_s, most_g_s, default_injection::mass_flow_g_s, 3, "g/s", box);
    flow_->setObjectName("flow");
    flow_->setSingleStep(0.5);
    flow_->setToolTip(Words::tr("Mass flow at the catheter's tip"));
    flow_label_ = new QLabel(Words::tr("Mass flow"), box);
    flow_label_->setBuddy(flow_);
    form->addRow(flow_label_, flow_);
    mass_flow_ = new QLabel(box);
    mass_flow_->setObjectName("quiet");
    mass_flow_->setWordWrap(true);
    mass_flow_->hide();
    form->addRow(mass_flow_);
    connect(flow_, &QDoubleSpinBox::valueChanged, this, [this] { show_mass_flow(); });
    void_fraction_ = new DecimalSpinBox(0.0, 0.999, default_injection::void_fraction, 3, "", box);
    void_fraction_->setSingleStep(0.05);
    void_fraction_->setToolTip(Words::tr(
        "Share of the volume that oil or gas takes (the void fraction of the pressure law)"));
    connect(void_fraction_, &QDoubleSpinBox::valueChanged, this, [this] { show_flow_range(); });
    form->addRow(Words::tr("Share of oil or gas"), void_fraction_);
    auto* more = new FoldedForm(Words::tr("More about its flow"), box);
    more->setObjectName("moreOfInjection");
    form->addRow(more);
    viscosity_ = new DecimalSpinBox(0.0, 1000.0, 0.0, 1, "mPa s", more);
    viscosity_->setSpecialValueText(Words::tr("of the mixture"));
    viscosity_->setToolTip(Words::tr("Viscosity of what is injected; 0 takes that of the mixture"));
    more->form().addRow(Words::tr("Viscosity"), viscosity_);
    model_ = new QComboBox(more);
    for (const LawChoice& law : models) {
        model_->addItem(Words::tr(law.words), law.name);
        model_->setItemData(model_->count() - 1, Words::tr(law.tip), Qt::ToolTipRole);
    }
    model_->setCurrentIndex(model_->findData(default_injection::pressure_model));
    model_->setToolTip(
        Words::tr("How the pressure along a vessel is computed from the flow through it"));
    more->form().addRow(Words::tr("Pressure law"), model_);
    return box;
}

QLayout* InjectPanel::make_units() {
    units_choice_ = new QComboBox(this);
    units_choice_->setObjectName("flowUnits");
    for (const FlowUnits units : all_flow_units) units_choice_->addItem(choice_words(units));
    units_choice_->setToolTip(Words::tr("Of flows and pressures in the panels and curves"));
    connect(units_choice_, &QComboBox::activated, this,
            [this](int index) { choose_units(static_cast<FlowUnits>(index)); });
    auto* form = new QFormLayout;
    form->addRow(Words::tr("Units"), units_choice_);
    return form;
}

QWidget* InjectPanel::make_clock() {
    auto* box = new QGroupBox(Words::tr("Drug front"), this);
    auto* column = new QVBoxLayout(box);
    auto* row = new QHBoxLayout;
    play_ = new QPushButton(Words::tr("Play"), box);
    play_->setObjectName("play");
    connect(play_, &QPushButton::clicked, this, [this] { toggle_playing(); });
    row->addWidget(play_);
    time_label_ = new QLabel(box);
    row->addWidget(time_label_, 1, Qt::AlignRight);
    column->addLayout(row);
    time_ = new QSlider(Qt::Horizontal, box);
    time_->setObjectName("drugTime");
    time_->setRange(0, slider_steps);
    time_->setSingleStep(key_step);
    time_->setPageStep(page_step);
    time_->setAccessibleName(Words::tr("Time of the drug front"));
    connect(time_, &QSlider::valueChanged, this,
            [this](int place) { ask_for_time(drug_.end_s * place / slider_steps); });
    column->addWidget(time_);
    auto* form = new QFormLayout;
    speed_ = new DecimalSpinBox(0.01, 100.0, FlowSpec{}.drug_speed, 2, "×", box);
    speed_->setObjectName("speed");
    speed_->setToolTip(Words::tr("Seconds of the drug's clock per second of the simulation"));
    connect(speed_, &QDoubleSpinBox::valueChanged, this, [this](double factor) {
        show_pace();
        ask_for_speed(factor);
    });
    form->addRow(Words::tr("Speed"), speed_);
    column->addLayout(form);
    pace_ = new QLabel(box);
    pace_->setObjectName("drugPace");
    pace_->setWordWrap(true);
    column->addWidget(pace_);
    show_pace();
    return box;
}

void InjectPanel::choose_preset(int index) {
    const Preset& preset = presets.at(static_cast<std::size_t>(index));
    void_fraction_->setValue(preset.void_fraction);
    source_->setText(Words::tr(preset.source));
    show_flow_range();
}

double InjectPanel::density_g_mm3() const {
    const Preset& preset = presets.at(static_cast<std::size_t>(preset_->currentIndex()));
    return mixture(blood(), second_phase(preset.second_phase), void_fraction_->value())
        .density_g_mm3;
}

double InjectPanel::mass_flow_g_s() const {
    if (units_ == FlowUnits::computed) return flow_->value();
    return std::clamp(g_s_of(flow_->value(), density_g_mm3()), least_g_s, most_g_s);
}

void InjectPanel::set_mass_flow(double g_s) {
    flow_->setValue(units_ == FlowUnits::clinic ? ml_min_of(g_s, density_g_mm3()) : g_s);
}

// In clinical units the volume flow stays when the density changes, as with a pump.
void InjectPanel::show_flow_range() {
    if (units_ == FlowUnits::computed) return flow_->setRange(least_g_s, most_g_s);
    const double density = density_g_mm3();
    flow_->setRange(ml_min_of(least_g_s, density), ml_min_of(most_g_s, density));
    show_mass_flow();
}

// Lessons count doses in grams, whose millilitres depend on the drug.
void InjectPanel::show_mass_flow() {
    mass_flow_->setVisible(units_ == FlowUnits::clinic);
    mass_flow_->setText(Words::tr("That is %L1 g/s of the drug; doses are counted in g.")
                            .arg(mass_flow_g_s(), 0, 'g', 3));
}

void InjectPanel::choose_units(FlowUnits units) {
    set_units(units);
    if (on_units) on_units(units);
}

void InjectPanel::set_units(FlowUnits units) {
    const double chosen_g_s = mass_flow_g_s();
    units_ = units;
    units_choice_->setCurrentIndex(static_cast<int>(units));
    const bool clinic = units == FlowUnits::clinic;
    flow_->setDecimals(clinic ? 2 : 3);
    flow_->setSuffix(clinic ? " mL/min" : " g/s");
    flow_->setSingleStep(clinic ? 10.0 : 0.5);
    show_flow_range();
    set_mass_flow(chosen_g_s);
    flow_label_->setText(clinic ? Words::tr("Volume flow") : Words::tr("Mass flow"));
    show_mass_flow();
    flow_->setToolTip(clinic ? Words::tr("Volume flow at the catheter's tip")
                             : Words::tr("Mass flow at the catheter's tip"));
}

InjectDrug InjectPanel::injection_at(const Vec3& point_mm) const {
    InjectDrug injection;
    injection.point_mm = point_mm;
    injection.mass_flow_g_s = mass_flow_g_s();
    injection.void_fraction = void_fraction_->value();
    injection.pressure_model = model_->currentData().toString().toStdString();
    injection.second_phase =
        presets.at(static_cast<std::size_t>(preset_->currentIndex())).second_phase;
    if (viscosity_->value() > 0.0) injection.drug_viscosity_pa_s = 1e-3 * viscosity_->value();
    return injection;
}

void InjectPanel::ask_for_time(double time_s) {
    asked_time_s_ = time_s;
    post_(PlayDrug{false});
    post_(SetDrugTime{time_s});
}

void InjectPanel::ask_for_speed(double factor) {
    asked_speed_ = factor;
    if (free_play_) chosen_speed_ = factor;
    post_(SetDrugSpeed{factor});
}

// Explains why the drug's clock and the play's clock differ.
void InjectPanel::show_pace() {
    pace_->setText(Words::tr("%L1 s of the drug pass in each second of the play.")
                       .arg(speed_->value(), 0, 'g', 4));
    pace_->setVisible(speed_->value() != 1.0);
}

// A value that is shown already is not set again, because it may just be being edited.
void InjectPanel::show_speed(double factor) {
    constexpr double last_digit = 0.01;
    const double bounded = std::clamp(factor, speed_->minimum(), speed_->maximum());
    if (std::abs(bounded - speed_->value()) <= 0.5 * last_digit) return;
    const QSignalBlocker silent(speed_);
    speed_->setValue(bounded);
    show_pace();
}

void InjectPanel::show_drug(const DrugView& drug) {
    if (asked_speed_ == drug.speed) asked_speed_.reset();
    if (!asked_speed_) show_speed(drug.speed);
    const bool heard = asked_time_s_ == drug.time_s;
    if (heard || drug.version != drug_.version || !drug.arrival_s) asked_time_s_.reset();
    drug_ = drug;
    const bool injected = drug.arrival_s != nullptr;
    play_->setEnabled(injected);
    time_->setEnabled(injected && settings_allowed_);
    play_->setText(drug.playing ? Words::tr("Pause") : Words::tr("Play"));
    if (!injected) {
        time_label_->setText(Words::tr("nothing injected"));
        const QSignalBlocker silent(time_);
        time_->setValue(0);
        return;
    }
    if (!time_->isSliderDown() && !asked_time_s_ && drug.end_s > 0.0) {
        const QSignalBlocker silent(time_);
        const double share = std::clamp(drug.time_s / drug.end_s, 0.0, 1.0);
        time_->setValue(static_cast<int>(std::lround(slider_steps * share)));
    }
    time_label_->setText(Words::tr("%L1 of %L2 s")
                             .arg(std::min(drug.time_s, drug.end_s), 0, 'f', 2)
                             .arg(drug.end_s, 0, 'f', 2));
}

void InjectPanel::show_hover(const QString& text) {
    hover_->setText(text.isEmpty() ? Words::tr("Point at a vessel to see what lies downstream.")
                                   : text);
}

void InjectPanel::begin_play(bool free) {
    if (free) give_back();
    free_play_ = free;
    asked_speed_.reset();
    if (!free) return;
    show_speed(chosen_speed_);
    if (chosen_speed_ != FlowSpec{}.drug_speed) ask_for_speed(chosen_speed_);
}

void InjectPanel::choose_drug(const std::string& wanted) {
    give_back();
    before_lesson_ = {preset_->currentIndex(), model_->currentIndex(), void_fraction_->value(),
                      mass_flow_g_s(), viscosity_->value()};
    for (std::size_t i = 0; i < presets.size(); ++i) {
        if (presets[i].second_phase != wanted) continue;
        return preset_->setCurrentIndex(static_cast<int>(i));
    }
}

void InjectPanel::give_back() {
    const auto before = std::exchange(before_lesson_, std::nullopt);
    if (!before) return;
    preset_->setCurrentIndex(before->preset);
    model_->setCurrentIndex(before->model);
    void_fraction_->setValue(before->void_fraction);
    viscosity_->setValue(before->viscosity_mpa_s);
    set_mass_flow(before->mass_flow_g_s);  // last: of this drug
}

void InjectPanel::allow_settings(bool allowed) {
    settings_allowed_ = allowed;
    set_allowed(*speed_, allowed);
    time_->setEnabled(allowed && drug_.arrival_s);
}

void InjectPanel::toggle_playing() {
    if (!drug_.arrival_s) return;
    // A drug that has arrived everywhere starts again.
    if (!drug_.playing && drug_.time_s >= drug_.end_s) post_(SetDrugTime{0.0});
    asked_time_s_.reset();
    post_(PlayDrug{!drug_.playing});
}

}  // namespace hepatica
