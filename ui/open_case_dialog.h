// SPDX-License-Identifier: GPL-3.0-or-later
// Asks which case is to be opened: a folder NAME.hep, which a file dialog would enter instead of
// opening it, or the one file NAME.hepz. What is neither gets a word why not.
#pragma once

#include <QFileDialog>
#include <filesystem>
#include <functional>

namespace hepatica {

class OpenCaseDialog : public QFileDialog {
  public:
    // `refuse` is told why what was chosen cannot be opened.
    OpenCaseDialog(const QString& folder, std::function<void(const QString&)> refuse,
                   QWidget* parent = nullptr);

    const std::filesystem::path& chosen() const { return chosen_; }  // once it is accepted
    void accept() override;

  private:
    std::function<void(const QString&)> refuse_;
    std::filesystem::path chosen_;
};

}  // namespace hepatica
