// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/slices/slice_bar.h"

#include <QCheckBox>
#include <QComboBox>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QPushButton>
#include <QSlider>
#include <QVBoxLayout>
#include <algorithm>
#include <array>
#include <optional>
#include <utility>

#include "ui/core_words.h"
#include "ui/decimal_spin_box.h"
#include "ui/slices/seed_doubt.h"
#include "ui/words.h"

namespace hepatica {
namespace {

struct Preset {
    const char* name;
    GreyWindow window;
};

constexpr std::array presets{
    Preset{Words::id("Vessels"), {100.0, 300.0}}, Preset{Words::id("Liver"), {100.0, 150.0}},
    Preset{Words::id("Abdomen"), {40.0, 400.0}},  Preset{Words::id("Lung"), {-600.0, 1500.0}},
    Preset{Words::id("Bone"), {400.0, 1800.0}},
};

// Entries of the list of click actions; 1 to 3 are the measurements.
constexpr int moves_crosshair = 0, draws_vessel = 4, corrects = 5, paints = 6, erases = 7,
              paints_tumour = 8, erases_tumour = 9, sets_seed = 10;

// The systems of seeds, in the order of the entries from sets_seed on.
constexpr std::array seeded{VascularSystem::portal, VascularSystem::hepatic,
                            VascularSystem::artery};

BrushMode mode_of(int click, int painting, int erasing) {
    return click == painting  ? BrushMode::paints
           : click == erasing ? BrushMode::erases
                              : BrushMode::away;
}

bool same(const GreyWindow& a, const GreyWindow& b) {
    return a.level_hu == b.level_hu && a.width_hu == b.width_hu;
}

}  // namespace

SliceBar::SliceBar(SliceScene& scene, std::function<QString()> correction, QWidget* parent)
    : QWidget(parent),
      scene_(scene),
      correction_(std::move(correction)),
      presets_(new QComboBox),
      place_(new QLabel) {
    // Two rows: a single one would be wider than a small screen leaves beside the panels.
    auto* rows = new QVBoxLayout(this);
    rows->setContentsMargins(8, 4, 8, 4);
    rows->setSpacing(2);
    auto* row = new QHBoxLayout;
    auto* lower = new QHBoxLayout;
    rows->addLayout(row);
    rows->addLayout(lower);
    fill_presets();
    place_->setObjectName("slicePlace");
    place_->setTextInteractionFlags(Qt::TextSelectableByMouse);  // seeds are written so
    // Always two lines, so that no text widens the window or moves the slices.
    place_->setWordWrap(true);
    place_->setMinimumWidth(place_->fontMetrics().averageCharWidth() * 16);
    place_->setAlignment(Qt::AlignLeft | Qt::AlignVCenter);
    place_->setFixedHeight(2 * place_->fontMetrics().lineSpacing() + 2);
    row->addWidget(presets_);
    row->addWidget(new QLabel(Words::tr("Vessels")));
    row->addWidget(opacity_slider());
    row->addWidget(centreline_choice());
    row->addWidget(segment_choice());
    row->addStretch(1);
    lower->addWidget(click_choice());
    lower->addWidget(vessel_radius());
    lower->addWidget(draw_button());
    lower->addWidget(seed_button());
    add_brush(*lower);
    lower->addSpacing(8);
    lower->addWidget(place_, 1);
    scene_.on_change([this] {
        if (click_->currentIndex() != chosen_click()) follow_click();
        follow_window();
        show_place(scene_.crosshair_mm());
    });
    follow_window();
}

void SliceBar::fill_presets() {
    presets_->setObjectName("greyWindow");
    presets_->setAccessibleName(Words::tr("Grey window"));
    for (const Preset& preset : presets)
        presets_->addItem(QString("%1 (L %2, W %3)")
                              .arg(Words::tr(preset.name))
                              .arg(preset.window.level_hu)
                              .arg(preset.window.width_hu));
    presets_->addItem(Words::tr("Own"));
    presets_->setToolTip(
        Words::tr("Which Hounsfield units are grey; right drag on a slice sets your own"));
    connect(presets_, &QComboBox::activated, this, [this](int index) {
        if (index < static_cast<int>(presets.size()))
            scene_.set_window(presets[static_cast<std::size_t>(index)].window);
    });
}

QWidget* SliceBar::opacity_slider() {
    auto* opacity = new QSlider(Qt::Horizontal);
    opacity->setObjectName("vesselOpacity");
    opacity->setAccessibleName(Words::tr("Opacity of the vessels over the CT"));
    opacity->setToolTip(Words::tr("How strongly the vessels' voxels are drawn over the CT"));
    opacity->setRange(0, 100);
    opacity->setValue(static_cast<int>(100.0 * scene_.opacity()));
    opacity->setFixedWidth(80);  // the widgets beside it must not move when the text changes
    connect(opacity, &QSlider::valueChanged, this,
            [this](int value) { scene_.set_opacity(0.01 * value); });
    return opacity;
}

QWidget* SliceBar::centreline_choice() {
    auto* centrelines = new QCheckBox(Words::tr("Centrelines"));
    centrelines->setObjectName("centrelines");
    centrelines->setChecked(scene_.shows_centrelines());
    connect(centrelines, &QCheckBox::toggled, this,
            [this](bool visible) { scene_.set_centrelines_visible(visible); });
    return centrelines;
}

// Check box for the Couinaud segments; usable once they are known.
QWidget* SliceBar::segment_choice() {
    auto* choice = new QCheckBox(Words::tr("Segments"));
    choice->setObjectName("segments");
    choice->setAccessibleName(Words::tr("Couinaud's segments of the liver over the CT"));
    choice->setChecked(false);
    // Without segments a click says why there are none.
    connect(choice, &QCheckBox::clicked, this, [this, choice](bool wanted) {
        const bool known = !scene_.segments().voxels.empty();
        choice->setChecked(wanted && known);
        scene_.set_segments_visible(wanted && known);
        if (wanted && !known) say(translated(scene_.why_no_segments()));
    });
    const auto follow = [this, choice] {
        const bool known = !scene_.segments().voxels.empty();
        choice->setToolTip(
            known ? Words::tr("Couinaud's segments I to VIII, in the colours of the branches "
                              "that supply them (F6)")
                  : translated(scene_.why_no_segments()));
    };
    scene_.on_change(follow);
    follow();
    return choice;
}

// The list of what a click in a slice does.
QWidget* SliceBar::click_choice() {
    click_ = new QComboBox;
    click_->setObjectName("measure");
    click_->setAccessibleName(Words::tr("What a click in a slice does"));
    click_->addItems({Words::tr("Crosshair"), Words::tr("Distance"), Words::tr("Angle"),
                      Words::tr("Diameter"), Words::tr("Draw a vessel"), Words::tr("Correct"),
                      Words::tr("Paint vessels"), Words::tr("Erase vessels"),
                      Words::tr("Paint tumour"), Words::tr("Erase tumour")});
    for (const VascularSystem system : seeded)
        click_->addItem(Words::tr("Seed: %1").arg(translated(title_of(system))));
    click_->setToolTip(Words::tr(
        "Distance: two clicks. Angle: three, its vertex second. Diameter: a click on a vessel, "
        "at whose centreline it is taken, with the stenosis against the vessel beside. "
        "Draw a vessel: clicks along one that is missing, in any slices, from where its blood "
        "comes in; Enter draws it. Delete or Undo takes the last away, Escape all. "
        "Correct: a click on a vessel does what the panel of corrections says. "
        "Paint, erase: a drag leads a ball through the vessels' voxels; Rebuild makes the vessels "
        "anew of them. A tumour changes no vessel: it needs no Rebuild. "
        "Seed: a click says which vessel is which, and Reconstruct begins anew with all of them"));
    connect(click_, &QComboBox::activated, this, [this](int index) { choose_click(index); });
    scene_.measurements().on_change([this] {
        if (scene_.measurements().chosen()) scene_.seeds().take(std::nullopt);  // M takes it, too
        follow_click();
    });
    scene_.pen().on_change([this] { follow_click(); });
    scene_.seeds().on_change([this] { follow_click(); });
    click_->installEventFilter(this);
    return click_;
}

// The list keeps the keyboard when a brush was taken from it; it has no use for + and -.
bool SliceBar::eventFilter(QObject* watched, QEvent* event) {
    if (watched != click_ || event->type() != QEvent::KeyPress || !scene_.brushing())
        return QWidget::eventFilter(watched, event);
    const int key = static_cast<QKeyEvent*>(event)->key();
    if (key != Qt::Key_Plus && key != Qt::Key_Minus) return QWidget::eventFilter(watched, event);
    scene_.brush().resize(key == Qt::Key_Plus ? 1 : -1);
    return true;
}

void SliceBar::choose_click(int index) {
    const bool measures = index > moves_crosshair && index < draws_vessel;
    scene_.set_corrects(index == corrects);
    scene_.pen().set_taken(index == draws_vessel);
    scene_.seeds().take(index < sets_seed ? std::nullopt
                                          : std::optional(seeded.at(index - sets_seed)));
    scene_.brush().set_mode(mode_of(index, paints, erases));
    scene_.tumours().set_mode(mode_of(index, paints_tumour, erases_tumour));
    scene_.measurements().choose(measures ? std::optional(static_cast<MeasurementKind>(index - 1))
                                          : std::nullopt);
    follow_click();
}

int SliceBar::chosen_click() const {
    const auto kind = scene_.measurements().chosen();
    if (const auto& seed = scene_.seeds().taken())
        return sets_seed + static_cast<int>(std::ranges::find(seeded, *seed) - seeded.begin());
    return scene_.pen().taken()                           ? draws_vessel
           : scene_.corrects()                            ? corrects
           : scene_.brush().mode() == BrushMode::paints   ? paints
           : scene_.brush().mode() == BrushMode::erases   ? erases
           : scene_.tumours().mode() == BrushMode::paints ? paints_tumour
           : scene_.tumours().mode() == BrushMode::erases ? erases_tumour
           : kind                                         ? 1 + static_cast<int>(*kind)
                                                          : moves_crosshair;
}

// The next thing to do; empty if a click only moves the crosshair.
QString SliceBar::guidance() const {
    switch (chosen_click()) {
        case 1:
            return Words::tr("Click where the distance begins, then where it ends");
        case 2:
            return Words::tr("Click on one arm, on the vertex, on the other arm");
        case 3:
            return Words::tr("Click on a vessel");
        case draws_vessel:
            break;
        case corrects:
            return Words::tr("A click on a vessel: %1 (panel Corrections); Escape ends it")
                .arg(correction_());
        case paints:
            return Words::tr("Drag over what is vessel (+ and - size the brush), then Rebuild");
        case erases:
            return Words::tr("Drag over what is no vessel (+ and - size the brush), then Rebuild");
        case paints_tumour:
            return Words::tr("Drag over what is tumour (+ and - size the brush)");
        case erases_tumour:
            return Words::tr("Drag over what is no tumour (+ and - size the brush)");
        case moves_crosshair:
            return {};
        default:
            return guidance_of_seeds();
    }
    const std::size_t places = scene_.pen().places_mm().size();
    return places == 0   ? Words::tr("Click where the missing vessel begins, then along it")
           : places == 1 ? Words::tr("Click on along the vessel. Delete or Ctrl+Z: one back")
                         : Words::tr(
                               "Click on, or draw it (Enter). Delete or Ctrl+Z: one back. "
                               "Esc: all");
}

// What is odd about the last one comes first.
QString SliceBar::guidance_of_seeds() const {
    const SeedMarks& marks = scene_.seeds();
    if (!marks.seeds().empty() && !scene_.empty()) {
        const QString doubt =
            doubt_of_seed(marks.seeds().back().position_mm, scene_.ct(), scene_.tumours().organs());
        if (!doubt.isEmpty()) return doubt;
    }
    return Words::tr("Click into the vessel (%1), then Reconstruct. Delete: one back")
        .arg(translated(title_of(*marks.taken())));
}

// The value below the least radius stands for the one that is measured in the CT.
QWidget* SliceBar::vessel_radius() {
    constexpr double step_mm = 0.1, measured_mm = VesselPen::least_mm - step_mm;
    vessel_radius_ = new DecimalSpinBox(measured_mm, VesselPen::most_mm, measured_mm, 1, "mm");
    vessel_radius_->setObjectName("vesselRadius");
    vessel_radius_->setAccessibleName(Words::tr("Radius of the vessel that is drawn"));
    vessel_radius_->setToolTip(
        Words::tr("Radius of the vessel that is drawn; below the least it is measured in the CT"));
    vessel_radius_->setSpecialValueText(Words::tr("measured"));
    vessel_radius_->setSingleStep(step_mm);
    vessel_radius_->setVisible(false);
    connect(vessel_radius_, &QDoubleSpinBox::valueChanged, this, [this](double mm) {
        const bool measured = mm < VesselPen::least_mm;
        scene_.pen().set_radius(measured ? std::nullopt : std::optional(mm));
    });
    return vessel_radius_;
}

QWidget* SliceBar::draw_button() {
    draw_ = new QPushButton(Words::tr("Draw it"));
    draw_->setObjectName("drawVessel");
    draw_->setToolTip(Words::tr("Follows the vessel through the places that were clicked (Enter)"));
    draw_->setVisible(false);
    // After a click, Delete must still reach the slice and remove a place.
    draw_->setFocusPolicy(Qt::TabFocus);
    connect(draw_, &QPushButton::clicked, this, [this] { scene_.pen().finish(); });
    scene_.pen().on_say([this](const std::string& text) { say(QString::fromStdString(text)); });
    return draw_;
}

QWidget* SliceBar::seed_button() {
    reconstruct_ = new QPushButton(Words::tr("Reconstruct…"));
    reconstruct_->setObjectName("reconstructWithSeeds");
    reconstruct_->setToolTip(
        Words::tr("Makes the vessels anew of the CT and tells them apart by the seeds (crosses). "
                  "Corrections are not taken over"));
    reconstruct_->setVisible(false);
    reconstruct_->setFocusPolicy(Qt::TabFocus);
    connect(reconstruct_, &QPushButton::clicked, this, [this] { scene_.seeds().reconstruct(); });
    return reconstruct_;
}

void SliceBar::add_brush(QHBoxLayout& row) {
    radius_ = new DecimalSpinBox(MaskBrush::least_mm, MaskBrush::most_mm,
                                 scene_.brush().radius_mm(), 1, "mm");
    radius_->setObjectName("brushRadius");
    radius_->setAccessibleName(Words::tr("Radius of the brush"));
    radius_->setToolTip(Words::tr("Radius of the ball that is led through the voxels"));
    radius_->setSingleStep(MaskBrush::step_mm);
    remake_ = new QPushButton(Words::tr("Rebuild"));
    remake_->setObjectName("rebuildVessels");
    remake_->setToolTip(Words::tr(
        "Makes the vessels anew of their voxels as they are painted now. Corrections are made "
        "again where they still can be"));
    row.addWidget(tumour_choice());
    row.addWidget(radius_);
    row.addWidget(remake_);
    connect(radius_, &QDoubleSpinBox::valueChanged, this,
            [this](double mm) { scene_.brush().set_radius(mm); });
    connect(remake_, &QPushButton::clicked, this, [this] { scene_.brush().remake(); });
    scene_.brush().on_change([this] { follow_brush(); });
    scene_.tumours().on_change([this] {
        follow_tumours();
        follow_brush();
    });
    follow_tumours();
    follow_brush();
}

void SliceBar::follow_brush() {
    const MaskBrush& brush = scene_.brush();
    radius_->setVisible(scene_.brushing());
    radius_->setValue(brush.radius_mm());
    remake_->setVisible(brush.mode() != BrushMode::away || !brush.strokes().empty());
    remake_->setEnabled(!brush.strokes().empty());
    follow_click();
}

QWidget* SliceBar::tumour_choice() {
    tumour_ = new QComboBox;
    tumour_->setObjectName("tumour");
    tumour_->setAccessibleName(Words::tr("Which tumour is painted or erased"));
    tumour_->setToolTip(Words::tr("Tumours keep their numbers; one that is wholly erased is gone"));
    tumour_->setFocusPolicy(Qt::TabFocus);  // keys pressed afterwards belong to the slice
    connect(tumour_, &QComboBox::activated, this,
            [this](int index) { scene_.tumours().choose(tumour_->itemData(index).toInt()); });
    return tumour_;
}

// Lists the existing tumours after an entry for a new one (painting) or any of them (erasing).
void SliceBar::follow_tumours() {
    const TumourBrush& brush = scene_.tumours();
    tumour_->setVisible(brush.mode() != BrushMode::away);
    tumour_->clear();
    tumour_->addItem(
        brush.mode() == BrushMode::erases ? Words::tr("Any tumour") : Words::tr("New tumour"), 0);
    for (const Tumour& tumour : brush.tumours())
        tumour_->addItem(Words::tr("Tumour %1").arg(tumour.number), tumour.number);
    tumour_->setCurrentIndex(std::max(0, tumour_->findData(brush.chosen())));
}

void SliceBar::follow_click() {
    const VesselPen& pen = scene_.pen();
    const SeedMarks& seeds = scene_.seeds();
    click_->setCurrentIndex(chosen_click());
    if (const QString next = guidance(); !next.isEmpty()) {
        say(next);
        // Whether one is in the vessel is seen by the HU.
        if (seeds.taken())
            show_place(seeds.seeds().empty() ? scene_.crosshair_mm()
                                             : seeds.seeds().back().position_mm);
    } else if (!std::exchange(said_, {}).isEmpty()) {
        show_place(scene_.crosshair_mm());  // removes the former guidance
    }
    vessel_radius_->setVisible(pen.taken());
    draw_->setVisible(pen.taken());
    draw_->setEnabled(pen.places_mm().size() >= 2 && !pen.draws());
    reconstruct_->setVisible(seeds.taken() || seeds.changed());
    reconstruct_->setEnabled(!seeds.seeds().empty() || seeds.changed());
}

void SliceBar::say(const QString& text) {
    said_ = text;
    place_->setText(text);
    place_->setToolTip(text);
}

void SliceBar::show_place(const Vec3& position_mm) {
    const QString there = QString::fromStdString(scene_.describe(position_mm));
    const bool works = chosen_click() != moves_crosshair;
    if (chosen_click() == corrects) said_ = guidance();  // another correction may be chosen by now
    // The position in the first line and what is there in the second, unless a message stands above
    // both.
    place_->setText(works && !said_.isEmpty() ? said_ + "\n" + there
                                              : QString(there).replace("HU   ", "HU\n"));
    if (said_.isEmpty()) place_->setToolTip({});
}

void SliceBar::follow_window() {
    int index = 0;
    while (index < static_cast<int>(presets.size()) &&
           !same(presets[static_cast<std::size_t>(index)].window, scene_.window()))
        ++index;
    presets_->setCurrentIndex(index);
}

}  // namespace hepatica
