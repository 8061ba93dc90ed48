// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/slices/slice_bar.h"

#include <QCheckBox>
#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QSlider>
#include <array>

namespace hepatica {
namespace {

struct Preset {
    const char* name;
    GreyWindow window;
};

constexpr std::array presets{
    Preset{"Vessels", {100.0, 300.0}}, Preset{"Liver", {100.0, 150.0}},
    Preset{"Abdomen", {40.0, 400.0}},  Preset{"Lung", {-600.0, 1500.0}},
    Preset{"Bone", {400.0, 1800.0}},
};

constexpr int draws_vessel = 4;  // among what a click is for; before it stand the measurements

bool same(const GreyWindow& a, const GreyWindow& b) {
    return a.level_hu == b.level_hu && a.width_hu == b.width_hu;
}

}  // namespace

SliceBar::SliceBar(SliceScene& scene, QWidget* parent)
    : QWidget(parent), scene_(scene), presets_(new QComboBox), place_(new QLabel) {
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(8, 4, 8, 4);
    presets_->setObjectName("greyWindow");
    presets_->setAccessibleName("Grey window");
    for (const Preset& preset : presets)
        presets_->addItem(QString("%1 (L %2, W %3)")
                              .arg(preset.name)
                              .arg(preset.window.level_hu)
                              .arg(preset.window.width_hu));
    presets_->addItem("Own");
    presets_->setToolTip("Which Hounsfield units are grey; right drag on a slice sets your own");
    auto* opacity = new QSlider(Qt::Horizontal);
    opacity->setObjectName("vesselOpacity");
    opacity->setAccessibleName("Opacity of the vessels over the CT");
    opacity->setToolTip("How strongly the vessels' voxels are drawn over the CT");
    opacity->setRange(0, 100);
    opacity->setValue(static_cast<int>(100.0 * scene_.opacity()));
    opacity->setFixedWidth(80);  // what stands beside it keeps its place while the text changes
    auto* centrelines = new QCheckBox("Centrelines");
    centrelines->setObjectName("centrelines");
    centrelines->setChecked(scene_.shows_centrelines());
    place_->setObjectName("slicePlace");
    // Two lines, whatever is said: it neither widens the window nor moves the slices.
    place_->setWordWrap(true);
    place_->setMinimumWidth(place_->fontMetrics().averageCharWidth() * 16);
    place_->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    place_->setFixedHeight(2 * place_->fontMetrics().lineSpacing() + 2);
    row->addWidget(presets_);
    row->addWidget(new QLabel("Vessels"));
    row->addWidget(opacity);
    row->addWidget(centrelines);
    row->addWidget(segment_choice());
    row->addWidget(click_choice());
    row->addWidget(draw_button());
    row->addWidget(place_, 1);
    connect(presets_, &QComboBox::activated, this, [this](int index) {
        if (index < static_cast<int>(presets.size()))
            scene_.set_window(presets[static_cast<std::size_t>(index)].window);
    });
    connect(opacity, &QSlider::valueChanged, this,
            [this](int value) { scene_.set_opacity(0.01 * value); });
    connect(centrelines, &QCheckBox::toggled, this,
            [this](bool visible) { scene_.set_centrelines_visible(visible); });
    scene_.on_change([this] {
        follow_window();
        show_place(scene_.crosshair_mm());
    });
    follow_window();
}

// Couinaud's segments, where they are known.
QWidget* SliceBar::segment_choice() {
    auto* choice = new QCheckBox(tr("Segments"));
    choice->setObjectName("segments");
    choice->setAccessibleName(tr("Couinaud's segments of the liver over the CT"));
    choice->setChecked(false);
    connect(choice, &QCheckBox::toggled, this,
            [this](bool visible) { scene_.set_segments_visible(visible); });
    const auto follow = [this, choice] {
        const bool known = !scene_.segments().voxels.empty();
        choice->setEnabled(known);
        choice->setToolTip(known ? tr("Couinaud's segments 1 to 8, in the colours of the branches "
                                      "that supply them (F6)")
                                 : QString::fromStdString(scene_.why_no_segments()));
    };
    scene_.on_change(follow);
    follow();
    return choice;
}

// What a click in a slice is for.
QWidget* SliceBar::click_choice() {
    click_ = new QComboBox;
    click_->setObjectName("measure");
    click_->setAccessibleName("What a click in a slice does");
    click_->addItems({"Crosshair", "Distance", "Angle", "Diameter", "Draw a vessel"});
    click_->setToolTip(
        "Distance: two clicks. Angle: three, its vertex second. Diameter: a click on a vessel, "
        "at whose centreline it is taken, with the stenosis against the vessel beside. "
        "Draw a vessel: clicks along one that is missing, in any slices, from where its blood "
        "comes in; Enter draws it. Delete takes the last away, Escape ends it");
    connect(click_, &QComboBox::activated, this, [this](int index) {
        const bool measures = index > 0 && index < draws_vessel;
        scene_.pen().set_taken(index == draws_vessel);
        scene_.measurements().choose(
            measures ? std::optional(static_cast<MeasurementKind>(index - 1)) : std::nullopt);
        if (index == draws_vessel)
            say("Click where the vessel begins, then along it; Enter draws it");
    });
    scene_.measurements().on_change([this] { follow_click(); });
    scene_.pen().on_change([this] { follow_click(); });
    return click_;
}

QWidget* SliceBar::draw_button() {
    draw_ = new QPushButton("Draw it");
    draw_->setObjectName("drawVessel");
    draw_->setToolTip("Follows the vessel through the places that were clicked (Enter)");
    draw_->setVisible(false);
    draw_->setFocusPolicy(Qt::TabFocus);  // after a click Delete still takes back a place
    connect(draw_, &QPushButton::clicked, this, [this] { scene_.pen().finish(); });
    scene_.pen().on_say([this](const std::string& text) { say(QString::fromStdString(text)); });
    return draw_;
}

void SliceBar::follow_click() {
    const VesselPen& pen = scene_.pen();
    const auto kind = scene_.measurements().chosen();
    click_->setCurrentIndex(pen.taken() ? draws_vessel : kind ? 1 + static_cast<int>(*kind) : 0);
    draw_->setVisible(pen.taken());
    draw_->setEnabled(pen.places_mm().size() >= 2 && !pen.draws());
}

void SliceBar::say(const QString& text) {
    place_->setText(text);
    place_->setToolTip(text);
}

void SliceBar::show_place(const Vec3& position_mm) {
    // The place in the first line, what is there in the second.
    place_->setText(QString::fromStdString(scene_.describe(position_mm)).replace("HU   ", "HU\n"));
}

void SliceBar::follow_window() {
    int index = 0;
    while (index < static_cast<int>(presets.size()) &&
           !same(presets[static_cast<std::size_t>(index)].window, scene_.window()))
        ++index;
    presets_->setCurrentIndex(index);
}

}  // namespace hepatica
