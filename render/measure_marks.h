// SPDX-License-Identifier: GPL-3.0-or-later
// Measurements drawn over the picture: a line through the measured points, visible through vessels
// and between rims that set it off from them, and the value beside the last point, where there is
// room for it.
#pragma once

#include <vtkSmartPointer.h>

#include <array>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "core/base/vector.h"
#include "render/label_places.h"
#include "render/legend_rows.h"
#include "render/palette.h"

class vtkActor2D;
class vtkCellArray;
class vtkPoints;
class vtkPolyData;
class vtkRenderer;
class vtkTextActor;
class vtkUnsignedCharArray;

namespace hepatica {

struct MeasureView {
    std::vector<Vec3> points_mm;
    std::string text;  // empty: no text
    bool operator==(const MeasureView&) const = default;
};

// Draws into the two-dimensional layer of one renderer, which must outlive it; not thread-safe.
class MeasureMarks {
  public:
    explicit MeasureMarks(vtkRenderer& renderer);

    // Colours of lines and letters, and of the background behind the letters, which rims have, too.
    void set_colours(const Colour& lines, const Colour& ground);
    // Returns true if the picture changed.
    bool show(std::vector<MeasureView> measures);
    const std::vector<MeasureView>& shown() const { return measures_; }

    // Projects a point of the patient to device pixels, y upwards; nothing for a point behind the
    // eye.
    using Place = std::function<std::optional<std::array<double, 2>>(const Vec3& position_mm)>;
    // Places the lines for the next picture; call before each. Measurements with a point behind the
    // eye are left out. `point`: size of one screen point in device pixels. Labels keep clear of
    // what covers the picture at its top and bottom, in pixels, and of the legend; an empty box:
    // there is none.
    void update(const Place& place, double point, double covered_top = 0.0,
                double covered_bottom = 0.0, const PictureBox& legend = {});
    // Of the labels as they were placed last: left, bottom, right and top in pixels. Without those
    // that have no room.
    const std::vector<PictureBox>& labels() const { return labels_; }

  private:
    // `whole`: with squares at its points, and rims between them.
    void add_line(const std::vector<std::array<double, 2>>& line, double width, bool whole = true);
    // The rectangle along the line from `from` to `to`, on its side from `low` to `high` (negative:
    // right of it).
    void add_band(const std::array<double, 2>& from, const std::array<double, 2>& to, double low,
                  double high, const Colour& colour);
    vtkTextActor& next_text(std::size_t used);
    // Places the labels within `room`, none on another or on the legend; one that evades another
    // has a thin line to where it belongs. Letters shrink where the room is narrow, and a label
    // without room is hidden.
    void place_labels(const std::vector<std::array<double, 2>>& belongs, const LabelBox& room,
                      const PictureBox& legend, double point);
    // Returns width and height of the text in pixels.
    std::array<double, 2> fit(vtkTextActor& text, double widest, double point);

    vtkRenderer& renderer_;
    std::vector<PictureBox> labels_;
    std::vector<MeasureView> measures_;
    vtkSmartPointer<vtkPoints> points_;
    vtkSmartPointer<vtkCellArray> quads_;
    vtkSmartPointer<vtkUnsignedCharArray> colours_;
    Colour lines_colour_ = palette::measure, ground_colour_{};
    vtkSmartPointer<vtkPolyData> polydata_;
    vtkSmartPointer<vtkActor2D> actor_;
    std::vector<vtkSmartPointer<vtkTextActor>> texts_;
};

}  // namespace hepatica
