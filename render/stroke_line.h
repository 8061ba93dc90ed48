// SPDX-License-Identifier: GPL-3.0-or-later
// The stroke that is drawn on the vessels with a blade or as a cut line: a straight line over the
// picture with a dark rim, which is seen before vessels of any colour and on any background. Line
// and rim share no pixel, because which of two rectangles of the two-dimensional layer is seen
// depends on the driver.
#pragma once

#include <vtkSmartPointer.h>

#include <array>
#include <functional>
#include <optional>

#include "core/base/vector.h"
#include "render/palette.h"

class vtkCellArray;
class vtkPoints;
class vtkPolyData;
class vtkRenderer;
class vtkActor2D;
class vtkUnsignedCharArray;

namespace hepatica {

// Draws into the two-dimensional layer of one renderer, which must outlive it; not thread-safe.
class StrokeLine {
  public:
    explicit StrokeLine(vtkRenderer& renderer);

    // From one point to the other; nullopt draws nothing.
    void show(const std::optional<std::array<Vec3, 2>>& ends_mm) { ends_mm_ = ends_mm; }

    // Projects a point of the patient to device pixels, y upwards; nothing for a point behind the
    // eye.
    using Place = std::function<std::optional<std::array<double, 2>>(const Vec3& position_mm)>;
    // Places the line for the next picture; call before each. `point`: size of one screen point in
    // device pixels.
    void update(const Place& place, double point);

  private:
    // A rectangle about the line from `from` to `to`, on its side from `low` to `high` (negative:
    // right of it).
    void add_band(const std::array<double, 2>& from, const std::array<double, 2>& to, double low,
                  double high, const Colour& colour);

    std::optional<std::array<Vec3, 2>> ends_mm_;
    vtkSmartPointer<vtkPoints> points_;
    vtkSmartPointer<vtkCellArray> quads_;
    vtkSmartPointer<vtkUnsignedCharArray> colours_;
    vtkSmartPointer<vtkPolyData> polydata_;
    vtkSmartPointer<vtkActor2D> actor_;
};

}  // namespace hepatica
