// SPDX-License-Identifier: GPL-3.0-or-later
// The two-dimensional marks over the picture: the legend, a scale bar of a round length, and a
// caption. Sizes are in points and follow the screen's pixel ratio.
#pragma once

#include <vtkSmartPointer.h>

#include <string>

#include "render/legend.h"
#include "render/view_look.h"

class vtkActor2D;
class vtkCamera;
class vtkPoints;
class vtkPolyData;
class vtkRenderer;
class vtkTextActor;

namespace hepatica {

// Size of the picture in device pixels, and of one point of the annotations in pixels: of those
// that shrink in small pictures, of the legend, which shrinks less, and of letters, which do not.
struct PictureSize {
    int width = 0;
    int height = 0;
    double pixel_ratio = 1.0;
    double legend_point = 1.0;
    double letter_point = 1.0;
    // Pixels at the top and at the foot over which something else lies: no mark stands there.
    double covered_top = 0.0;
    double covered_bottom = 0.0;
};

// Of the caption and the scale: 9 points of print. What has no room in that size is left out.
inline constexpr double annotation_letters_pt = 12.0;

// Draws into the two-dimensional layer of one renderer; not thread-safe.
class Annotations {
  public:
    explicit Annotations(vtkRenderer& renderer);

    // Places every mark for the next picture; call before each. Costs nothing where all is as it
    // was and no `count` is given, with which the legend looks for a corner (Legend::update()).
    void update(const PictureSize& size, vtkCamera& camera, const LegendContent& legend,
                const Legend::Count& count);
    const PictureBox& legend_box() const { return legend_.box(); }
    bool shows_caption() const;
    bool set_caption(const std::string& text);  // true if it was another
    void set_visible(bool visible) { visible_ = visible; }
    void set_look(const ViewLook& look);
    void set_words(PictureWords words);  // of all but the caption; English at first

  private:
    // Everything that the marks show or depend on.
    struct Shown {
        int width = 0, height = 0;
        double pixel_ratio = 0.0, legend_point = 0.0, letter_point = 0.0;
        double covered_top = 0.0, covered_bottom = 0.0;
        double distance_mm = 0.0, view_angle_deg = 0.0;
        bool visible = false;
        LegendContent legend;
        std::string caption;
        bool operator==(const Shown&) const = default;
    };
    void write_caption(const PictureSize& size);
    double caption_width();  // in pixels
    void update_scale_bar(const PictureSize& size, vtkCamera& camera);
    void draw_scale_bar(double x, double y, double width, double point);
    // Whether a text that has been placed has room there, and lies on nothing else.
    bool has_room(vtkTextActor& text, const PictureSize& size);

    vtkRenderer& renderer_;
    ViewLook look_ = dark_look;
    PictureWords words_;
    Shown shown_;
    bool visible_ = true;
    std::string caption_text_;
    Legend legend_;
    vtkSmartPointer<vtkPoints> bar_points_;
    vtkSmartPointer<vtkActor2D> bar_;
    vtkSmartPointer<vtkTextActor> bar_label_;
    vtkSmartPointer<vtkTextActor> caption_;
};

// The largest of 1, 2, 5 times a power of ten that is at most `length` > 0. (That set is closed
// under reciprocals: 1 / round_length_below(1 / x) is the smallest of it that is at least x.)
double round_length_below(double length);

}  // namespace hepatica
