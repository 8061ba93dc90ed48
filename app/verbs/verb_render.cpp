// SPDX-License-Identifier: GPL-3.0-or-later
// render: a picture of a case or of a recorded play, without a display
// (render/offscreen_picture.h).
#include <spdlog/spdlog.h>

#include <cmath>
#include <cstdio>
#include <filesystem>
#include <limits>
#include <optional>

#include "app/back_end_choice.h"
#include "app/case_picture.h"
#include "app/output_place.h"
#include "app/verbs/flow_options.h"
#include "app/verbs/verbs.h"
#include "core/base/error.h"
#include "core/flow/injection.h"
#include "core/opening/ct_around_liver.h"
#include "core/opening/patient_image.h"
#include "core/patient/corrections.h"
#include "core/patient/liver_segments.h"
#include "core/patient/painted_tumours.h"
#include "core/patient/patient_case.h"
#include "core/scene/flow_part.h"
#include "core/scene/world.h"
#include "core/session/recording_file.h"
#include "core/session/replay.h"
#include "core/session/session.h"
#include "render/offscreen_picture.h"
#include "render/organ_surface.h"
#include "render/picture.h"

namespace hepatica {

namespace {

struct RenderChoices {
    std::filesystem::path patient;
    std::filesystem::path recording;
    std::filesystem::path out;
    std::optional<double> time_s;
    std::string at_mm;
    double mass_flow_g_s = default_injection::mass_flow_g_s;
    std::string view = "anterior";
    std::string size = "1280,960";
    double turn_right_deg = 0.0;
    double turn_up_deg = 0.0;
    double zoom = 1.0;
    bool bare = false;
    bool segments = false;
    bool liver = false;
    std::filesystem::path ct;
    std::string ct_as{name_of(VolumeLook{}.preset)};
    double ct_density = VolumeLook{}.density;
    std::string ct_window;
};

VolumeLook volume_look(const RenderChoices& options) {
    VolumeLook look;
    const std::optional<VolumePreset> preset = volume_preset_named(options.ct_as);
    if (!preset)
        throw UsageError("a CT cannot be drawn as \"" + options.ct_as + "\"", "--ct-as",
                         "choose vessels-and-bones or maximum-intensity");
    look.preset = *preset;
    if (!(options.ct_density >= 0.0 && options.ct_density <= 1.0))
        throw UsageError("the density is not from 0 to 1", "--ct-density",
                         "0 is hardly there, 1 nearly solid");
    look.density = options.ct_density;
    char rest = 0;
    GreyWindow& window = look.window;
    if (!options.ct_window.empty() &&
        (std::sscanf(options.ct_window.c_str(), "%16lf,%16lf%c", &window.level_hu, &window.width_hu,
                     &rest) != 2 ||
         !std::isfinite(window.level_hu) || !(window.width_hu >= 1.0) ||
         !std::isfinite(window.width_hu)))
        throw UsageError("\"" + options.ct_window + "\" is no grey window", "--ct-window",
                         "write level,width in Hounsfield units, as 100,300, the width 1 or more");
    return look;
}

PictureOptions picture_options(const RenderChoices& options) {
    PictureOptions picture;
    const std::optional<ViewDirection> view = view_direction_named(options.view);
    if (!view)
        throw UsageError("there is no view \"" + options.view + "\"", "--view",
                         "choose anterior, posterior, left, right, superior or inferior");
    picture.view = *view;
    char rest = 0;
    if (std::sscanf(options.size.c_str(), "%6d%*1[,x]%6d%c", &picture.width, &picture.height,
                    &rest) != 2)
        throw UsageError("\"" + options.size + "\" is no size", "--size",
                         "write width,height in pixels, as 1280,960");
    if (picture.width < 1 || picture.height < 1 || picture.width > largest_picture_px ||
        picture.height > largest_picture_px)
        throw UsageError("a picture of " + options.size + " pixels cannot be made", "--size",
                         "choose 1 to " + std::to_string(largest_picture_px) + " pixels each way");
    if (!(options.zoom > 0.0))
        throw UsageError("the zoom is not above 0", "--zoom", "1 shows all of the tree");
    picture.turn_right_deg = options.turn_right_deg;
    picture.turn_up_deg = options.turn_up_deg;
    picture.zoom = options.zoom;
    picture.annotations = !options.bare;
    picture.ct_look = volume_look(options);
    return picture;
}

// Where the drug is injected: the given place, or the same root as by `inject`.
Vec3 injection_point(const RenderChoices& options, const VesselTree& tree) {
    if (options.at_mm.empty())
        return tree.segments[static_cast<std::size_t>(main_root(tree).segment)].points_mm.front();
    const auto [x, y, z] = parse_triple("--at-mm", options.at_mm);
    point_of_vessel("--at-mm", {x, y, z}, tree);
    return {x, y, z};
}

// The case at rest, with the drug as far as it has come after time_s.
std::unique_ptr<Session> still_life(const RenderChoices& options,
                                    const std::shared_ptr<const PatientCase>& patient, Job& job) {
    SceneSpec scene = default_scene();
    scene.deform.reset();
    auto session = std::make_unique<Session>(patient, scene, job);
    if (options.time_s) {
        InjectDrug injection;
        injection.point_mm = injection_point(options, patient->tree);
        injection.mass_flow_g_s = options.mass_flow_g_s;
        session->post(injection);
        session->post(PlayDrug{false});
        session->post(SetDrugTime{*options.time_s});
    }
    session->step(job);
    return session;
}

// A recorded play up to time_s, or to its end.
std::unique_ptr<Session> played(const RenderChoices& options, const Recording& recording,
                                const std::shared_ptr<const PatientCase>& patient, Job& job) {
    if (hash_of(*patient) != recording.patient_hash)
        throw InputError("the recording was made on another patient", options.recording.string(),
                         "give the case that it was made on");
    for (const std::string& warning : recording.warnings) spdlog::warn("{}", warning);
    auto session = std::make_unique<Session>(patient, recording.scene, job,
                                             choose_back_end(recording.back_end).back_end);
    if (recording.begin) restore_recorded(*session, *recording.begin);
    session->record([](const RecordedStep&) {});  // hashes are computed only while recording
    const double end_s = options.time_s.value_or(std::numeric_limits<double>::infinity());
    bool diverged = false;
    for (std::size_t i = 0; i < recording.steps.size(); ++i) {
        if (session->world().time_s() >= end_s) break;
        job.throw_if_cancelled();
        for (const Command& command : recording.steps[i].commands) session->post(command);
        if (session->step(job).state_hash == recording.steps[i].state_hash || diverged) continue;
        diverged = true;
        spdlog::warn("{} diverged from the recording at step {}: the picture may be another",
                     options.recording.string(), i + 1);
    }
    if (options.time_s && session->world().time_s() < end_s)
        spdlog::warn("{} ends at {:.3g} s: the picture shows its end", options.recording.string(),
                     session->world().time_s());
    return session;
}

TriangleMesh liver_of_case(const RenderChoices& options, const PatientCase& patient, Job& job) {
    TriangleMesh liver = organ_surface(liver_of(patient.organs), organ_label::liver, job);
    if (liver.triangles.empty())
        throw InputError("the case knows no liver", options.patient.string(),
                         "leave --liver out, or reconstruct with --liver-mask");
    return liver;
}

std::shared_ptr<const Volume> ct_of_case(const RenderChoices& options, const PatientCase& patient,
                                         Job& job) {
    const Volume ct = image_of(patient, options.ct, job);
    auto drawn = std::make_shared<const Volume>(
        ct_around_liver(ct, patient, organ_voxels(patient, options.patient), job));
    if (drawn->voxels.empty())
        throw InputError("the CT holds nothing of this patient's liver", options.ct.string(),
                         "leave --ct out, or give the CT that the case was made of");
    return drawn;
}

Json run_render(const RenderChoices& options, Job& job) {
    PictureOptions picture = picture_options(options);
    require_png_name(options.out);
    require_writable_file(options.out, ".png");
    job.expect_stages(options.ct.empty() ? 3 : 4);
    job.begin_stage("Reading the case");
    auto patient = std::make_shared<const PatientCase>(
        options.segments || options.liver ? read_case(options.patient)
                                          : read_case_without_voxels(options.patient));
    const std::unique_ptr<Session> session =
        options.recording.empty()
            ? still_life(options, patient, job)
            : played(options, read_recording(options.recording), patient, job);
    session->update_frame();
    const Frame& frame = session->frame();
    // Messages of a recorded play's steps do not prevent the picture.
    if (options.recording.empty() && !frame.statistics.message.empty())
        throw InputError(frame.statistics.message, options.patient.string(),
                         "check the options of the injection");
    if (!options.ct.empty()) picture.ct = ct_of_case(options, *patient, job);
    job.begin_stage("Drawing");
    colour_vessels(session->world(), *patient, options.segments, picture);
    picture.bridges = views_of(open_gaps(*patient));
    picture.caption = patient->source.name;
    if (options.liver) picture.liver = liver_of_case(options, *patient, job);
    if (may_hold_tumours(*patient))
        picture.tumours =
            tumour_surface(tumour_voxels(organ_voxels(*patient, options.patient)), job);
    const OffscreenPicture drawn = draw_frame(frame, picture);
    write_png(options.out, drawn.picture);
    return {{"renderer", drawn.renderer},
            {"file", options.out.string()},
            {"size", {drawn.picture.width, drawn.picture.height}}};
}

}  // namespace

void add_render(CommandLine& line) {
    auto options = std::make_shared<RenderChoices>();
    CLI::App& verb = line.add_verb("render", "A picture of a case, without any display",
                                   [options](Job& job) { return run_render(*options, job); });
    verb.add_option("case", options->patient, "Case folder (NAME.hep)")->required();
    verb.add_option("--out", options->out, "Picture to write, NAME.png")->required();
    CLI::Option* recording =
        verb.add_option("--recording", options->recording, "Show this recorded play");
    CLI::Option* time =
        verb.add_option("--time-s", options->time_s,
                        "Time: of the drug since its injection, or of the recorded play [s]")
            ->check(CLI::Range(0.0, 1e9));
    verb.add_option("--at-mm", options->at_mm, "Inject here, X,Y,Z in LPS [mm]; else at the root")
        ->needs(time)
        ->excludes(recording);
    verb.add_option("--mass-flow-g-s", options->mass_flow_g_s, "Of the injection [g/s]")
        ->needs(time)
        ->excludes(recording);
    verb.add_option("--view", options->view,
                    "anterior, posterior, left, right, superior or inferior");
    verb.add_option("--turn-right-deg", options->turn_right_deg, "Turned away from the view");
    verb.add_option("--turn-up-deg", options->turn_up_deg, "Turned away from the view");
    verb.add_option("--zoom", options->zoom, "1: all of the tree fits");
    verb.add_option("--size", options->size, "WIDTH,HEIGHT in pixels");
    verb.add_flag("--segments", options->segments,
                  "Colour portal branches by the liver segment that they supply");
    verb.add_flag("--liver", options->liver, "Show the surface of the liver around the vessels");
    CLI::Option* ct = verb.add_option(
        "--ct", options->ct, "Draw this CT, that of the case, as a volume around the vessels");
    verb.add_option("--ct-as", options->ct_as, "vessels-and-bones or maximum-intensity")->needs(ct);
    verb.add_option("--ct-density", options->ct_density, "How dense, 0 to 1")->needs(ct);
    verb.add_option("--ct-window", options->ct_window,
                    "LEVEL,WIDTH [HU]: below it the CT is clear, above it dense")
        ->needs(ct);
    verb.add_flag("--bare", options->bare, "Without legend, scale bar and orientation");
}

}  // namespace hepatica
