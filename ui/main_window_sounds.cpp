// SPDX-License-Identifier: GPL-3.0-or-later
// The part of the main window that sounds the tones of a play (play_sounds.h).
#include <QAction>
#include <QStatusBar>

#include "ui/actions.h"
#include "ui/lesson_dock.h"
#include "ui/loudspeaker.h"
#include "ui/main_window.h"
#include "ui/play_sounds.h"
#include "ui/review_dock.h"
#include "ui/settings.h"
#include "ui/words.h"

namespace hepatica {

void MainWindow::connect_sounds() {
    sounds_ = std::make_unique<PlaySounds>(
        [loudspeaker = std::make_shared<Loudspeaker>()](Tone tone) { loudspeaker->play(tone); });
    QAction& sounds = (*actions_)[ActionId::sounds];
    sounds.setChecked(settings_.sounds());
    sounds_->set_on(sounds.isChecked());
    actions_->on(ActionId::sounds, [this, &sounds] {
        sounds_->set_on(sounds.isChecked());
        settings_.set_sounds(sounds.isChecked());
        if (sounds.isChecked() && !Loudspeaker::there())
            statusBar()->showMessage(
                Words::tr("This computer has no device for sound now: nothing will be heard"),
                6000);
    });
}

// A review is looked at, not played.
void MainWindow::sound(const Frame& frame) {
    if (!sounds_->on() || review_->reviewing()) return;
    if (!lessons_->shows_play()) return sounds_->follow(frame, nullptr);
    const LessonStanding standing = lessons_->standing();
    sounds_->follow(frame, &standing);
}

}  // namespace hepatica
