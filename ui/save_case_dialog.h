// SPDX-License-Identifier: GPL-3.0-or-later
// File dialog for saving a case. A case is a folder, which other file dialogs would enter; here it
// is chosen, and an existing case is replaced after a question. Anything that is no case is never
// replaced.
#pragma once

#include <QFileDialog>
#include <filesystem>
#include <functional>

namespace hepatica {

// The place of a case of this name: the folder NAME.hep, with ".hep" added if missing, or the file
// NAME.hepz if that was typed.
std::filesystem::path case_folder(const QString& typed);

// UI thread only.
class SaveCaseDialog : public QFileDialog {
  public:
    // `may_replace` is asked with the name of an existing case; `refuse` receives the reason why a
    // place cannot be taken.
    SaveCaseDialog(const QString& folder, const QString& name,
                   std::function<bool(const QString&)> may_replace,
                   std::function<void(const QString&)> refuse, QWidget* parent = nullptr);

    std::filesystem::path chosen() const;
    void accept() override;

  private:
    std::function<bool(const QString&)> may_replace_;
    std::function<void(const QString&)> refuse_;
};

}  // namespace hepatica
