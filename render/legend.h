// SPDX-License-Identifier: GPL-3.0-or-later
// Draws the legend (legend_rows.h) in the corner of the picture that covers the fewest vessels.
// Letters have 16 points of the screen, which are 12 points of print; they shrink in thumbnails and
// where a row would not fit. Minor rows are left out where the legend would be higher than half of
// the picture, and others where it would be higher than the picture. In a small picture, and of
// names of colours in a narrow one, as many are left out as it takes to hide hardly any vessel;
// needed rows only in a thumbnail. A row of its own says how many are left out. In a narrow picture
// names of colours stand beside each other where they would hide vessels below each other, and hide
// fewer so.
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
        int width = 0, height = 0;  // size of the picture in device pixels
        double point = 1.0;         // one point of the legend in device pixels
        double caption = 0.0;       // width of the caption in the upper left corner
        // Heights in pixels at the top and bottom that something else covers.
        double covered_top = 0.0, covered_bottom = 0.0;
        // Upper right corner of the orientation cube in the lower left corner of the picture.
        double cube_right = 0.0, cube_top = 0.0;
    };
    // The number of vessel vertices in each of the boxes.
    using Count = std::function<std::vector<int>(const std::vector<PictureBox>&)>;

    // Lays out everything anew; without rows nothing is drawn. With `count` it moves to the corner
    // that covers the fewest vertices; without, it stays in its corner. Passing rows do not choose
    // the corner: it would change under the pointer. `rows` are translated, by `words`.
    void update(const std::vector<LegendRow>& rows, const Room& room, const ViewLook& look,
                const Count& count, const PictureWords& words = {});
    // Where it was drawn last; empty where it was not.
    const PictureBox& box() const { return box_; }
    // Its rows then, with the one that says how many are left out.
    const std::vector<LegendRow>& rows() const { return rows_; }
    // Whether rows were left out then.
    bool leaves_out() const { return leaves_out_; }

  private:
    // Rows as they are drawn: the size of a point for them, and the boxes that they may lie in.
    struct Layout {
        std::vector<LegendRow> rows;
        double point = 1.0;
        std::vector<PictureBox> corners;
    };
    // `left_out`: how many names are left out, which a row says where there is room for it.
    Layout laid_out(const std::vector<LegendRow>& rows, const Room& room, std::size_t left_out = 0,
                    bool in_lines = false);
    // The layout with names beside each other where that hides fewer vessels.
    Layout of_narrow(const std::vector<LegendRow>& rows, const Room& room, std::size_t left_out,
                     const Count& count);
    // The layout of those of `wanted` that leave the vessels visible where the legend gives way to
    // them, and that there is room for.
    Layout beside_vessels(const std::vector<LegendRow>& wanted, const Room& room,
                          const Count& count);
    void choose_corner(const Layout& layout, const Room& room, const Count& count);
    void add_quad(const PictureBox& box, const Colour& colour);
    void write(const std::string& text, double x, double y, int justification, const Colour& colour,
               double size);
    // Width of a text in pixels at a letter size in pixels.
    double width_of(const std::string& text, double size);
    // Puts names of colours that follow each other into as few lines as hold them.
    std::vector<LegendRow> in_lines(const std::vector<LegendRow>& rows, double widest,
                                    double point);
    // Moves text at the right end of a row to a row of its own where it does not fit.
    std::vector<LegendRow> fitting(const std::vector<LegendRow>& rows, double widest, double point);
    // Width in pixels that all rows need.
    double width_of(const std::vector<LegendRow>& rows, double point);
    void draw_swatch(const PictureBox& box, const Colour& colour, double point,
                     const ViewLook& look);
    // A bar of colours with the marker across it.
    void draw_bar(const LegendRow& row, const PictureBox& bar, double point, const Colour& mark);
    void draw_row(const LegendRow& row, double left, double top, double width, double point,
                  const ViewLook& look);

    vtkRenderer& renderer_;
    std::size_t corner_ = 0;
    std::size_t most_rows_;  // that there was room for beside vessels when it was last counted
    bool in_lines_ = false;  // names stood beside each other when it was last counted
    PictureBox box_;
    std::vector<LegendRow> rows_;
    PictureWords words_;
    bool leaves_out_ = false;
    vtkSmartPointer<vtkPoints> points_;
    vtkSmartPointer<vtkCellArray> quads_;
    vtkSmartPointer<vtkUnsignedCharArray> colours_;
    vtkSmartPointer<vtkPolyData> polydata_;
    vtkSmartPointer<vtkActor2D> actor_;
    Colour ground_{};
    bool covers_ = false;  // vessels lie in every corner, so letters get a background
    vtkSmartPointer<vtkTextActor> measure_;  // measures texts; never drawn
    std::vector<vtkSmartPointer<vtkTextActor>> texts_;
    std::size_t texts_used_ = 0;
};

}  // namespace hepatica
