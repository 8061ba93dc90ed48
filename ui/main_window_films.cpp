// SPDX-License-Identifier: GPL-3.0-or-later
// The part of the window that saves a review as pictures, for whoever wants no film in one file.
#include "ui/main_window.h"
#include "ui/paths.h"
#include "ui/save_file_dialog.h"
#include "ui/words.h"

namespace hepatica {

void MainWindow::ask_and_save_pictures(double end_s, const std::function<void(double)>& go_to) {
    const QString place = ask_where_to_save_folder(
        *this, Words::tr("Save a film as a folder of pictures"), settings_.last_folder() + "/film");
    if (place.isEmpty()) return say_no_film();
    attempt(Words::tr("Save a film"), [&] {
        require_folder_of(place);
        save_film(to_path(place), end_s, go_to);
    });
}

}  // namespace hepatica
