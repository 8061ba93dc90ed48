// SPDX-License-Identifier: GPL-3.0-or-later
// Asks where a case is to be saved. A case is a folder, which a file dialog would enter instead of
// replacing it; here it stands for itself, and an old one is replaced after a question. What is
// there and is no case is never replaced.
#pragma once

#include <QFileDialog>
#include <filesystem>
#include <functional>

namespace hepatica {

// The place that a case of this name gets: the folder NAME.hep, whether ".hep" was typed or not, or
// the one file NAME.hepz where that was typed.
std::filesystem::path case_folder(const QString& typed);

class SaveCaseDialog : public QFileDialog {
  public:
    // `may_replace` is asked with the name of a case that is there already.
    SaveCaseDialog(const QString& folder, const QString& name,
                   std::function<bool(const QString&)> may_replace, QWidget* parent = nullptr);

    std::filesystem::path chosen() const;
    void accept() override;

  private:
    std::function<bool(const QString&)> may_replace_;
};

}  // namespace hepatica
