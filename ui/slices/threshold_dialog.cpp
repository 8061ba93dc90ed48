// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/slices/threshold_dialog.h"

#include <QFormLayout>
#include <QHBoxLayout>
#include <QHideEvent>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QSignalBlocker>
#include <QSlider>
#include <QSpinBox>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "ui/core_words.h"
#include "ui/words.h"

namespace hepatica {

namespace {

constexpr int progress_steps = 1000;

double millilitres(const Mask& vessels) {
    const auto count =
        std::ranges::count_if(vessels.voxels, [](std::uint8_t voxel) { return voxel != 0; });
    return static_cast<double>(count) * vessels.grid.spacing_mm.prod() / 1000.0;
}

}  // namespace

ThresholdDialog::ThresholdDialog(SliceScene& scene, Ways ways, QWidget* parent)
    : QDialog(parent), scene_(scene), ways_(std::move(ways)) {
    setWindowTitle(Words::tr("More or fewer vessels"));
    build();
    scene_.on_change([this] { follow_scene(); });
}

ThresholdDialog::~ThresholdDialog() = default;

void ThresholdDialog::build() {
    auto* column = new QVBoxLayout(this);
    auto* form = new QFormLayout;
    auto* row = new QHBoxLayout;
    share_ = new QSlider(Qt::Horizontal);
    share_->setObjectName("lineShare");
    share_->setAccessibleName(Words::tr("Threshold from which a line is believed to be a vessel"));
    share_->setRange(static_cast<int>(std::lround(100 * least_line_share)),
                     static_cast<int>(std::lround(100 * most_line_share)));
    share_->setMinimumWidth(220);
    share_->setToolTip(
        Words::tr("To the left more and fainter vessels come in, and more of what is none; to the "
                  "right the faintest go"));
    share_text_ = new QLabel;
    share_text_->setMinimumWidth(
        share_text_->fontMetrics().horizontalAdvance(Words::tr("%1 % of the usual").arg(200)));
    row->addWidget(share_, 1);
    row->addWidget(share_text_);
    form->addRow(Words::tr("Threshold"), row);
    refinement_ = new QSpinBox;
    refinement_->setObjectName("refinement");
    refinement_->setRange(0, most_recursions);
    refinement_->setToolTip(Words::tr("How often the surface is smoothed on top of what was done"));
    form->addRow(Words::tr("Smoothing"), refinement_);
    column->addLayout(form);
    state_ = new QLabel;
    state_->setObjectName("thresholdState");
    state_->setWordWrap(true);
    state_->setTextFormat(Qt::PlainText);
    column->addWidget(state_);
    progress_ = new QProgressBar;
    progress_->setRange(0, progress_steps);
    progress_->setTextVisible(false);
    column->addWidget(progress_);
    auto* buttons = new QHBoxLayout;
    usual_ = new QPushButton(Words::tr("The &usual"));
    remake_ = new QPushButton(Words::tr("&Rebuild"));
    remake_->setObjectName("rebuildByThreshold");
    remake_->setToolTip(
        Words::tr("The vessels are made anew of what the slices show; an undo takes it back"));
    auto* close = new QPushButton(Words::tr("&Close"));
    buttons->addStretch();
    for (QPushButton* button : {usual_, remake_, close}) {
        button->setAutoDefault(false);
        buttons->addWidget(button);
    }
    column->addLayout(buttons);
    const auto chosen = [this] {
        moved_ = true;
        preview();
    };
    connect(share_, &QSlider::valueChanged, this, chosen);
    connect(refinement_, &QSpinBox::valueChanged, this, chosen);
    connect(usual_, &QPushButton::clicked, this, [this] { stand_at({}); });
    connect(remake_, &QPushButton::clicked, this, [this] {
        moved_ = false;
        history_.rebuild(choice(), scene_.vessels());
        ways_.remake(ct_, scene_.vessels());
    });
    connect(close, &QPushButton::clicked, this, &QDialog::hide);
    stand_at({});
}

ThresholdChoice ThresholdDialog::choice() const {
    return {share_->value() / 100.0, refinement_->value()};
}

void ThresholdDialog::showEvent(QShowEvent* event) {
    QDialog::showEvent(event);
    follow_scene();
}

void ThresholdDialog::hideEvent(QHideEvent* event) {
    QDialog::hideEvent(event);
    if (event->spontaneous()) return;  // a minimised window will come back
    ct_.reset();
    forget();
}

void ThresholdDialog::forget() {
    job_.reset();
    progress_->hide();
    lines_.reset();
    previewing_ = false;
    scene_.set_preview({});
    stand_at(history_.empty() ? ThresholdChoice() : history_.choice());
}

// Measured lines belong to one CT, and a preview to the present vessels, which may be changed
// elsewhere.
void ThresholdDialog::follow_scene() {
    if (!isVisible()) return;
    if (scene_.empty()) {
        if (std::exchange(ct_, nullptr)) forget();
        return state_->setText(Words::tr("Waiting for the CT"));
    }
    if (ct_ != scene_.shared_ct()) return measure();
    const bool dropped = previewing_ && scene_.preview().voxels.empty();
    if (dropped) previewing_ = false;
    // An unfinished stroke does not count yet.
    const bool others = scene_.systems_version() != vessels_seen_ && !scene_.brush().leads();
    if (!dropped && !others) return;
    const bool by_hand = follow_vessels();
    // Who moves the slider while vessels are rebuilt goes on from there.
    const bool keeps = by_hand ? !dropped : others && moved_;
    keeps ? preview() : stand_at(history_.choice());
}

bool ThresholdDialog::follow_vessels() {
    if (vessels_seen_ == scene_.systems_version()) return true;
    vessels_seen_ = scene_.systems_version();
    return history_.follow(scene_.systems());
}

void ThresholdDialog::measure() {
    // Chosen while the CT was read.
    const auto chosen = ct_ == nullptr && moved_ ? std::optional(choice()) : std::nullopt;
    ct_ = scene_.shared_ct();
    if (history_ct_.lock() != ct_) history_.forget();
    history_ct_ = ct_;
    follow_vessels();
    forget();
    if (chosen) put(*chosen);
    moved_ = chosen.has_value();
    if (scene_.systems().voxels.empty()) {
        state_->setText(Words::tr("This case knows no voxels of its vessels"));
        return;
    }
    state_->setText(Words::tr("The lines of the CT are being measured…"));
    start(
        [this, ct = ct_, read_organs = ways_.organs()](Job& job) -> std::function<void()> {
            job.expect_stages(1 + preview_stages);
            job.begin_stage(Words::id("Reading the voxels"));
            auto lines = std::make_shared<const VesselPreview>(*ct, read_organs(), job);
            return [this, lines] {
                lines_ = lines;
                stale_ = true;
            };
        },
        true);
}

void ThresholdDialog::preview() {
    share_text_->setText(Words::tr("%1 % of the usual").arg(share_->value()));
    stale_ = true;
    if (!lines_ || job_) return;
    stale_ = false;
    follow_vessels();
    start(
        [this, lines = lines_, choice = choice(),
         usual = history_.usual()](Job& job) -> std::function<void()> {
            auto vessels =
                std::make_shared<Mask>(lines->vessels(*usual, choice, painted_label, job));
            return [this, usual, vessels] {
                // The vessels may have changed meanwhile.
                follow_vessels();
                if (usual == history_.usual())
                    show_found(std::move(*vessels));
                else
                    stale_ = true;
            };
        },
        false);
}

void ThresholdDialog::show_found(Mask vessels) {
    const bool same = !changes_vessels() || vessels.voxels == scene_.systems().voxels;
    tell_volumes(same ? scene_.systems() : vessels);
    scene_.set_preview(same ? Mask() : std::move(vessels));
    previewing_ = !same;
    remake_->setEnabled(previewing_);
}

void ThresholdDialog::tell_volumes(const Mask& shown) {
    const double now_ml = millilitres(scene_.systems()), shown_ml = millilitres(shown);
    const QString now =
        Words::tr("The case holds %L1 mL of vessels, by %2 % of the usual threshold.")
            .arg(now_ml, 0, 'f', 1)
            .arg(std::lround(100.0 * history_.choice().line_share));
    state_->setText(&shown == &scene_.systems()
                        ? now
                        : now + "\n" +
                              Words::tr("The slices show %L1 mL of vessels (%2%L3 mL).")
                                  .arg(shown_ml, 0, 'f', 1)
                                  .arg(shown_ml < now_ml ? QChar(0x2212) : QChar('+'))
                                  .arg(std::abs(shown_ml - now_ml), 0, 'f', 1));
}

void ThresholdDialog::stand_at(const ThresholdChoice& choice) {
    moved_ = false;
    put(choice);
}

void ThresholdDialog::put(const ThresholdChoice& choice) {
    const QSignalBlocker no_share(share_), no_refinement(refinement_);
    share_->setValue(static_cast<int>(std::lround(100.0 * choice.line_share)));
    refinement_->setValue(choice.refinement_recursions);
    remake_->setEnabled(false);
    preview();
}

// One job at a time; a choice made meanwhile is computed afterwards.
void ThresholdDialog::start(BackgroundJob::Work work, bool with_progress) {
    BackgroundJob::Callbacks callbacks;
    progress_->setVisible(with_progress);
    callbacks.progress = [this](const JobProgress& now) {
        if (now.stage_count > 0)
            progress_->setValue(static_cast<int>(
                progress_steps * (now.stage_number - 1 + now.fraction) / now.stage_count));
    };
    callbacks.failed = [this](const Failure& failure) {
        state_->setText(translated(failure.problem));
        ways_.failed(failure);
    };
    callbacks.ended = [this] {
        progress_->hide();
        job_.reset();
        if (stale_ && lines_) preview();
    };
    job_ = std::make_unique<BackgroundJob>(std::move(work), std::move(callbacks));
}

}  // namespace hepatica
