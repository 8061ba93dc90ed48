// SPDX-License-Identifier: GPL-3.0-or-later
// The two-dimensional annotations over the picture: the legend, a scale bar of a round length, and
// a caption. Sizes are in points and follow the screen's pixel ratio.
#pragma once

#include <vtkSmartPointer.h>

#include <string>

#include "render/legend.h"
#include "render/view_look.h"

class vtkActor2D;
class vtkCamera;
class vtkPoints;
class vtkRenderer;
class vtkTextActor;

namespace hepatica {

// Size of the picture in device pixels, and the size of one point in pixels for each kind of
// annotation: `pixel_ratio` for lengths, which shrink in small pictures; `legend_point` for the
// legend, which shrinks less; `letter_point` for letters, which do not shrink.
struct PictureSize {
    int width = 0;
    int height = 0;
    double pixel_ratio = 1.0;
    double legend_point = 1.0;
    double letter_point = 1.0;
    // Heights in pixels at the top and bottom that something else covers; annotations keep clear of
    // them.
    double covered_top = 0.0;
    double covered_bottom = 0.0;
};

// Letter size of the caption and the scale bar: 12 points of the screen, which are 9 points of
// print. Text that does not fit at this size is left out.
inline constexpr double annotation_letters_pt = 12.0;

// Draws into the two-dimensional layer of one renderer; not thread-safe.
class Annotations {
  public:
    explicit Annotations(vtkRenderer& renderer);

    // Places every annotation for the next picture; call before each. Costs nothing where nothing
    // has changed and no `count` is given. With `count` the legend chooses its corner
    // (Legend::update()).
    void update(const PictureSize& size, vtkCamera& camera, const LegendContent& legend,
                const Legend::Count& count);
    const PictureBox& legend_box() const { return legend_.box(); }
    bool shows_caption() const;
    bool set_caption(const std::string& text);  // true if the text changed
    void set_visible(bool visible) { visible_ = visible; }
    void set_look(const ViewLook& look);
    void set_words(PictureWords words);  // for all texts but the caption; English by default

  private:
    // Everything that the annotations show or depend on.
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
    // Whether a text, as placed, fits into the picture, leaves a gap to the legend beside it and
    // does not overlap the orientation marker.
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

// The largest number of the form 1, 2 or 5 times a power of ten that is at most `length`, which
// must be > 0. The set is closed under reciprocals: 1 / round_length_below(1 / x) is the smallest
// such number that is at least x.
double round_length_below(double length);

}  // namespace hepatica
