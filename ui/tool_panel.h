// SPDX-License-Identifier: GPL-3.0-or-later
// The size of the tool in the hand, and what it feels.
#pragma once

#include <QWidget>
#include <functional>

#include "ui/tool_hand.h"

class QLabel;

namespace hepatica {

class DecimalSpinBox;

class ToolPanel : public QWidget {
  public:
    explicit ToolPanel(std::function<void(const ToolSize&)> resize, QWidget* parent = nullptr);

    ToolSize size() const;
    // Empty where no tool is in the hand.
    void show_kind(const std::string& kind);
    void show_tool(const std::optional<ToolView>& tool);

  private:
    QWidget* make_size(const std::function<void(const ToolSize&)>& resize);

    DecimalSpinBox* radius_ = nullptr;
    DecimalSpinBox* length_ = nullptr;
    QLabel* force_ = nullptr;
    QLabel* grip_ = nullptr;
    QLabel* help_ = nullptr;
};

}  // namespace hepatica
