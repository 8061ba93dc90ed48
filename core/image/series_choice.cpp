// SPDX-License-Identifier: GPL-3.0-or-later
// Ranks the series by eight criteria, of which the first difference decides.
#include "core/image/series_choice.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <compare>
#include <cstdlib>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <sstream>
#include <tuple>
#include <utility>

#include "core/base/error.h"
#include "core/base/number_text.h"
#include "core/base/quoted_name.h"
#include "core/image/dicom_series.h"
#include "core/image/header_text.h"

namespace hepatica {

namespace fs = std::filesystem;

namespace {

constexpr double thickest_good_mm = 3.0;  // between slices; above it thin vessels are lost
// Of the normal with the body's axis; gantries tilt by up to 30 degrees.
constexpr double least_axial_cosine = 0.86;
// Share of the longest series; shorter ones are bolus tracking.
constexpr double enough_of_longest = 0.5;

bool holds_any(const std::string& text, std::initializer_list<const char*> parts) {
    return std::ranges::any_of(
        parts, [&](const char* part) { return text.find(part) != std::string::npos; });
}

// Sharp kernels for lungs and bones, whose noise hides vessels of the liver: GE's by name, Siemens'
// (B70f, Br64) and Canon's (FC52) by number, others by the description of the series.
bool is_sharp_kernel(const std::string& kernel, const std::string& description) {
    const std::string name = lower_case(kernel);
    if (holds_any(name, {"lung", "bone", "edge", "chst", "sharp"})) return true;
    const std::size_t digit = name.find_first_of("0123456789");
    if (digit != std::string::npos) {
        const int number = std::atoi(name.substr(digit, 3).c_str());
        if (name.starts_with("fc")) return number >= 30;
        if (holds_any(name.substr(0, 1), {"b", "h", "i", "q"})) return number >= 50;
    }
    return holds_any(lower_case(description), {"lung", "pulm", "poumon", "bone", "knochen"});
}

// In ascending order of the contrast of portal and hepatic veins.
enum class Phase { without_contrast, unknown, arterial, late, portal_venous };

// Recognised by the words that radiologists use in series descriptions.
Phase phase_of(const std::string& description) {
    std::string name = lower_case(description);
    for (const char* way : {"intravenous", "intraven"})  // route of the contrast, not its phase
        if (const std::size_t at = name.find(way); at != std::string::npos)
            name.erase(at, std::string(way).size());
    if (holds_any(name, {"portal", "venous", "venos", "venös", "veineux", "porto", "pv phase"}))
        return Phase::portal_venous;
    if (holds_any(name, {"non-contrast", "noncontrast", "non contrast", "without", "native",
                         "nativ", "plain", "unenhanced", "sans inj"}))
        return Phase::without_contrast;
    if (holds_any(name, {"arteri", "artériel"})) return Phase::arterial;  // may be a late one
    if (holds_any(name, {"delay", "tardif", "equilib", "spät"}) ||
        std::ranges::count(words(name), "late") > 0)  // not "lateral"
        return Phase::late;
    if (holds_any(name, {"angio", "early"})) return Phase::arterial;
    return Phase::unknown;
}

const char* name_of(Phase phase) {
    switch (phase) {
        case Phase::portal_venous:
            return "portal venous phase";
        case Phase::late:
            return "late phase";
        case Phase::arterial:
            return "arterial phase";
        case Phase::without_contrast:
            return "no contrast";
        case Phase::unknown:
            break;
    }
    return "";
}

struct Series {
    std::vector<DicomSlice> slices;
    double spacing_mm = 0.0;  // between neighbouring slices; 0 where unknown
    double extent_mm = 0.0;   // from the first slice to the last
    bool covers = true;       // about as much as the longest series

    const DicomSlice& first() const { return slices.front(); }
    std::size_t images() const {
        std::size_t count = 0;
        for (const DicomSlice& slice : slices) count += static_cast<std::size_t>(slice.frames);
        return count;
    }
    // A multi-frame file that does not state the positions of all frames.
    bool hides_extent() const {
        return std::ranges::any_of(slices, [](const DicomSlice& slice) {
            return slice.enhanced && slice.frame_positions_mm.empty();
        });
    }
    bool is_ct() const { return first().modality == "CT" || first().modality.empty(); }
    bool is_axial() const {
        return !first().has_geometry || std::abs(first().normal().z()) > least_axial_cosine;
    }
    bool is_projection() const {
        // A dose alone is none: so are series of a low dose called.
        return holds_any(lower_case(first().image_type + first().description),
                         {"mip", "mpr thick", "projection", "screen save", "dose report",
                          "dose info", "dose record", "dose summary"});
    }
    bool is_soft() const { return !is_sharp_kernel(first().kernel, first().description); }
    Phase phase() const { return phase_of(first().description); }
    bool is_thin() const { return spacing_mm > 0.0 && spacing_mm <= thickest_good_mm; }
};

// Larger is better; the first difference decides.
constexpr std::size_t criteria = 8;
using Rank = std::array<double, criteria>;

Rank rank_of(const Series& series) {
    return {series.is_ct() ? 1.0 : 0.0,
            series.covers ? 1.0 : 0.0,
            series.is_axial() && !series.is_projection() ? 1.0 : 0.0,
            series.is_soft() ? 1.0 : 0.0,
            static_cast<double>(series.phase()),
            series.first().contrast_agent ? 1.0 : 0.0,
            series.is_thin() ? 1.0 : 0.0,
            static_cast<double>(series.images())};
}

// Why the better of two was preferred.
std::string reason(const Series& better, const Series& worse) {
    static constexpr std::array<const char*, criteria> words{
        "it is a CT",
        "it covers more of the body",
        "its slices are axial and not projected",
        "its kernel is for soft tissue",
        "of its phase of the contrast",
        "it was taken with contrast",
        "its slices lie closer together",
        "it has more slices"};
    const Rank a = rank_of(better), b = rank_of(worse);
    for (std::size_t i = 0; i < criteria; ++i)
        if (a[i] > b[i]) return words[i];
    return "it stands first";
}

void measure_extent(Series& series) {
    if (series.hides_extent()) return;
    std::vector<double> places;
    const Vec3 normal = series.first().normal();
    for (const DicomSlice& slice : series.slices) {
        for (const Vec3& frame : slice.frame_positions_mm) places.push_back(frame.dot(normal));
        if (slice.has_geometry && slice.frame_positions_mm.empty())
            places.push_back(slice.position_mm.dot(normal));
    }
    std::ranges::sort(places);
    places.erase(std::unique(places.begin(), places.end(),
                             [](double x, double y) { return std::abs(x - y) < 1e-3; }),
                 places.end());
    if (places.size() < 2) return;
    series.extent_mm = places.back() - places.front();
    series.spacing_mm = series.extent_mm / static_cast<double>(places.size() - 1);
}

// Two phases that lost their identifiers have the same positions; then their acquisition numbers
// separate them.
bool lie_in_one_place(const std::vector<DicomSlice>& slices) {
    std::set<std::tuple<double, double, double>> places;
    for (const DicomSlice& slice : slices) {
        const Vec3& p = slice.position_mm;
        if (slice.has_geometry && !places.emplace(p.x(), p.y(), p.z()).second) return true;
    }
    return false;
}

std::map<std::string, std::vector<DicomSlice>> grouped(const std::vector<DicomSlice>& slices) {
    std::map<std::string, std::vector<DicomSlice>> by_key, parted;
    for (const DicomSlice& slice : slices)
        if (!slice.localizer) by_key[slice.series_key].push_back(slice);
    for (auto& [key, series] : by_key) {
        const bool split = key.starts_with("no UID") && lie_in_one_place(series);
        for (DicomSlice& slice : series)
            parted[split ? key + "/acquisition " + slice.acquisition : key].push_back(slice);
    }
    return parted;
}

// CT first, best first; equal ones in the order of their keys.
std::vector<Series> ranked(const std::vector<DicomSlice>& slices) {
    std::vector<Series> all;
    double longest_mm = 0.0;
    for (auto& [key, group] : grouped(slices)) {
        Series& series = all.emplace_back();
        series.slices = std::move(group);
        measure_extent(series);
        if (series.is_ct()) longest_mm = std::max(longest_mm, series.extent_mm);
    }
    for (Series& series : all)
        series.covers = series.hides_extent() || series.extent_mm >= enough_of_longest * longest_mm;
    std::ranges::stable_sort(all, std::ranges::greater{}, rank_of);
    return all;
}

// The file of the middle slice along the normal.
fs::path middle_slice(const Series& series) {
    std::vector<std::pair<double, std::size_t>> places;
    for (std::size_t i = 0; i < series.slices.size(); ++i) {
        const DicomSlice& slice = series.slices[i];
        const bool placed = slice.has_geometry && series.first().has_geometry;
        places.emplace_back(placed ? slice.position_mm.dot(series.first().normal()) : 0.0, i);
    }
    const auto middle = places.begin() + static_cast<std::ptrdiff_t>(places.size() / 2);
    std::ranges::nth_element(places, middle);
    return series.slices[middle->second].file;
}

// As far as the file's size tells: compressed pixels may break off anywhere.
bool is_cut_off(const DicomSlice& slice) {
    if (slice.compressed || slice.deflated_at != 0) return false;
    std::error_code failed;
    const std::uintmax_t bytes = fs::file_size(slice.pixel_file, failed);
    return !failed && slice.pixel_offset + slice.pixel_bytes > bytes;
}

std::vector<std::string> warnings_of(const Series& series) {
    if (!series.is_ct()) return {"it is no CT"};
    std::vector<std::string> warnings;
    const auto cannot_be_read = [&](const std::string& why, const fs::path& file) {
        warnings.push_back("it cannot be read: " + why + " (" +
                           quoted_name(file.filename().string()) + ")");
    };
    const auto cut_off = std::ranges::find_if(series.slices, is_cut_off);
    if (cut_off != series.slices.end())
        cannot_be_read("has fewer pixels than its header claims", cut_off->file);
    const bool known =  // the frames of an enhanced file are unknown until it is split
        std::ranges::none_of(series.slices, &DicomSlice::enhanced);
    try {
        if (known) order_slices(series.slices);
    } catch (const InputError& refused) {
        cannot_be_read(refused.problem(), refused.place());
    }
    if (series.spacing_mm > thickest_good_mm)
        warnings.push_back("its slices lie far apart: thin vessels are lost");
    constexpr double least_height_mm = 100.0;  // an adult's liver is 150 mm high or more
    const double height_mm = series.extent_mm + series.spacing_mm;
    if (height_mm > 0.0 && height_mm < least_height_mm)
        warnings.push_back("it is " + number_text(std::round(height_mm)) +
                           " mm high: not all of the liver is in it");
    if (series.phase() == Phase::without_contrast)
        warnings.push_back("without contrast no vessel is seen");
    return warnings;
}

// The description is `series NUMBER "NAME"`, of which number or name may be missing. The name alone
// is quoted, and the number told where it is one.
std::string called(const std::string& description) {
    const std::size_t quote = description.find('"');
    const std::vector<std::string> before = words(description.substr(0, quote));
    const bool numbered =
        before.size() == 2 && before[1].find_first_not_of("0123456789") == std::string::npos;
    std::string text = numbered ? "series " + before[1] : "a series";
    if (quote != std::string::npos && description.size() > quote + 1)
        text +=
            " " +
            quoted_name(
                std::string_view(description).substr(quote + 1, description.size() - quote - 2));
    return text;
}

std::string text_of(const Series& series) {
    const DicomSlice& first = series.first();
    std::ostringstream text;
    const bool is_ct = first.modality == "CT";
    text << called(first.description) << " ("
         << (first.modality.empty() ? "no modality"
             : is_ct                ? "CT"
                                    : quoted_name(first.modality))
         << ", " << series.images() << " images";
    if (series.spacing_mm > 0.0) {
        text.precision(3);
        text << ", " << series.spacing_mm << " mm apart";
    }
    // DICOM separates several values of a field by backslashes.
    std::string kernel = first.kernel;
    std::ranges::replace(kernel, '\\', '/');
    if (!kernel.empty()) text << ", kernel " << quoted_name(kernel);
    if (series.phase() != Phase::unknown) text << ", " << name_of(series.phase());
    text << ")";
    return text.str();
}

bool holds_file(const Series& series, const fs::path& file) {
    return !file.empty() &&
           std::ranges::find(series.slices, file, &DicomSlice::file) != series.slices.end();
}

// The index in the list; nothing if there is no such series.
std::optional<std::size_t> wished(const std::vector<Series>& all, const SeriesWish& wish) {
    const auto number = static_cast<std::size_t>(wish.number);
    if (wish.number != 0)
        return wish.number > 0 && number <= all.size() ? std::optional(number - 1) : std::nullopt;
    for (std::size_t i = 0; i < all.size(); ++i)
        if (holds_file(all[i], wish.member)) return i;
    return all.empty() ? std::nullopt : std::optional<std::size_t>(0);
}

void remark_on_choice(const std::vector<Series>& all, std::size_t chosen, bool was_wished,
                      ReadRemarks& remarks) {
    const auto others = std::ranges::count_if(all, &Series::is_ct) - 1;
    bool told = false;
    for (std::size_t i = 0; i < all.size(); ++i) {
        if (i == chosen) continue;
        if (!all[i].is_ct()) {
            remarks.push_back("Left out " + text_of(all[i]));
            continue;
        }
        // Who chose by himself hears of the best of the others, once.
        if (was_wished && std::exchange(told, true)) continue;
        const std::string read = "Read " + text_of(all[chosen]) + " and left out ";
        const std::string number = ". On the command line --series " + std::to_string(i + 1);
        if (was_wished && others > 1) {
            remarks.push_back(read + std::to_string(others) +
                              " others as asked for, the best of them " + text_of(all[i]) + number +
                              " reads that one, and other numbers read the others.");
            continue;
        }
        const std::string why =
            was_wished ? "as asked for" : "because " + reason(all[chosen], all[i]);
        remarks.push_back(read + text_of(all[i]) + " " + why + number +
                          " reads the one that was left out.");
    }
}

}  // namespace

std::vector<SeriesDescription> describe_series(const std::vector<DicomSlice>& slices) {
    const std::vector<Series> all = ranked(slices);
    std::vector<SeriesDescription> list;
    for (const Series& series : all) {
        const DicomSlice& first = series.first();
        list.push_back({first.description, first.modality, series.images(), series.spacing_mm,
                        first.kernel, name_of(series.phase()),
                        list.empty() ? "" : reason(all.front(), series), middle_slice(series),
                        warnings_of(series)});
    }
    return list;
}

std::vector<DicomSlice> choose_series(std::vector<DicomSlice> slices, const SeriesWish& wish,
                                      const fs::path& folder, ReadRemarks& remarks) {
    const auto scouts = std::ranges::count_if(slices, &DicomSlice::localizer);
    if (scouts > 0) remarks.push_back("Left out " + std::to_string(scouts) + " scout images");
    std::vector<Series> all = ranked(slices);
    const std::optional<std::size_t> chosen = wished(all, wish);
    if (!chosen && wish.number != 0)
        throw InputError("holds " + std::to_string(all.size()) + " series and no number " +
                             std::to_string(wish.number),
                         folder.string(), "Give a number from 1, which is the best, on");
    if (!chosen || !all[*chosen].is_ct()) {
        std::string found;
        for (const Series& series : all) found += (found.empty() ? ": " : ", ") + text_of(series);
        throw InputError("holds no CT series" + found, folder.string(),
                         "Choose the folder of a contrast-enhanced CT");
    }
    // The named file may be a scout, which belongs to no series that can be read.
    const bool was_wished = wish.number != 0 || holds_file(all[*chosen], wish.member);
    remark_on_choice(all, *chosen, was_wished, remarks);
    return std::move(all[*chosen].slices);
}

}  // namespace hepatica
