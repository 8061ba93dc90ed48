// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/tool_panel.h"

#include <QCheckBox>
#include <QFormLayout>
#include <QGroupBox>
#include <QLabel>
#include <QSignalBlocker>
#include <QVBoxLayout>
#include <utility>

#include "core/base/units.h"
#include "core/flow/fluid.h"
#include "core/scene/scene_spec.h"
#include "render/tool_actor.h"
#include "ui/core_words.h"
#include "ui/decimal_spin_box.h"
#include "ui/lesson_tools.h"
#include "ui/words.h"

namespace hepatica {
namespace {

constexpr double thinnest_mm = 0.5, thickest_mm = 20.0;
constexpr double shortest_mm = 2.0, longest_mm = 200.0;

// Empty where no drug has leaked, in tenths of a gram or millilitre. Doses are counted in grams, so
// that these stand beside the millilitres.
QString leaked_drug_text(const TearView& tear, FlowUnits units) {
    constexpr double least = 0.05;
    const double millilitres = tear.leaked_drug_g / blood().density_g_mm3 / units::millilitre;
    const bool computed = units == FlowUnits::computed;
    if ((computed ? tear.leaked_drug_g : millilitres) < least) return {};
    if (computed) return Words::tr(", of it up to %L1 g drug").arg(tear.leaked_drug_g, 0, 'f', 1);
    return Words::tr(", of it up to %L1 mL (%L2 g) drug")
        .arg(millilitres, 0, 'f', 1)
        .arg(tear.leaked_drug_g, 0, 'f', 1);
}

// Faces part before they come apart, and a lesson counts their area.
bool is_split(const TearView& tear) {
    if (tear.origins == nullptr) return false;
    for (std::size_t v = 0; v < tear.origins->size(); ++v)
        if ((*tear.origins)[v] != static_cast<int>(v)) return true;
    return false;
}

QString bleeding_text(const TearView& tear, FlowUnits units) {
    constexpr double with_tenths_g = 9.95;  // below this, as in a lesson's panel
    const QString rate = leak_text(tear.leak_g_s, units);
    if (units == FlowUnits::computed)
        return Words::tr("; bleeds %1, %L2 g so far")
            .arg(rate)
            .arg(tear.leaked_g, 0, 'f', tear.leaked_g < with_tenths_g ? 1 : 0);
    return Words::tr("; bleeds %1, %L2 mL so far")
        .arg(rate)
        .arg(tear.leaked_g / blood().density_g_mm3 / units::millilitre, 0, 'f', 0);
}

// A lumen that is pressed stems nothing unless it is on the way to what bleeds.
QString pressed_text(const TearView& tear) {
    QString text;
    if (tear.open_share < 1.0)
        text = Words::tr("; what feeds the bleeding is pressed to %L1 % of its lumen")
                   .arg(100.0 * tear.open_share, 0, 'g', 2);
    if (tear.other_open_share < 1.0)
        text += Words::tr(
                    "; branch %1, which does not feed the bleeding, is pressed to %L2 % of its "
                    "lumen")
                    .arg(tear.other_segment)
                    .arg(100.0 * tear.other_open_share, 0, 'g', 2);
    return text;
}

}  // namespace

ToolPanel::ToolPanel(Callbacks callbacks, QWidget* parent)
    : QWidget(parent), callbacks_(std::move(callbacks)) {
    auto* column = new QVBoxLayout(this);
    column->addWidget(make_size());
    auto* felt = new QGroupBox(Words::tr("What it feels"), this);
    auto* lines = new QVBoxLayout(felt);
    force_ = new QLabel(felt);
    force_->setObjectName("toolForce");
    force_->setAccessibleName(Words::tr("Force on the tool"));
    lines->addWidget(force_);
    grip_ = new QLabel(felt);
    grip_->setObjectName("toolGrip");
    grip_->setAccessibleName(Words::tr("Force with which the jaws hold"));
    lines->addWidget(grip_);
    column->addWidget(felt);
    column->addWidget(make_contact());
    column->addWidget(make_tear());
    help_ = new QLabel(this);
    help_->setObjectName("quiet");
    help_->setWordWrap(true);
    column->addWidget(help_);
    column->addStretch(1);
    show_kind({});
    show_force(std::nullopt, std::nullopt);
}

QWidget* ToolPanel::make_size() {
    auto* box = new QGroupBox(Words::tr("Size"), this);
    auto* form = new QFormLayout(box);
    const ToolSize begin;
    const auto make = [&](const QString& label, const char* name, double least, double most,
                          double value) {
        auto* field = new DecimalSpinBox(least, most, value, 1, "mm", box);
        field->setObjectName(name);
        field->setAccessibleName(Words::tr("%1 of the tool").arg(label));
        field->setSingleStep(0.5);
        form->addRow(label, field);
        connect(field, &QDoubleSpinBox::valueChanged, this, [this] { callbacks_.resize(size()); });
        return field;
    };
    radius_ = make(Words::tr("Radius"), "toolRadius", thinnest_mm, thickest_mm, begin.radius_mm);
    length_ = make(Words::tr("Length"), "toolLength", shortest_mm, longest_mm, begin.length_mm);
    return box;
}

QWidget* ToolPanel::make_contact() {
    auto* box = new QGroupBox(Words::tr("What the vessels touch"), this);
    auto* form = new QFormLayout(box);
    const auto add = [&](const QString& text, const char* name, const QString& tip) {
        auto* choice = new QCheckBox(text, box);
        choice->setObjectName(name);
        choice->setToolTip(tip);
        form->addRow(choice);
        return choice;
    };
    touch_each_other_ = add(Words::tr("Each other"), "vesselsTouch",
                            Words::tr("Vessels no longer pass through each other. Costs time; a "
                                      "change brings them back to rest"));
    obstacles_ = add(Words::tr("Liver and tumours"), "obstaclesTouch",
                     Words::tr("Vessels stay out of the tumours and within the liver, as far as "
                               "the case knows them; a change brings them back to rest. Tumours "
                               "painted since count after the next correction of a vessel"));
    friction_ = new DecimalSpinBox(0.0, greatest_friction, 0.0, 2, "", box);
    friction_->setObjectName("vesselFriction");
    friction_->setAccessibleName(Words::tr("Friction of vessels on each other"));
    friction_->setToolTip(
        Words::tr("Coulomb's coefficient of vessels that slide on each other; 0: they slip"));
    friction_->setSingleStep(0.05);
    form->addRow(Words::tr("Friction"), friction_);
    friction_->setEnabled(false);
    connect(touch_each_other_, &QCheckBox::clicked, this, [this] { choose_contact(); });
    connect(obstacles_, &QCheckBox::clicked, this, [this] { choose_contact(); });
    connect(friction_, &QDoubleSpinBox::valueChanged, this, [this] { choose_contact(); });
    return box;
}

void ToolPanel::choose_contact() {
    friction_->setEnabled(touch_each_other_->isChecked());
    if (free_play_) {
        wanted_contact_ = contact();
        callbacks_.contact_chosen(contact());
    }
    asked_ = contact();
    asked_at_ = shown_at_;
    callbacks_.use_contact(contact());
}

UseContact ToolPanel::contact() const {
    return {touch_each_other_->isChecked(), obstacles_->isChecked(), friction_->value()};
}

// Obstacles take seconds to prepare; a step under way ends before and may show an older state.
void ToolPanel::show_contact(const Frame& frame) {
    shown_at_ = frame.step;
    const bool as_asked = asked_ && asked_->self == frame.self_friction.has_value() &&
                          asked_->obstacles == (frame.obstacles != nullptr);
    const bool heard = frame.step > asked_at_ + (frame.statistics.resting ? 0 : 1);
    if (as_asked || heard) asked_.reset();
    if (asked_) return;
    const QSignalBlocker quiet(friction_);
    touch_each_other_->setChecked(frame.self_friction.has_value());
    obstacles_->setChecked(frame.obstacles != nullptr);
    if (frame.self_friction) friction_->setValue(*frame.self_friction);
    friction_->setEnabled(frame.self_friction && allowed_);
}

QWidget* ToolPanel::make_tear() {
    auto* box = new QGroupBox(Words::tr("Tearing"), this);
    auto* form = new QFormLayout(box);
    tears_ = new QCheckBox(Words::tr("Vessels tear"), box);
    tears_->setObjectName("vesselsTear");
    tears_->setToolTip(
        Words::tr("Vessels that are pulled beyond their strength tear; off makes them whole"));
    form->addRow(tears_);
    tear_factor_ = new DecimalSpinBox(0.001, 10.0, 1.0, 3, "", box);
    tear_factor_->setObjectName("tearFactor");
    tear_factor_->setAccessibleName(Words::tr("Tear factor: share of the tissue's strength"));
    tear_factor_->setToolTip(
        Words::tr("Share of the tissue's strength at which it tears: the tear factor"));
    form->addRow(Words::tr("Tear factor"), tear_factor_);
    line_strength_ = new DecimalSpinBox(0.0, 1.0, 0.05, 2, "", box);
    line_strength_->setObjectName("lineStrength");
    line_strength_->setAccessibleName(Words::tr("Strength along a cut line"));
    line_strength_->setToolTip(
        Words::tr("What is left of the strength along a cut line that you draw"));
    form->addRow(Words::tr("Along a line"), line_strength_);
    warnings_ = new QCheckBox(Words::tr("Warning colours"), box);
    warnings_->setObjectName("warningColours");
    warnings_->setToolTip(
        Words::tr("Yellow: loaded to more than half of what the vessel bears; red: about to tear"));
    warnings_->setChecked(true);
    connect(warnings_, &QCheckBox::toggled, this,
            [this](bool shown) { callbacks_.show_warnings(shown); });
    form->addRow(warnings_);
    torn_ = new QLabel(box);
    torn_->setObjectName("torn");
    torn_->setAccessibleName(Words::tr("How the vessels are torn"));
    torn_->setWordWrap(true);
    form->addRow(torn_);
    const auto tell = [this] {
        UseTear use = tear();
        use.on = tears_->isChecked();
        if (free_play_) wanted_tear_ = use.on;
        callbacks_.use_tear(use);
    };
    connect(tears_, &QCheckBox::clicked, this, tell);
    connect(tear_factor_, &QDoubleSpinBox::valueChanged, this, [this, tell] {
        if (tears_->isChecked()) tell();
    });
    return box;
}

UseTear ToolPanel::tear() const {
    return {.on = true, .tear_factor = tear_factor_->value()};
}

bool ToolPanel::shows_warnings() const {
    return warnings_->isChecked();
}

double ToolPanel::cut_line_strength() const {
    return line_strength_->value();
}

void ToolPanel::set_units(FlowUnits units) {
    units_ = units;
    show_tear(std::optional(shown_tear_));
}

void ToolPanel::show_tear(const std::optional<TearView>& tear) {
    shown_tear_ = tear;
    tears_->setChecked(tear.has_value());
    torn_->setToolTip({});
    if (!tear) return torn_->setText(Words::tr("nothing cut or torn"));
    QString text = tear->joints_broken > 0
                       ? Words::tr("cut or torn: joints of the mesh broken: %1, pieces off: %2")
                             .arg(tear->joints_broken)
                             .arg(tear->pieces_off)
                   : is_split(*tear) ? Words::tr("begun to tear, nothing is apart yet")
                                     : Words::tr("nothing cut or torn");
    torn_->setToolTip(Words::tr("Damage, as entropy produced by tearing: %L1 nats")
                          .arg(tear->entropy_produced_nats, 0, 'f', 2));
    if (tear->leak_g_s > 0.0 || tear->leaked_g > 0.0)
        text += bleeding_text(*tear, units_) + leaked_drug_text(*tear, units_);
    text += pressed_text(*tear);
    if (!tear->stopped_by.empty())
        text += Words::tr("; stopped by the %1 budget").arg(translated(tear->stopped_by));
    torn_->setText(text);
}

void ToolPanel::begin_play(bool free) {
    free_play_ = free;
    show_tear(std::nullopt);  // until its next figures
    asked_.reset();
    if (!free) return;
    show_tear_factor(std::nullopt);
    if (wanted_contact_) callbacks_.use_contact(*wanted_contact_);
    if (wanted_tear_) callbacks_.use_tear(tear());
}

void ToolPanel::go_on() {
    free_play_ = true;
    show_tear(std::nullopt);  // until its next figures
    asked_.reset();
    show_tear_factor(std::nullopt);
}

void ToolPanel::show_tear_factor(std::optional<double> of_lesson) {
    const QSignalBlocker quiet(tear_factor_);
    const double chosen = wanted_tear_factor_.value_or(tear_factor_->value());
    wanted_tear_factor_.reset();
    if (of_lesson) wanted_tear_factor_ = chosen;
    tear_factor_->setValue(of_lesson.value_or(chosen));
}

void ToolPanel::allow_settings(bool allowed) {
    allowed_ = allowed;
    set_allowed(*touch_each_other_, allowed);
    set_allowed(*obstacles_, allowed);
    set_allowed(*tears_, allowed);
    set_allowed(*tear_factor_, allowed);
}

ToolSize ToolPanel::size() const {
    return {radius_->value(), length_->value()};
}

void ToolPanel::show_kind(const std::string& kind, const QString& line_help) {
    length_->setEnabled(kind != "sphere");
    help_->setText(
        !line_help.isEmpty() ? line_help
        : kind.empty()
            ? Words::tr("Take a tool from the bar above the view.")
            : Words::tr("The mouse leads its tip, the wheel moves it in depth (Ctrl + wheel "
                        "zooms), a click brings it to a vessel, T and Shift + T turn it, C closes "
                        "and opens forceps. By keys: Enter brings it to the cross, arrows lead it, "
                        "Page Up and Page Down move it in depth. Esc puts it away."));
}

void ToolPanel::show_force(const std::optional<ToolView>& tool,
                           const std::optional<GrabView>& hand) {
    const bool pulls = !tool && hand;
    const std::string force = tool    ? force_text(tool->shown_un())
                              : pulls ? force_text(hand->shown_un())
                                      : std::string();
    const std::string grip = tool ? force_text(tool->grip_un) : std::string();
    const bool at_limit = tool ? tool->at_limit : pulls && hand->at_limit;
    QString felt =
        !tool && !pulls ? Words::tr("no tool")
        : force.empty()
            ? (pulls ? Words::tr("pulls at nothing") : Words::tr("touches nothing"))
            : (pulls ? Words::tr("Pull %1") : Words::tr("Force %1")).arg(translated(force));
    if (at_limit) felt += Words::tr(", the most it has");
    force_->setText(felt);
    grip_->setText(grip.empty() ? QString() : Words::tr("Grip %1").arg(translated(grip)));
}

}  // namespace hepatica
