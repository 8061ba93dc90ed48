// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/tool_panel.h"

#include <QFormLayout>
#include <QGroupBox>
#include <QLabel>
#include <QVBoxLayout>

#include "render/tool_actor.h"
#include "ui/decimal_spin_box.h"

namespace hepatica {
namespace {

constexpr double thinnest_mm = 0.5, thickest_mm = 20.0;
constexpr double shortest_mm = 2.0, longest_mm = 200.0;

}  // namespace

ToolPanel::ToolPanel(std::function<void(const ToolSize&)> resize, QWidget* parent)
    : QWidget(parent) {
    auto* column = new QVBoxLayout(this);
    column->addWidget(make_size(resize));
    auto* felt = new QGroupBox("What it feels", this);
    auto* lines = new QVBoxLayout(felt);
    force_ = new QLabel(felt);
    force_->setObjectName("toolForce");
    force_->setAccessibleName("Force on the tool");
    lines->addWidget(force_);
    grip_ = new QLabel(felt);
    grip_->setObjectName("toolGrip");
    grip_->setAccessibleName("Force with which the jaws hold");
    lines->addWidget(grip_);
    column->addWidget(felt);
    help_ = new QLabel(this);
    help_->setObjectName("quiet");
    help_->setWordWrap(true);
    column->addWidget(help_);
    column->addStretch(1);
    show_kind({});
    show_tool(std::nullopt);
}

QWidget* ToolPanel::make_size(const std::function<void(const ToolSize&)>& resize) {
    auto* box = new QGroupBox("Size", this);
    auto* form = new QFormLayout(box);
    const ToolSize begin;
    const auto make = [&](const char* label, const char* name, double least, double most,
                          double value) {
        auto* field = new DecimalSpinBox(least, most, value, 1, "mm", box);
        field->setObjectName(name);
        field->setAccessibleName(QString("%1 of the tool").arg(label));
        field->setSingleStep(0.5);
        field->setKeyboardTracking(false);  // a number that is half typed is no size
        form->addRow(label, field);
        connect(field, &QDoubleSpinBox::valueChanged, this, [this, resize] { resize(size()); });
        return field;
    };
    radius_ = make("Radius", "toolRadius", thinnest_mm, thickest_mm, begin.radius_mm);
    length_ = make("Length", "toolLength", shortest_mm, longest_mm, begin.length_mm);
    return box;
}

ToolSize ToolPanel::size() const {
    return {radius_->value(), length_->value()};
}

void ToolPanel::show_kind(const std::string& kind) {
    length_->setEnabled(kind != "sphere");
    help_->setText(kind.empty()
                       ? "Take a tool from the bar above the view."
                       : "The mouse leads its tip, the wheel moves it in depth (Ctrl + wheel "
                         "zooms), T and Shift + T turn it, C closes and opens forceps. Esc puts it "
                         "away.");
}

void ToolPanel::show_tool(const std::optional<ToolView>& tool) {
    const std::string force = tool ? force_text(tool->force_un.norm()) : std::string();
    const std::string grip = tool ? force_text(tool->grip_un) : std::string();
    grip_->setText(grip.empty() ? QString() : "Grip " + QString::fromStdString(grip));
    force_->setText(!tool           ? QString("no tool")
                    : force.empty() ? QString("touches nothing")
                                    : "Force " + QString::fromStdString(force));
}

}  // namespace hepatica
