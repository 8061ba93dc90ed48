// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/legend.h"

#include <vtkActor2D.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper2D.h>
#include <vtkRenderer.h>
#include <vtkTextActor.h>
#include <vtkTextProperty.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <utility>

#include "render/text_style.h"

namespace hepatica {
namespace {

// In points.
constexpr double margin = 18.0;
constexpr double line = 22.0;  // between lines of text
constexpr double bar = 10.0, gap = 5.0;
constexpr double swatch = 13.0;
constexpr double text_after_swatch = 21.0;
constexpr double between_names = 16.0;  // in one line
constexpr double widest_bar = 236.0;
constexpr double least_shrunk = 0.6;

// A legend that hides no more than this part of the vessels hides hardly any.
constexpr int hidden_share = 50;  // as a fraction of 1
// In a narrower picture there is no room for a legend beside the scale bar, nor, mostly, beside the
// vessels: a view beside slices is so narrow on a screen of 1280 points.
constexpr double narrow_points = 640.0;

double height_of(const LegendRow& row) {
    return line + (row.colours.size() > 1 ? bar + gap + line : 0.0);
}

double height_of(const std::vector<LegendRow>& rows) {
    double height = 0.0;
    for (const LegendRow& row : rows) height += height_of(row);
    return height;
}

// Of at least one row, the one that is left out first: the last minor one, else the last that is
// not needed, else the last.
std::size_t least_of(const std::vector<LegendRow>& rows) {
    for (std::size_t r = rows.size(); r-- > 0;)
        if (rows[r].minor) return r;
    for (std::size_t r = rows.size(); r-- > 0;)
        if (!rows[r].needed) return r;
    return rows.size() - 1;
}

// How many rows name something: an explanation of another row does not.
std::size_t names_in(const std::vector<LegendRow>& rows) {
    return static_cast<std::size_t>(
        std::ranges::count_if(rows, [](const LegendRow& row) { return !row.faint; }));
}

// The height of the picture in points that nothing else covers.
double free_points(const Legend::Room& room) {
    const double covered = room.covered_top + room.covered_bottom;
    return (room.height - covered) / room.point - 2.0 * margin - line;
}

void leave_out_least(std::vector<LegendRow>& rows) {
    rows.erase(rows.begin() + static_cast<std::ptrdiff_t>(least_of(rows)));
}

// The rows without minor ones while they are higher than half of the picture, and without others
// while they are higher than what is free of it; with the row that says how many are left out, for
// which no needed one goes.
std::vector<LegendRow> with_room(std::vector<LegendRow> rows, const Legend::Room& room) {
    const std::size_t names = names_in(rows);
    const double free_pt = free_points(room);
    while (!rows.empty()) {
        const LegendRow& least = rows[least_of(rows)];
        const double most_pt = least.minor ? 0.5 * room.height / room.point : free_pt;
        const double how_many = names_in(rows) < names && !least.needed ? line : 0.0;
        if (height_of(rows) + how_many <= std::min(most_pt, free_pt)) break;
        leave_out_least(rows);
    }
    return rows;
}

// One of four views on a screen of 1280 by 800 points, or smaller.
bool is_small(const Legend::Room& room) {
    return room.width < 300.0 * room.point || room.height < 300.0 * room.point;
}

// A picture to choose by, not to read.
bool is_thumbnail(const Legend::Room& room) {
    return room.width < 200.0 * room.point || room.height < 200.0 * room.point;
}

bool is_narrow(const Legend::Room& room) {
    return room.width < narrow_points * room.point;
}

// Beside which another one may stand.
bool is_name(const LegendRow& row) {
    return row.colours.size() == 1 && row.at_right.empty() && !row.faint && !row.passing;
}

// A bar of colours is as wide as a line of names, and an explanation belongs below its row.
bool may_be_lines(const std::vector<LegendRow>& rows) {
    return std::ranges::count_if(rows, is_name) > 1 &&
           std::ranges::none_of(
               rows, [](const LegendRow& row) { return row.faint || row.colours.size() > 1; });
}

// Whether rows are left out that would hide vessels: a view beside slices is narrow, and its
// colours are told by the slices, too; a bar of numbers is needed to read them.
bool gives_way(const std::vector<LegendRow>& rows, const Legend::Room& room) {
    return is_small(room) || (is_narrow(room) && may_be_lines(rows));
}

// What does not come and go with the pointer.
std::vector<LegendRow> steady_of(std::vector<LegendRow> rows) {
    std::erase_if(rows, [](const LegendRow& row) { return row.passing; });
    return rows;
}

int all_in(const Legend::Room& room, const Legend::Count& count) {
    return count({{0.0, 0.0, double(room.width), double(room.height)}})[0];
}

// Where a legend of this size may lie: lower right, upper right, upper left; the orientation cube
// is in the lower left corner.
std::vector<PictureBox> legend_corners(const Legend::Room& room, double width, double height) {
    const double r = room.point;
    const double right = room.width - margin * r, top = room.height - room.covered_top - margin * r;
    const double below_caption = top - line * r;
    // Below the caption where there is no room beside it.
    const bool beside_caption = room.caption + width + 3.0 * margin * r <= room.width;
    const double right_top = beside_caption ? top : below_caption;
    // In a narrow picture the legend goes above the scale bar.
    double foot = room.covered_bottom + (is_narrow(room) ? (margin + 36.0) * r : margin * r);
    // Above the cube where it would lie on it.
    if (right - width < room.cube_right) foot = std::max(foot, room.cube_top + gap * r);
    // But never out of the picture.
    foot = std::min(foot, std::max(room.covered_bottom, top - height));
    return {{right - width, foot, right, foot + height},
            {right - width, right_top - height, right, right_top},
            {margin * r, below_caption - height, margin * r + width, below_caption}};
}

}  // namespace

Legend::Legend(vtkRenderer& renderer)
    : renderer_(renderer),
      most_rows_(std::numeric_limits<std::size_t>::max()),
      points_(vtkSmartPointer<vtkPoints>::New()),
      quads_(vtkSmartPointer<vtkCellArray>::New()),
      colours_(vtkSmartPointer<vtkUnsignedCharArray>::New()),
      polydata_(vtkSmartPointer<vtkPolyData>::New()),
      actor_(vtkSmartPointer<vtkActor2D>::New()),
      measure_(vtkSmartPointer<vtkTextActor>::New()) {
    colours_->SetNumberOfComponents(3);
    polydata_->SetPoints(points_);
    polydata_->SetPolys(quads_);
    polydata_->GetCellData()->SetScalars(colours_);
    vtkNew<vtkPolyDataMapper2D> mapper;
    mapper->SetInputData(polydata_);
    actor_->SetMapper(mapper);
    renderer.AddActor2D(actor_);
}

double Legend::width_of(const std::string& text, double size) {
    if (text.empty()) return 0.0;
    style_text(*measure_->GetTextProperty(), static_cast<int>(std::lround(size)), Colour{});
    measure_->SetInput(text.c_str());
    double extent[2] = {0.0, 0.0};
    measure_->GetSize(&renderer_, extent);
    return extent[0];
}

double Legend::width_of(const std::vector<LegendRow>& rows, double point) {
    double width = 0.0;
    for (const LegendRow& row : rows) {
        const double size = legend_letters_pt * point;
        double text = width_of(row.text, size);
        if (!row.at_right.empty()) text += width_of("m" + row.at_right, size);
        if (row.colours.size() == 1) text += text_after_swatch * point;
        for (const auto& [colour, name] : row.beside)
            text += (between_names + text_after_swatch) * point + width_of(name, size);
        width = std::max({width, text, row.colours.size() > 1 ? widest_bar * point : 0.0});
    }
    return std::ceil(width);
}

void Legend::add_quad(const PictureBox& box, const Colour& colour) {
    const vtkIdType first = points_->InsertNextPoint(box.left, box.bottom, 0);
    points_->InsertNextPoint(box.right, box.bottom, 0);
    points_->InsertNextPoint(box.right, box.top, 0);
    points_->InsertNextPoint(box.left, box.top, 0);
    quads_->InsertNextCell({first, first + 1, first + 2, first + 3});
    for (const double channel : colour)
        colours_->InsertNextValue(static_cast<unsigned char>(std::lround(255.0 * channel)));
}

void Legend::write(const std::string& text, double x, double y, int justification,
                   const Colour& colour, double size) {
    if (text.empty()) return;  // VTK warns about empty texts
    if (texts_used_ == texts_.size()) {
        texts_.push_back(vtkSmartPointer<vtkTextActor>::New());
        renderer_.AddActor2D(texts_.back());
    }
    vtkTextActor& actor = *texts_[texts_used_++];
    style_text(*actor.GetTextProperty(), static_cast<int>(std::lround(size)), colour);
    actor.GetTextProperty()->SetJustification(justification);
    actor.GetTextProperty()->SetBackgroundColor(ground_[0], ground_[1], ground_[2]);
    actor.GetTextProperty()->SetBackgroundOpacity(covers_ ? 0.75 : 0.0);
    actor.SetInput(text.c_str());
    actor.SetPosition(std::round(x), std::round(y));
    actor.SetVisibility(true);
}

void Legend::draw_row(const LegendRow& row, double left, double top, double width, double point,
                      const ViewLook& look) {
    const double size = legend_letters_pt * point;
    const double base = top - 16.0 * point;  // baseline of the letters
    const bool swatched = row.colours.size() == 1;
    write(row.text, left + (swatched ? text_after_swatch * point : 0.0), base, VTK_TEXT_LEFT,
          row.faint ? look.faint_text : look.text, size);
    write(row.at_right, left + width, base, VTK_TEXT_RIGHT, look.text, size);
    if (swatched)
        draw_swatch({left, base, left + swatch * point, base + swatch * point}, row.colours[0],
                    point, look);
    double end =
        left + text_after_swatch * point + (row.beside.empty() ? 0.0 : width_of(row.text, size));
    for (const auto& [colour, name] : row.beside) {
        const double from = end + between_names * point;
        draw_swatch({from, base, from + swatch * point, base + swatch * point}, colour, point,
                    look);
        write(name, from + text_after_swatch * point, base, VTK_TEXT_LEFT, look.text, size);
        end = from + text_after_swatch * point + width_of(name, size);
    }
    if (row.colours.size() < 2) return;
    const double upper = top - line * point, lower = upper - bar * point;
    draw_bar(row, {left, lower, left + width, upper}, point, look.text);
    // A narrow bar has room for every other label only.
    const bool narrow = width < 180.0 * point;
    for (std::size_t t = 0; t < row.ticks.size(); ++t) {
        const auto& [place, label] = row.ticks[t];
        if (narrow && row.ticks.size() % 2 == 1 && t % 2 == 1) continue;
        write(label, left + width * place, lower - (gap + 13.0) * point,
              place == 0.0   ? VTK_TEXT_LEFT
              : place == 1.0 ? VTK_TEXT_RIGHT
                             : VTK_TEXT_CENTERED,
              look.text, size);
    }
}

// One that is hardly seen on the background has a rim.
void Legend::draw_swatch(const PictureBox& box, const Colour& colour, double point,
                         const ViewLook& look) {
    constexpr double least = 3.0;
    if (std::min(palette::contrast(colour, look.top), palette::contrast(colour, look.bottom)) >=
        least)
        return add_quad(box, colour);
    const double rim = std::max(1.0, std::round(point));
    const PictureBox within{box.left + rim, box.bottom + rim, box.right - rim, box.top - rim};
    add_quad(within, colour);
    add_quad({box.left, box.bottom, box.right, within.bottom}, look.faint_text);
    add_quad({box.left, within.top, box.right, box.top}, look.faint_text);
    add_quad({box.left, within.bottom, within.left, within.top}, look.faint_text);
    add_quad({within.right, within.bottom, box.right, within.top}, look.faint_text);
}

// Quads must not overlap: which of two coplanar quads is visible depends on VTK's version.
void Legend::draw_bar(const LegendRow& row, const PictureBox& bar, double point,
                      const Colour& mark) {
    const double width = bar.right - bar.left;
    const auto cells = static_cast<double>(row.colours.size());
    const double at = row.marker ? bar.left + width * *row.marker : -1e9;
    const double before = at - 1.2 * point, behind = at + 1.2 * point;
    if (row.marker)
        add_quad({before, bar.bottom - 3.0 * point, behind, bar.top + 3.0 * point}, mark);
    for (std::size_t c = 0; c < row.colours.size(); ++c) {
        const double from = bar.left + width * static_cast<double>(c) / cells;
        const double to = bar.left + width * static_cast<double>(c + 1) / cells;
        if (from < before)
            add_quad({from, bar.bottom, std::min(to, before), bar.top}, row.colours[c]);
        if (to > behind)
            add_quad({std::max(from, behind), bar.bottom, to, bar.top}, row.colours[c]);
    }
}

std::vector<LegendRow> Legend::fitting(const std::vector<LegendRow>& rows, double widest,
                                       double point) {
    std::vector<LegendRow> fitted;
    for (LegendRow row : rows) {
        if (!row.at_right.empty() && width_of({row}, point) > widest) {
            LegendRow title;
            title.text = std::exchange(row.text, row.at_right);
            row.at_right.clear();
            fitted.push_back(std::move(title));
        }
        fitted.push_back(std::move(row));
    }
    return fitted;
}

std::vector<LegendRow> Legend::in_lines(const std::vector<LegendRow>& rows, double widest,
                                        double point) {
    std::vector<LegendRow> lines;
    for (const LegendRow& row : rows) {
        if (is_name(row) && !lines.empty() && is_name(lines.back())) {
            LegendRow longer = lines.back();
            longer.beside.emplace_back(row.colours.front(), row.text);
            if (width_of({longer}, point) <= widest) {
                lines.back() = std::move(longer);
                continue;
            }
        }
        lines.push_back(row);
    }
    return lines;
}

// Letters shrink before anything is cut off.
Legend::Layout Legend::laid_out(const std::vector<LegendRow>& rows, const Room& room,
                                std::size_t left_out, bool in_lines) {
    const double widest = room.width - 2.0 * margin * room.point;
    Layout layout;
    layout.rows =
        in_lines ? this->in_lines(rows, widest, room.point) : fitting(rows, widest, room.point);
    if (left_out > 0 && !rows.empty() && height_of(layout.rows) + line <= free_points(room)) {
        LegendRow how_many;
        how_many.text = said(words_, "and " + std::to_string(left_out) + " more");
        how_many.faint = true;
        layout.rows.push_back(std::move(how_many));
    }
    const double needed = width_of(layout.rows, room.point);
    layout.point = room.point * std::clamp(widest / std::max(needed, 1.0), least_shrunk, 1.0);
    layout.corners = legend_corners(room, std::min(width_of(layout.rows, layout.point), widest),
                                    height_of(layout.rows) * layout.point);
    return layout;
}

Legend::Layout Legend::of_narrow(const std::vector<LegendRow>& rows, const Room& room,
                                 std::size_t left_out, const Count& count) {
    Layout below = laid_out(rows, room, left_out);
    if (!is_narrow(room) || !may_be_lines(rows)) {
        in_lines_ = false;
        return below;
    }
    if (count) {
        const std::vector<LegendRow> steady = steady_of(rows);
        const auto hidden_by = [&](bool in_lines) {
            return std::ranges::min(count(laid_out(steady, room, left_out, in_lines).corners));
        };
        const int hidden = hidden_by(false);
        in_lines_ = hidden_share * hidden > all_in(room, count) && hidden_by(true) < hidden;
    }
    return in_lines_ ? laid_out(rows, room, left_out, true) : below;
}

Legend::Layout Legend::beside_vessels(const std::vector<LegendRow>& wanted, const Room& room,
                                      const Count& count) {
    std::vector<LegendRow> rows = with_room(wanted, room);
    const bool yields = gives_way(rows, room);
    if (!yields)
        most_rows_ = std::numeric_limits<std::size_t>::max();
    else if (count)
        most_rows_ = rows.size();
    while (rows.size() > most_rows_) leave_out_least(rows);
    const auto laid = [&] {
        return of_narrow(rows, room, names_in(wanted) - names_in(rows), count);
    };
    Layout layout = laid();
    if (yields && count) {
        const auto hidden = [&] { return std::ranges::min(count(layout.corners)); };
        const auto needed = static_cast<std::size_t>(
            std::ranges::count_if(rows, [](const LegendRow& row) { return row.needed; }));
        const std::size_t fewest = is_thumbnail(room) ? 0 : needed;
        const int all = all_in(room, count), hidden_by_all = hidden();
        const std::vector<LegendRow> before = rows;
        while (rows.size() > fewest && hidden_share * hidden() > all) {
            leave_out_least(rows);
            layout = laid();
        }
        // The row that says how many are left out may hide as much as they did.
        if (rows.size() < before.size() && hidden() >= hidden_by_all) {
            rows = before;
            layout = laid();
        }
        most_rows_ = rows.size();
    }
    leaves_out_ = rows.size() < wanted.size();
    return layout;
}

// Passing rows do not choose it.
void Legend::choose_corner(const Layout& layout, const Room& room, const Count& count) {
    const std::vector<LegendRow> steady = steady_of(layout.rows);
    const std::vector<int> held = count(layout.corners);
    corner_ = least_covered(
        steady.size() == layout.rows.size() ? held : count(laid_out(steady, room).corners));
    covers_ = held[corner_] > 0;
}

void Legend::update(const std::vector<LegendRow>& wanted, const Room& room, const ViewLook& look,
                    const Count& count, const PictureWords& words) {
    words_ = words;
    points_->Reset();
    quads_->Reset();
    colours_->Reset();
    texts_used_ = 0;
    ground_ = look.bottom;
    box_ = {};
    const Layout layout = beside_vessels(wanted, room, count);
    rows_ = layout.rows;
    if (!layout.rows.empty()) {
        if (count) choose_corner(layout, room, count);
        box_ = layout.corners[corner_];
        double y = box_.top;
        for (const LegendRow& row : layout.rows) {
            draw_row(row, box_.left, y, box_.right - box_.left, layout.point, look);
            y -= height_of(row) * layout.point;
        }
    }
    for (std::size_t t = texts_used_; t < texts_.size(); ++t) texts_[t]->SetVisibility(false);
    actor_->SetVisibility(!layout.rows.empty());
    points_->Modified();
    quads_->Modified();
    colours_->Modified();
    polydata_->Modified();
}

}  // namespace hepatica
