// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/case_shelf.h"

#include <QPainter>
#include <QPainterPath>
#include <algorithm>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <system_error>
#include <vector>

#include "core/base/error.h"
#include "core/base/hash.h"
#include "core/flow/flow_shares.h"
#include "core/lesson/attempts.h"
#include "core/patient/corrections.h"
#include "core/patient/patient_case.h"
#include "core/tree/system_summary.h"
#include "render/palette.h"
#include "ui/colours.h"
#include "ui/core_words.h"
#include "ui/paths.h"
#include "ui/patient_place.h"
#include "ui/window_words.h"
#include "ui/words.h"

namespace hepatica {

namespace fs = std::filesystem;

namespace {

constexpr QSize drawing_size(180, 150);
constexpr double margin_points = 8.0;
constexpr double thinnest_points = 1.2;

// Attempts at lessons by the patient hash in their recordings.
using AttemptsOfPatients = std::map<std::string, std::vector<Attempt>>;

std::string patient_of(const fs::path& recording) {
    std::error_code unreadable;
    if (!fs::is_regular_file(recording, unreadable)) return {};
    std::ifstream in(recording);
    std::string header;
    std::getline(in, header);
    const auto json = nlohmann::json::parse(header, nullptr, false);
    const auto hash = json.is_object() ? json.find("patient_hash") : json.end();
    return hash != json.end() && hash->is_string() ? hash->get<std::string>() : std::string();
}

AttemptsOfPatients attempts_by_patient(const fs::path& recordings) {
    AttemptsOfPatients found;
    for (Attempt& attempt : all_attempts(recordings).list)
        if (!was_interrupted(attempt))
            found[patient_of(attempt.recording)].push_back(std::move(attempt));
    return found;
}

QString sentence_of(const std::vector<Attempt>& attempts) {
    const auto passed = std::ranges::count_if(attempts, &Attempt::passed);
    return Words::tr("%n attempt(s) at lessons, %1 passed; the last: %2, %3", nullptr,
                     static_cast<int>(attempts.size()))
        .arg(passed)
        .arg(translated(attempts.back().lesson).toHtmlEscaped(),
             attempts.back().passed ? Words::tr("passed") : Words::tr("not passed"));
}

// What is told when the case is opened, in the same order.
std::vector<std::string> warnings_of(const PatientCase& patient) {
    std::vector<std::string> warnings = warnings_of_ends(patient.tree, flow_shares(patient.tree));
    for (const auto& list :
         {patient.warnings, doubts_of_links(patient), sentences(patient.doubts, patient.tree)})
        for (const std::string& warning : list) warnings.push_back(in_window_words(warning));
    return warnings;
}

QString facts_of(const PatientCase& patient, const AttemptsOfPatients& attempts) {
    QStringList lines;
    for (const SystemSummary& system : systems_of(patient.tree))
        lines << Words::tr("%1: %L2 mm, %n root(s)", nullptr, static_cast<int>(system.roots.size()))
                     .arg(translated(title_of(system.system)))
                     .arg(system.length_mm, 0, 'f', 0);
    lines << Words::tr("%n branch(es)", nullptr, static_cast<int>(patient.tree.segments.size()));
    for (const std::string& warning : warnings_of(patient))
        lines << "• " + places_in_words(translated(warning)).toHtmlEscaped();
    const auto played = attempts.find(to_hex(hash_of(patient)));
    if (played != attempts.end()) lines << sentence_of(played->second);
    return lines.join("<br>");
}

ShelvedCase shelved(const fs::path& place, const AttemptsOfPatients& attempts,
                    const std::vector<ShelvedLesson>& lessons) {
    ShelvedCase entry{place, to_text(place.stem()), {}, {}, false};
    entry.lessons = lessons_of(lessons, place);
    try {
        const PatientCase patient = read_case_without_voxels(place);
        entry.drawing = drawing_of(patient.tree, drawing_size);
        entry.facts = facts_of(patient, attempts);
        compare_with(patient.tree, place, entry.lessons);
        entry.readable = true;
    } catch (const InputError& error) {
        entry.facts = Words::tr("It cannot be opened: %1. %2")
                          .arg(translated(error.problem()).toHtmlEscaped(),
                               translated(error.remedy()).toHtmlEscaped());
    }
    return entry;
}

}  // namespace

QImage drawing_of(const VesselTree& tree, const QSize& size) {
    QImage image(size, QImage::Format_ARGB32_Premultiplied);
    image.fill(Qt::transparent);
    Vec3 lower = Vec3::Constant(1e30), upper = -lower;
    for (const VesselSegment& segment : tree.segments)
        for (const Vec3& p : segment.points_mm) {
            lower = lower.cwiseMin(p);
            upper = upper.cwiseMax(p);
        }
    if (tree.segments.empty()) return image;
    // Seen from the front: the patient's left is on the right, his head at the top.
    const Vec3 extent = (upper - lower).cwiseMax(1.0);
    const double scale = std::min((size.width() - 2.0 * margin_points) / extent.x(),
                                  (size.height() - 2.0 * margin_points) / extent.z());
    const Vec3 middle = 0.5 * (lower + upper);
    const auto place = [&](const Vec3& p) {
        return QPointF(0.5 * size.width() + scale * (p.x() - middle.x()),
                       0.5 * size.height() - scale * (p.z() - middle.z()));
    };
    QPainter painter(&image);
    painter.setRenderHint(QPainter::Antialiasing);
    for (const VesselSegment& segment : tree.segments) {
        const QColor ink = qcolor_of(palette::vessel_system(segment.system));
        for (std::size_t i = 1; i < segment.points_mm.size(); ++i) {
            const double width = std::max(thinnest_points, 2.0 * scale * segment.radii_mm[i]);
            painter.setPen(QPen(ink, width, Qt::SolidLine, Qt::RoundCap));
            painter.drawLine(place(segment.points_mm[i - 1]), place(segment.points_mm[i]));
        }
    }
    return image;
}

std::vector<ShelvedCase> cases_in(const fs::path& folder, const fs::path& recordings, Job& job) {
    job.begin_stage(Words::id("Reading the cases"));
    std::error_code failed;
    std::vector<fs::path> places;
    for (fs::directory_iterator entry(folder, failed), end; !failed && entry != end;
         entry.increment(failed))
        if (is_case(entry->path())) places.push_back(entry->path());
    if (failed)
        throw InputError(Words::tr("cannot be read: %1")
                             .arg(QString::fromStdString(failed.message()))
                             .toStdString(),
                         folder.string(), Words::id("Choose another folder"));
    std::ranges::sort(places);
    const AttemptsOfPatients attempts = attempts_by_patient(recordings);
    const std::vector<ShelvedLesson> lessons = lessons_in(folder, job);
    std::vector<ShelvedCase> cases;
    for (const fs::path& place : places) {
        job.throw_if_cancelled();
        cases.push_back(shelved(place, attempts, lessons));
        job.advance(static_cast<double>(cases.size()) / static_cast<double>(places.size()));
    }
    return cases;
}

}  // namespace hepatica
