// SPDX-License-Identifier: GPL-3.0-or-later
// Draws the legend (legend_rows.h) in a corner of the picture that holds no vessels, with letters
// of at least 12 points of print, which are 16 of the screen's.
#pragma once

#include <vtkSmartPointer.h>

#include <functional>
#include <vector>

#include "render/legend_rows.h"
#include "render/view_look.h"

class vtkActor2D;
class vtkCellArray;
class vtkPoints;
class vtkPolyData;
class vtkRenderer;
class vtkTextActor;
class vtkUnsignedCharArray;

namespace hepatica {

inline constexpr double legend_letters_pt = 16.0;

// Draws into the two-dimensional layer of one renderer; not thread-safe.
class Legend {
  public:
    explicit Legend(vtkRenderer& renderer);

    struct Room {
        int width = 0, height = 0;  // of the picture, in device pixels
        double point = 1.0;         // one of the legend's points in device pixels
        double caption = 0.0;       // width of what stands left above
        // Pixels at the top and at the foot over which something else lies.
        double covered_top = 0.0, covered_bottom = 0.0;
    };
    // How many vertices of vessels lie in each of the boxes.
    using Count = std::function<std::vector<int>(const std::vector<PictureBox>&)>;

    // Lays everything out anew; no rows: nothing is drawn. Without `count` the legend stays in the
    // corner where it was.
    void update(const std::vector<LegendRow>& rows, const Room& room, const ViewLook& look,
                const Count& count);
    const PictureBox& box() const { return box_; }  // in which it was drawn last

  private:
    void add_quad(const PictureBox& box, const Colour& colour);
    void write(const std::string& text, double x, double y, int justification, const Colour& colour,
               double size);
    // Of a text in pixels, in letters of so many.
    double width_of(const std::string& text, double size);
    // What stands at the right of a line that has no room for it gets a line of its own.
    std::vector<LegendRow> fitting(const std::vector<LegendRow>& rows, double widest, double point);
    // What all rows need, in pixels.
    double width_of(const std::vector<LegendRow>& rows, double point);
    // A bar of colours, with the mark across it.
    void draw_bar(const LegendRow& row, const PictureBox& bar, double point, const Colour& mark);
    void draw_row(const LegendRow& row, double left, double top, double width, double point,
                  const ViewLook& look);

    vtkRenderer& renderer_;
    std::size_t corner_ = 0;
    PictureBox box_;
    vtkSmartPointer<vtkPoints> points_;
    vtkSmartPointer<vtkCellArray> quads_;
    vtkSmartPointer<vtkUnsignedCharArray> colours_;
    vtkSmartPointer<vtkPolyData> polydata_;
    vtkSmartPointer<vtkActor2D> actor_;
    Colour ground_{};
    bool covers_ = false;  // vessels are in every corner: the letters have a ground
    vtkSmartPointer<vtkTextActor> measure_;  // never drawn
    std::vector<vtkSmartPointer<vtkTextActor>> texts_;
    std::size_t texts_used_ = 0;
};

}  // namespace hepatica
