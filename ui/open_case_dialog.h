// SPDX-License-Identifier: GPL-3.0-or-later
// File dialog for a case: a folder NAME.hep, which other file dialogs would enter instead of
// choosing it, or a file NAME.hepz. Tells why anything else cannot be opened.
#pragma once

#include <QFileDialog>
#include <filesystem>
#include <functional>

namespace hepatica {

// UI thread only.
class OpenCaseDialog : public QFileDialog {
  public:
    // `refuse` receives the reason why a choice cannot be opened.
    OpenCaseDialog(const QString& folder, std::function<void(const QString&)> refuse,
                   QWidget* parent = nullptr);

    const std::filesystem::path& chosen() const { return chosen_; }  // after it was accepted
    void accept() override;

  private:
    std::function<void(const QString&)> refuse_;
    std::filesystem::path chosen_;
};

}  // namespace hepatica
