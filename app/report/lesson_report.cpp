// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/report/lesson_report.h"

#include <QDateTime>
#include <QImage>
#include <QLocale>
#include <algorithm>
#include <cmath>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <utility>

#include "app/back_end_names.h"
#include "app/html_report.h"
#include "app/output_place.h"
#include "app/recorded_patient.h"
#include "app/report/frame_painter.h"
#include "app/report/page_printer.h"
#include "core/base/atomic_write.h"
#include "core/base/error.h"
#include "core/lesson/attempts.h"
#include "core/lesson/lesson_file.h"
#include "core/lesson/play_notes.h"
#include "core/lesson/score.h"
#include "core/scene/surface_anatomy.h"
#include "core/session/recording_file.h"
#include "core/session/script.h"
#include "render/chart.h"
#include "ui/core_words.h"
#include "ui/lesson_words.h"
#include "ui/paths.h"
#include "ui/plot_panel.h"
#include "ui/time_of_play.h"
#include "ui/words.h"

namespace hepatica {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

namespace {

// In the user's language; no line ends between a number and its unit.
QString in_words(const std::string& english) {
    return with_units_beside(translated(english));
}

QString in_words(Quantity quantity, double value, FlowUnits units = FlowUnits::computed) {
    return in_words(to_words(quantity, value, units));
}

// A moment shown as a picture.
struct Moment {
    double at_s;
    QString caption;
    Frame frame;
};

// Collects the moments before the beginning, at the largest force, at each step reached, and at the
// end.
class Moments {
  public:
    void see(const Frame& frame, const LessonStanding& standing) {
        if (list_.empty()) list_.push_back({0.0, Words::tr("Before the first step"), frame});
        const bool counts = standing.metrics.time_s > last_s_;
        if (!counts) return;
        last_s_ = standing.metrics.time_s;
        if (standing.metrics.peak_force_mn > peak_mn_) {
            peak_mn_ = standing.metrics.peak_force_mn;
            peak_ = Moment{last_s_,
                           Words::tr("The largest force: %1, after %2")
                               .arg(in_words(Quantity::force_mn, peak_mn_))
                               .arg(in_words(Quantity::time_s, last_s_)),
                           frame};
        }
        if (standing.step > step_ && list_.size() < most)
            list_.push_back({last_s_,
                             Words::tr("Step %1 reached, after %2")
                                 .arg(standing.step)
                                 .arg(in_words(Quantity::time_s, last_s_)),
                             frame});
        if (standing.step > step_) step_s_ = last_s_;
        step_ = standing.step;
        end_ =
            Moment{last_s_, Words::tr("The end, after %1").arg(in_words(Quantity::time_s, last_s_)),
                   frame};
    }
    // In the order of their times.
    std::vector<Moment> list() const {
        std::vector<Moment> all = list_;
        if (peak_) all.push_back(*peak_);
        std::ranges::stable_sort(all, {}, &Moment::at_s);
        if (end_ && step_s_ != last_s_) all.push_back(*end_);
        return all;
    }

  private:
    static constexpr std::size_t most = 8;
    std::vector<Moment> list_;
    std::optional<Moment> peak_, end_;
    double peak_mn_ = 0.0, last_s_ = 0.0, step_s_ = -1.0;  // step_s_: time of the last step reached
    std::size_t step_ = 0;
};

void save(const QImage& image, const fs::path& file) {
    if (!image.save(to_text(file), "PNG"))
        throw InputError("cannot be written", file.string(), "Choose a folder with room");
}

Chart chart_over_time(const std::vector<LessonSample>& samples, const std::string& title,
                      const std::string& unit, double (*value)(const LessonSample&)) {
    Chart chart{title, "Time (s)", unit, {Curve{title, {}, {}}}};
    for (const LessonSample& sample : samples) {
        chart.curves[0].x.push_back(sample.time_s);
        chart.curves[0].y.push_back(value(sample));
    }
    return chart;
}

void draw(const Chart& chart, const std::vector<PlotEvent>& events, const fs::path& file) {
    PlotView view;
    view.resize(900, 320);
    view.set_chart(chart);
    view.set_events(events);
    QImage image(view.size(), QImage::Format_RGB32);
    view.render(&image);
    save(image, file);
}

std::string key(const QString& words) {
    return words.toStdString();
}

// What a bound missed differs from it in the digits that are shown.
QString value_words(const BoundStanding& bound, FlowUnits units) {
    if (std::isnan(bound.value)) return Words::tr("not measured");
    if (bound.kept) return in_words(bound.predicate.quantity, bound.value, units);
    return in_words(to_words_beside(bound.predicate, bound.value, units));
}

Json table_of_bounds(const std::vector<BoundStanding>& bounds,
                     const std::vector<std::string>& marks, FlowUnits units, bool judged) {
    Json rows = Json::array();
    for (const BoundStanding& bound : bounds) {
        // Its quantity may have been measured all along, see the table of measures.
        const bool open = !judged && std::isnan(bound.value);
        const QString was = open ? QString::fromUtf8("–") : value_words(bound, units);
        const QString kept = !judged ? Words::tr("not judged: the lesson did not reach its end")
                             : bound.kept ? Words::tr("yes")
                                          : Words::tr("no");
        rows.push_back(
            {{key(Words::tr("Bound")), key(in_words(to_words(bound.predicate, marks, units)))},
             {key(Words::tr("Was")), key(was)},
             {key(Words::tr("Kept")), key(kept)}});
    }
    return rows;
}

// What the goal of a step came to: when it was reached, or in the end.
QString came_to(const LessonStanding& standing, std::size_t step, FlowUnits units) {
    if (step > standing.step) return Words::tr("not begun");
    QStringList values;
    for (const BoundStanding& goal :
         step < standing.step ? standing.steps[step].goal : standing.goal)
        values << value_words(goal, units);
    return values.join("; ");
}

Json table_of_steps(const LessonStanding& standing, const Lesson& lesson, FlowUnits units) {
    const std::vector<std::string> marks = lesson.mark_names();
    Json rows = Json::array();
    for (std::size_t i = 0; i < lesson.steps.size(); ++i) {
        const auto& reached = standing.steps[i].reached_s;
        const QString when = reached
                                 ? Words::tr("after %1").arg(in_words(Quantity::time_s, *reached))
                                 : Words::tr("no");
        QStringList goals;
        for (const Predicate& goal : lesson.steps[i].goal)
            goals << in_words(to_words(goal, marks, units));
        rows.push_back({{key(Words::tr("Step")), key(in_words(lesson.steps[i].text))},
                        {key(Words::tr("Goal")), key(goals.join("; "))},
                        {key(Words::tr("Came to")), key(came_to(standing, i, units))},
                        {key(Words::tr("Reached")), key(when)}});
    }
    return rows;
}

bool asks_for(const Lesson& lesson, Quantity quantity) {
    const auto names = [quantity](const std::vector<Predicate>& bounds) {
        return std::ranges::find(bounds, quantity, &Predicate::quantity) != bounds.end();
    };
    return names(lesson.limits) || names(lesson.pass) ||
           std::ranges::any_of(lesson.steps, [&](const LessonStep& step) {
               return names(step.goal) || names(step.limits);
           });
}

// Whether a quantity is worth a row: a value of zero is shown only if the lesson asks for it or its
// tools and scene allow other values.
bool means_something(Quantity quantity, double value, const Lesson& lesson) {
    if (asks_for(lesson, quantity)) return true;
    if (!std::isfinite(value)) return false;
    if (value != 0.0 || quantity <= Quantity::impulse_mn_s) return true;
    if (quantity <= Quantity::contact_s)
        return std::ranges::any_of(lesson.tools, [](LessonTool tool) {
            return tool >= LessonTool::sphere && tool <= LessonTool::hook;
        });
    return quantity <= Quantity::blood_lost_g && lesson.scene.tear;
}

Json table_of_metrics(const LessonMetrics& metrics, const Lesson& lesson, FlowUnits units) {
    Json rows = Json::array();
    for (const QuantityWords& words : quantities()) {
        if (words.quantity >= Quantity::step_time_s) break;
        const double value = value_of({words.quantity, -1, true, 0.0}, metrics, {}, 0.0);
        if (!means_something(words.quantity, value, lesson)) continue;
        // From a tip in the target all that runs back goes elsewhere: one number, one row.
        const bool repeats = words.quantity == Quantity::reflux_g && lesson.target &&
                             !asks_for(lesson, words.quantity) &&
                             in_words(words.quantity, value) ==
                                 in_words(Quantity::dose_elsewhere_g, metrics.dose_elsewhere_g);
        if (repeats) continue;
        rows.push_back({{key(Words::tr("Quantity")), key(translated(words.words))},
                        {key(Words::tr("Value")), key(in_words(words.quantity, value, units))}});
    }
    return rows;
}

// The lesson of a play: the one named, or the built-in one with the recorded scene, or none; with
// the pass marks of the course from which it was begun.
std::optional<Lesson> lesson_of_play(const ReportRequest& request, const Recording& recording) {
    return with_course_pass(request.lesson.empty() ? built_in_lesson_of(recording)
                                                   : std::optional(find_lesson(request.lesson)),
                            request.recording);
}

// A lesson whose one step is never reached, so that the whole play is measured.
Lesson free_play(const Recording& recording) {
    Lesson lesson;
    lesson.name = Words::id("Free play");
    lesson.scene = recording.scene;
    for (const LessonTool tool : {LessonTool::pull, LessonTool::sphere, LessonTool::capsule,
                                  LessonTool::forceps, LessonTool::hook, LessonTool::blade,
                                  LessonTool::cut_line, LessonTool::inject, LessonTool::settings})
        lesson.tools.push_back(tool);
    lesson.steps = {{"Play", "", {{Quantity::time_s, -1, true, 1e12}}, 0.0, {}}};
    return lesson;
}

struct Parts {
    const ReportRequest& request;
    const Lesson& lesson;
    bool free;
    const Score& scored;
    const PatientCase& patient;
    const Recording& recording;
    std::vector<PlayNote> notes;
    std::vector<std::pair<fs::path, std::string>> pictures;
    std::vector<std::pair<fs::path, std::string>> plots;
};

bool is_of_drug(const Parts& parts) {
    return parts.lesson.target || parts.scored.standing.metrics.injected_g > 0.0;
}

QString name_of_patient(const ReportRequest& request, const PatientCase& patient) {
    const std::string& name =
        request.patient_name.empty() ? patient.source.name : request.patient_name;
    return translated(name);
}

void add_who_and_when(HtmlReport& page, const Parts& parts) {
    const ReportRequest& request = parts.request;
    QStringList facts;
    if (!request.name.empty())
        facts << Words::tr("Played by %1").arg(QString::fromStdString(request.name));
    if (const QString patient = name_of_patient(request, parts.patient); !patient.isEmpty())
        facts << Words::tr("Patient: %1").arg(patient);
    const QDateTime played = time_of_play(request.recording);
    facts << (played.isValid()
                  ? Words::tr("Played on %1")
                        .arg(QLocale().toString(played, Words::tr("d MMMM yyyy, hh:mm")))
                  : Words::tr("Date unknown"));
    facts << "Hepatica " HEPATICA_VERSION;
    page.add_paragraph(key(facts.join(" · ")));
}

void add_verdict(HtmlReport& page, const Parts& parts) {
    const LessonStanding& standing = parts.scored.standing;
    const std::vector<std::string> marks = parts.lesson.mark_names();
    const FlowUnits units = parts.request.units;
    page.add_paragraph(key(interrupted_beside(parts.request.recording)
                               ? Words::tr("Interrupted before the end")
                           : standing.outcome == LessonOutcome::passed ? Words::tr("PASSED.")
                                                                       : Words::tr("NOT PASSED.")));
    for (const std::string& reason : reasons_in(standing, marks, units))
        page.add_paragraph(key(in_words(reason)));
    if (const QString left = drug_on_its_way(standing, parts.lesson, units); !left.isEmpty())
        page.add_paragraph(key(with_units_beside(left)));
    if (!parts.lesson.about.empty()) page.add_paragraph(key(in_words(parts.lesson.about)));
    page.add_heading(key(Words::tr("Steps")));
    page.add_table(table_of_steps(standing, parts.lesson, units));
    if (!standing.limits.empty()) page.add_heading(key(Words::tr("Limits")));
    if (!standing.limits.empty())
        page.add_table(table_of_bounds(standing.limits, marks, units, true));
    // Pass marks are judged only if the end was reached.
    const bool reached = standing.step == parts.lesson.steps.size();
    if (!standing.pass.empty()) page.add_heading(key(Words::tr("Pass marks")));
    if (!standing.pass.empty())
        page.add_table(table_of_bounds(standing.pass, marks, units, reached));
}

// What an instructor noted at moments of the play.
void add_notes(HtmlReport& page, const std::vector<PlayNote>& notes) {
    if (notes.empty()) return;
    Json rows = Json::array();
    for (const PlayNote& note : notes)
        rows.push_back({{key(Words::tr("After")), key(in_words(Quantity::time_s, note.at_s))},
                        {key(Words::tr("Noted")), note.text}});
    page.add_heading(key(Words::tr("Notes of the instructor")));
    page.add_table(rows);
}

QString legend_of_pictures(const Parts& parts) {
    QStringList sentences{Words::tr("From the front, without perspective.")};
    if (!parts.lesson.marks.empty()) sentences << Words::tr("Circles: the lesson's marks.");
    if (parts.lesson.target) sentences << Words::tr("Purple: the target of the drug.");
    if (is_of_drug(parts))
        sentences << Words::tr("Brown to yellow: what the drug has reached, the earliest darkest.")
                  << Words::tr("Dull pink: what an earlier injection had reached.");
    return sentences.join(" ");
}

void add_what_was_played(HtmlReport& page, const Parts& parts) {
    // Reading warns of nothing else; its own words name the file, whose name may name the patient.
    if (!parts.recording.warnings.empty())
        page.add_paragraph(
            key(Words::tr("The recording is cut short: this is about what is left of it, which may "
                          "not be the whole play.")));
    if (!parts.free) add_verdict(page, parts);
    add_notes(page, parts.notes);
    page.add_heading(key(Words::tr("Metrics")));
    page.add_table(
        table_of_metrics(parts.scored.standing.metrics, parts.lesson, parts.request.units));
    page.add_heading(key(Words::tr("Over time")));
    for (const auto& [file, caption] : parts.plots) page.add_picture(file, caption);
    page.add_heading(key(Words::tr("Pictures")));
    page.add_paragraph(key(legend_of_pictures(parts)));
    if (parts.scored.standing.metrics.blood_lost_g > 0.0)
        page.add_paragraph(key(Words::tr("Red balls: blood, a tenth of the volume lost.")));
    for (const auto& [file, caption] : parts.pictures) page.add_picture(file, caption);
}

HtmlReport page_of(const Parts& parts) {
    HtmlReport page("Hepatica: " + key(translated(parts.lesson.name)), parts.request.language);
    add_who_and_when(page, parts);
    if (parts.recording.steps.empty())
        page.add_paragraph(key(Words::tr("Nothing was played.")));
    else
        add_what_was_played(page, parts);
    page.add_paragraph(key(
        Words::tr("For training and research alone: no diagnosis, no treatment, no certificate.")));
    return page;
}

// Adds a picture of each moment, all of the same box.
void write_pictures(Parts& parts, const Moments& moments, const LessonRun& places,
                    const fs::path& folder, Job& job) {
    FramePainting painting;
    const bool moves = parts.lesson.scene.deform.has_value();
    const VesselTree& tree = parts.patient.tree;
    const SurfaceAnatomy anatomy(
        tree, moves ? parts.patient.mesh.vertices_mm : parts.patient.surface.vertices_mm, job);
    painting.systems = anatomy.vertex_systems();
    if (const std::optional<ScriptPlace>& target = parts.lesson.target)
        painting.target = anatomy.downstream_of(nearest_point(tree, position_of(*target, tree)));
    int number = 0;
    for (const Moment& moment : moments.list()) {
        if (number == 0) painting.box_mm = box_of(moment.frame);
        painting.marks_mm = places.marks_in(moment.frame);
        const fs::path name = "picture_" + std::to_string(++number) + ".png";
        save(paint(moment.frame, painting), folder / name);
        parts.pictures.emplace_back(name, key(moment.caption));
    }
}

// The shares of the vessels that the drug has reached.
Chart chart_of_drug(const std::vector<LessonSample>& samples, bool target) {
    const char* title = Words::id("Vessels that the drug has reached");
    const char* unit = Words::id("Share (%)");
    Chart chart = chart_over_time(samples, title, unit,
                                  [](const LessonSample& s) { return 100.0 * s.elsewhere_filled; });
    if (!target) return chart;
    chart.curves[0].name = Words::id("The rest");
    chart.curves.insert(
        chart.curves.begin(),
        chart_over_time(samples, Words::id("The target"), unit, [](const LessonSample& s) {
            return 100.0 * s.target_filled;
        }).curves[0]);
    return chart;
}

std::vector<Chart> charts_of(const Parts& parts) {
    const std::vector<LessonSample>& samples = parts.scored.samples;
    std::vector<Chart> charts;
    if (is_of_drug(parts))
        charts.push_back(chart_of_drug(samples, parts.lesson.target.has_value()));
    // Where nothing but a drug was used, the vessels are at rest.
    if (!is_of_drug(parts) || parts.scored.standing.metrics.peak_force_mn > 0.0) {
        charts.push_back(chart_over_time(samples, Words::id("Force"), Words::id("Force (mN)"),
                                         [](const LessonSample& s) { return s.force_mn; }));
        charts.push_back(chart_over_time(
            samples, Words::id("Largest stretch beyond rest"), Words::id("Stretch (%)"),
            [](const LessonSample& s) { return 100.0 * (s.stretch - 1.0); }));
    }
    if (parts.lesson.scene.tear)
        charts.push_back(chart_over_time(samples, Words::id("Bleeding"),
                                         Words::id("Bleeding (g/s)"),
                                         [](const LessonSample& s) { return s.leak_g_s; }));
    return charts;
}

// Adds the curves over time, as pictures and as one table.
void write_plots(Parts& parts, const fs::path& folder) {
    std::string table;
    for (const Chart& chart : charts_of(parts)) {
        const fs::path name = "plot_" + std::to_string(parts.plots.size() + 1) + ".png";
        draw(bleeding_in_units(chart, parts.request.units), plot_events_of(parts.scored.standing),
             folder / name);
        parts.plots.emplace_back(name, key(translated(chart.title)));
        table += to_csv(chart);
    }
    write_text_atomically(folder / "plots.csv", table);
}

// The copy of the recording must not take the place of another one: plays may be kept in the
// folder.
void require_no_other_recording(const ReportRequest& request) {
    const fs::path copy = request.out / "recording.hrec";
    std::error_code ignored;
    const bool of_a_report = fs::exists(request.out / "report.html", ignored);
    if (of_a_report || !fs::exists(copy, ignored) ||
        fs::equivalent(copy, request.recording, ignored))
        return;
    throw InputError(Words::id("holds another play, and would be replaced"), copy.string(),
                     Words::id("Choose another name, or take the file away"));
}

}  // namespace

WrittenReport write_report(const ReportRequest& request, Job& job) {
    require_writable_folder(request.out);
    require_no_other_recording(request);
    const Recording recording = read_recording(request.recording);
    const std::vector<PlayNote> notes = read_notes(request.recording);
    const std::optional<Lesson> played = lesson_of_play(request, recording);
    const Lesson lesson = played.value_or(free_play(recording));
    constexpr int replaying_and_writing = 3;
    // Free play and the lessons of the program name no case.
    const auto patient = std::make_shared<const PatientCase>(recorded_patient(
        recording, request.recording, case_of_lesson(lesson, request.lesson, request.patient),
        &request.cache, replaying_and_writing, job));
    Moments moments;
    std::optional<LessonRun> places;
    places.emplace(lesson, patient);
    const Score scored = score(
        recording, lesson, patient, job, back_end_named(recording.back_end),
        [&](const Frame& frame, const LessonStanding& standing) { moments.see(frame, standing); });
    job.begin_stage(Words::id("Drawing pictures"));
    fs::create_directories(request.out);
    const bool nothing_played = recording.steps.empty();
    WrittenReport written;
    if (!nothing_played) written.passed = scored.standing.outcome == LessonOutcome::passed;
    written.warnings = recording.warnings;
    write_files_atomically(request.out, [&](const fs::path& folder) {
        Parts parts{request, lesson, !played, scored, *patient, recording, notes, {}, {}};
        if (!nothing_played) {
            write_pictures(parts, moments, *places, folder, job);
            write_plots(parts, folder);
            write_text_atomically(folder / "metrics.csv", to_csv(scored.standing.metrics));
        }
        fs::copy_file(request.recording, folder / "recording.hrec");
        if (!notes.empty()) write_notes(folder / "recording.hrec", notes);
        const HtmlReport page = page_of(parts);
        page.write(folder / "report.html");
        print_pdf(page.text(), folder, folder / "report.pdf");
        for (const fs::directory_entry& entry : fs::directory_iterator(folder))
            written.files.push_back(request.out / entry.path().filename());
    });
    // Those of an earlier report there would be taken for notes on this play.
    if (notes.empty()) fs::remove(notes_file_of(request.out / "recording.hrec"));
    return written;
}

}  // namespace hepatica
