// SPDX-License-Identifier: GPL-3.0-or-later
// Panel of corrections: the tool for the next click, gaps that might be bridged or were and
// branches that may be vessels, and the corrections made so far.
#pragma once

#include <QStringList>
#include <QWidget>
#include <functional>

#include "core/tree/editing/tree_edit.h"

class QComboBox;
class QLabel;
class QListWidget;
class QPushButton;
class QVBoxLayout;

namespace hepatica {

// UI thread only.
class EditPanel : public QWidget {
  public:
    struct Callbacks {
        // Of a row in the list of gaps, in which those that are built come first.
        std::function<void(int)> choose_bridge;  // highlights it in the view; -1: none
        std::function<void(int)> accept_bridge;  // an offered one
        std::function<void(int)> refuse_bridge;
        std::function<void()> accept_all;              // all offered ones that are listed
        std::function<void(double)> least_confidence;  // 0 to 1; gaps of less confidence are hidden
        std::function<void()> undo;
        std::function<void()> redo;
        std::function<void()> tool_changed;
        std::function<void()> take_chosen;  // the tool on the branch chosen in the table
    };

    explicit EditPanel(QWidget* parent = nullptr);
    void set_callbacks(Callbacks callbacks) { callbacks_ = std::move(callbacks); }

    TreeEditKind tool() const;
    QString tool_name() const;
    VascularSystem system() const;  // for reassign_system and seed_system

    // Lists of gaps, those that the reconstruction built before those that are offered, and of
    // corrections, oldest first; and a text below them.
    // `hidden`: how many gaps are not offered because they have less confidence than is asked for.
    // The chosen row stays chosen where it still says the same; after a decision the next one is.
    void show_bridges(const QStringList& offered, const QStringList& built = {},
                      std::size_t hidden = 0);
    // -1: none is chosen.
    int chosen_bridge() const;
    void choose_bridge(int row);
    void show_edits(const QStringList& lines);
    void show_history(bool can_undo, bool can_redo);
    void show_state(const QString& text);

  private:
    QWidget* make_tools();
    QWidget* make_bridges();
    void add_confidence_slider(QVBoxLayout& column);
    void add_decisions(QVBoxLayout& column);
    void chosen_bridge_changed();
    void accept_chosen();
    void refuse_chosen();
    QWidget* make_edits();

    Callbacks callbacks_;
    QComboBox* tool_ = nullptr;
    QComboBox* system_ = nullptr;
    QListWidget* bridges_ = nullptr;
    int built_ = 0;         // rows of bridges_ before those that can be accepted
    bool decided_ = false;  // on the chosen row, since the list was filled
    QPushButton* accept_ = nullptr;
    QPushButton* refuse_ = nullptr;
    QPushButton* accept_all_ = nullptr;
    QListWidget* edits_ = nullptr;
    QPushButton* undo_ = nullptr;
    QPushButton* redo_ = nullptr;
    QLabel* state_ = nullptr;
};

}  // namespace hepatica
