// SPDX-License-Identifier: GPL-3.0-or-later
// A second 3D view beside the first, with another play of the same patient. Both share the line of
// sight: turning one turns the other, with its next picture.
#pragma once

#include <QWidget>
#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "core/base/vascular_system.h"
#include "core/scene/frame.h"
#include "render/mark_actors.h"

namespace hepatica {

class VtkWidget;

// UI thread only.
class SecondView : public QWidget {
  public:
    // The first view must outlive it. `as_first` gives a view the look and the mouse of the first.
    SecondView(VtkWidget& first, std::function<void(VtkWidget&)> as_first, QWidget* parent);

    // The view appears with the first frame. `frame` must not be null.
    void show_frame(const std::shared_ptr<const Frame>& frame, std::vector<MarkView> marks,
                    const std::vector<VascularSystem>& of_vertices, const QString& caption);
    // To be called when the look or the mouse of the first view is another.
    void take_after_first();
    // See SceneView::set_drug_scale(); effective from the next frame.
    void set_drug_scale(double least_end_s);
    // A bar covers this many points at the foot; text is kept clear of it.
    void keep_clear(int bottom);
    // Destroys the view and hides the widget.
    void clear();
    // To be called after every picture of the first view. Follows it where it was turned since both
    // had one line of sight.
    void follow_first();
    bool shown() const { return view_ != nullptr; }
    VtkWidget& view() { return *view_; }

  private:
    // Position of the eye, focal point, direction of up, and angle.
    using Sight = std::array<double, 10>;
    static Sight sight_of(VtkWidget& view);
    void make_view(const std::vector<VascularSystem>& of_vertices, const QString& caption);
    // True if the view was turned since both had one line of sight, which is then the view's.
    bool leads(VtkWidget& view);
    void lead_first();

    VtkWidget& first_;
    std::function<void(VtkWidget&)> as_first_;
    VtkWidget* view_ = nullptr;
    std::shared_ptr<const Frame> frame_;  // that is shown; null: none
    std::optional<Sight> shared_;         // none: not yet
    double drug_scale_s_ = 0.0;
    int covered_bottom_ = 0;
};

}  // namespace hepatica
