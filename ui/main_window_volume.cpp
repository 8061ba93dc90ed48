// SPDX-License-Identifier: GPL-3.0-or-later
// The part of the window for the CT as a volume: menu entry, bar, and where the CT comes from.
#include <utility>

#include "ui/core_words.h"
#include "ui/main_window.h"
#include "ui/message_bar.h"
#include "ui/message_log.h"
#include "ui/questions.h"
#include "ui/slices/view_layout.h"
#include "ui/volume_bar.h"
#include "ui/volume_keeper.h"
#include "ui/vtk_widget.h"
#include "ui/window_words.h"
#include "ui/words.h"

namespace hepatica {

void MainWindow::build_volume(QWidget* parent) {
    volume_look_ = settings_.volume_look();
    volume_bar_ = new VolumeBar(volume_look_,
                                {[this](VolumePreset preset, double density) {
                                     volume_look_.preset = preset;
                                     volume_look_.density = density;
                                     settings_.set_volume_look(volume_look_);
                                     show_volume_look();
                                 },
                                 [this] { (*actions_)[ActionId::toggle_volume].trigger(); }},
                                parent);
    volume_bar_->hide();
}

void MainWindow::connect_volume() {
    VolumeKeeper::Screen screen;
    screen.show = [this](std::shared_ptr<const Volume> ct) {
        volume_bar_->show_read(ct != nullptr);
        show_volume_bar();
        view_->scene().set_volume(std::move(ct));
        view_->draw_again();
    };
    screen.of_slices = [this] { return view_layout_->slices().shared_ct(); };
    screen.progress = [this](const JobProgress& now) {
        if (!now.stage.empty()) volume_bar_->show_reading(translated(now.stage) + "…");
    };
    screen.failed = [this](const Failure& failure) {
        volume_bar_->show_read(false);
        say_why_no_volume(failure);
    };
    volume_ =
        std::make_unique<VolumeKeeper>(settings_, view_layout_->ct_readings(), std::move(screen));
    SliceScene& slices = view_layout_->slices();
    volume_look_.window = slices.window();
    slices.on_change([this, &slices] {
        const GreyWindow& now = slices.window();
        GreyWindow& shown = volume_look_.window;
        if (now.level_hu == shown.level_hu && now.width_hu == shown.width_hu) return;
        shown = now;
        show_volume_look();
    });
    view_->scene().set_volume_look(volume_look_);
    QAction& action = (*actions_)[ActionId::toggle_volume];
    action.setChecked(settings_.volume_shown());
    volume_->set_wanted(action.isChecked());
    actions_->on(ActionId::toggle_volume, [this, &action] {
        settings_.set_volume_shown(action.isChecked());
        volume_->set_wanted(action.isChecked());
        show_volume_bar();
        show_reading_of_volume();
    });
}

// At once: the first word of a reading may come after seconds.
void MainWindow::show_reading_of_volume() {
    if (volume_->making()) volume_bar_->show_reading(Words::tr("Reading the CT…"));
}

// Shown as soon as the CT is wanted, so that the pictures do not move when it has been read.
void MainWindow::show_volume_bar() {
    volume_bar_->setVisible(volume_->wanted() && patient_);
}

void MainWindow::show_volume_look() {
    if (view_->scene().set_volume_look(volume_look_)) view_->draw_again();
}

void MainWindow::say_why_no_volume(const Failure& failure) {
    log_->add_failure(Words::tr("CT as volume"), failure);
    messages_->show_notice(in_one_sentence(failure), Words::tr("Choose the CT…"), [this] {
        const auto place = ask_where_ct_lies(*this, settings_);
        if (!place) return;
        volume_->read_from(*place);
        show_reading_of_volume();
    });
}

}  // namespace hepatica
