// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/paper/paper_page.h"

#include <cstdio>
#include <utility>
#include <vector>

#include "app/album.h"
#include "app/html_report.h"
#include "app/paper/skeleton_frame.h"
#include "app/paper/tear_figure.h"
#include "core/base/error.h"
#include "core/flow/injection.h"
#include "core/scene/surface_anatomy.h"
#include "core/scene/world.h"
#include "core/session/session.h"
#include "core/skeleton/unit_width_skeleton.h"

namespace hepatica {
namespace {

using Json = nlohmann::ordered_json;
using Shown = std::vector<std::pair<std::filesystem::path, std::string>>;

constexpr int width = 960, height = 720;

std::vector<VascularSystem> systems_of(const PatientCase& patient,
                                       const std::vector<Vec3>& vertices_mm, Job& job) {
    return SurfaceAnatomy(patient.tree, vertices_mm, job).vertex_systems();
}

Album album_of(const std::filesystem::path& folder, PictureOptions options) {
    options.width = width;
    options.height = height;
    return Album(folder, std::move(options));
}

void show(HtmlReport& page, const std::vector<AlbumPicture>& pictures) {
    Shown shown;
    for (const AlbumPicture& picture : pictures) shown.emplace_back(picture.file, picture.caption);
    page.add_pictures(shown);
}

Json reconstruction(const PatientCase& patient, const std::filesystem::path& folder,
                    HtmlReport& page, Job& job) {
    job.begin_stage("Drawing model and skeleton");
    Frame model;
    for (const Vec3& vertex : patient.surface.vertices_mm)
        for (const double coordinate : vertex)
            model.positions_mm.push_back(static_cast<float>(coordinate));
    model.topology_version = 1;
    model.surface =
        std::make_shared<const std::vector<std::array<int, 3>>>(patient.surface.triangles);
    Album album = album_of(folder, {});
    PictureOptions options = album.options();
    options.vertex_systems = systems_of(patient, patient.surface.vertices_mm, job);
    options.caption = "(a)";
    album.add(model, options, "fig1_a_model", "(a) The model reconstructed from CT.");
    const SkeletonFrame skeleton = frame_of_skeleton(patient.skeleton);
    options.vertex_systems = systems_of(patient, skeleton.vertices_mm, job);
    options.caption = "(b)";
    album.add(skeleton.frame, options, "fig1_b_skeleton",
              "(b) Its skeleton, one voxel wide: a bead is a voxel.");
    const Json facts{{"skeleton voxels", skeleton.voxels},
                     {"of them removable", removable_point_count(patient.skeleton)},
                     {"segments", patient.tree.segments.size()},
                     {"bifurcations", bifurcation_count(patient.tree)},
                     {"length mm", length_mm(patient.tree)},
                     {"tetrahedra", patient.mesh.tetrahedra.size()}};
    page.add_heading("Fig. 1: Hepatic vessel reconstruction");
    page.add_paragraph(
        "The paper shows (a) the 3-D model from CT images and (b) the unit-width skeleton of the "
        "vessel tree; it prints no figures. Seen from the front.");
    show(page, album.pictures());
    page.add_table(facts);
    return facts;
}

Json injection(const std::shared_ptr<const PatientCase>& patient,
               const std::filesystem::path& folder, HtmlReport& page, Job& job) {
    SceneSpec scene = default_scene();
    scene.deform.reset();
    Session session(patient, scene, job);
    job.begin_stage("Drawing the drug");
    InjectDrug drug;
    drug.point_mm = point_on_longest_path(patient->tree, 0.0);
    session.post(drug);
    session.post(FinishInjection{});
    session.post(PlayDrug{false});
    session.step(job);
    session.update_frame();
    const double end_s = session.frame().drug.end_s;
    Album album = album_of(folder, {});
    PictureOptions options = album.options();
    options.vertex_systems = systems_of(*patient, session.world().rest_positions_mm(), job);
    char letter = 'a';
    for (const int percent : drug_moments_percent) {
        session.post(SetDrugTime{end_s * percent / 100.0});
        session.step(job);
        session.update_frame();
        options.caption = std::string("(") + letter + ")";
        char text[80];
        std::snprintf(text, sizeof text, "(%c) %.3g s after the injection began.", letter,
                      end_s * percent / 100.0);
        album.add(session.frame(), options, std::string("fig2_") + letter, text);
        ++letter;
    }
    const Json facts{{"mass flow g/s", drug.mass_flow_g_s},
                     {"drug", drug.second_phase},
                     {"pressure law", drug.pressure_model},
                     {"most vessels reached after s", end_s}};
    page.add_heading("Fig. 2: Drug injection in four discrete time steps");
    page.add_paragraph(
        "Violet or blue: blood; orange to yellow: the drug, by its time of arrival; white: its "
        "front. The paper prints neither the times nor the flow of its figure.");
    show(page, album.pictures());
    page.add_table(facts);
    return facts;
}

// What touches what in rows of this kind.
std::string touching(const std::string& kind) {
    if (kind == "tool") return "tool against slab";
    return kind == "vessels" ? "vessel along vessel" : "block on slab";
}

Json row_of(const ContactRow& row) {
    return {{"kind", touching(row.kind)},
            {"contact points", row.contacts},
            {"constraints", row.rows},
            {"as the paper counts", row.rows_as_published()},
            {"tetrahedra", row.tetrahedra},
            {"step ms", row.step_ms},
            {"in time", row.in_time ? "yes" : "no"}};
}

Json contacts(const PaperOptions& options, HtmlReport& page, Job& job) {
    const std::vector<ContactRow> rows = study_contacts(options.contact, job);
    Json table = Json::array(), measured = Json::array();
    table.push_back({{"where", "paper, Quadro FX 4600"},
                     {"contact points in real time", 128},
                     {"constraints", 768}});
    table.push_back({{"where", "paper, Xeon 3.00 GHz alone"},
                     {"contact points in real time", 8},
                     {"constraints", 48}});
    for (const char* kind : {"tool", "vessels", "self"}) {
        const ContactRow most = most_in_time(rows, kind);
        table.push_back({{"where", "here, processor, " + touching(kind)},
                         {"contact points in real time", most.contacts},
                         {"constraints", most.rows_as_published()}});
    }
    for (const ContactRow& row : rows) measured.push_back(row_of(row));
    page.add_heading("Contact points in real time");
    char text[400];
    std::snprintf(
        text, sizeof text,
        "Six constraints a point, as the paper counts (48 of the processor's 8 points by "
        "the same rule). Here a point of a tool has three rows and a pair of surfaces "
        "one. In time is a median step of at most %.1f ms on %d threads; of each kind the "
        "first row that is not ends the measurement.",
        options.contact.budget_ms, options.contact.threads);
    page.add_table(table);
    page.add_paragraph(text);
    page.add_table(measured);
    return measured;
}

Json tear(const std::shared_ptr<const PatientCase>& patient, const std::filesystem::path& folder,
          const PaperOptions& options, HtmlReport& page, Job& job) {
    const TearFigure figure = play_tear_figure(patient, options.cut_line, job);
    job.begin_stage("Drawing the tear");
    Album album = album_of(folder, {.fitted_box_mm = figure.box_mm});
    PictureOptions picture = album.options();
    picture.vertex_systems = systems_of(*patient, patient->mesh.vertices_mm, job);
    char letter = 'a';
    for (const TearMoment& moment : figure.moments) {
        picture.caption = std::string("(") + letter + ")";
        picture.lines = moment.lines;
        picture.circles = moment.circles;
        album.add(moment.frame, picture, std::string("fig3_") + letter++, moment.words);
    }
    page.add_heading("Fig. 3: Tearing along a cut line");
    page.add_paragraph(
        "As in the paper: the red line is the curvature of the pulled vessel, the yellow circles "
        "show where its surface tore; a section is removed along cut lines set beforehand. Wine: "
        "torn rims; flesh: what was inside; the turquoise bead: the hand. The paper prints no "
        "figures; ours follow.");
    show(page, album.pictures());
    const AlbumPicture force = album.add(figure.force, "fig3_force");
    page.add_picture(
        force.file,
        "The force of the hand over time, with the four moments. It falls as a section "
        "comes apart, and rises again because the tissue around holds what hangs on.");
    const TearReport& end = figure.moments.back().tear;
    const Json facts{{"largest force of the hand N", 1e-6 * figure.force_max_un},
                     {"energy of fracture mJ", 1e-6 * figure.work_nj},
                     {"joints parted", end.joints_parted},
                     {"joints broken", end.joints_broken},
                     {"pieces", end.pieces},
                     {"most entropy produced nats", figure.entropy_produced_max_nats},
                     {"mass error relative", figure.body_mass_error_relative}};
    page.add_table(facts);
    return facts;
}

}  // namespace

Json write_paper(const std::shared_ptr<const PatientCase>& patient,
                 const std::filesystem::path& folder, const PaperOptions& options, Job& job) {
    if (patient->skeleton.voxels.empty() || patient->mesh.tetrahedra.empty())
        throw InputError("has no skeleton or no body", "the case",
                         "Reconstruct the patient from CT");
    HtmlReport page("The paper's results on " + options.title);
    page.add_paragraph(
        "Real-time Rendering of Drug Injection and Interactive Simulation of Vessel Deformation "
        "Using GPU: its figures and its table made anew, ours beside what it prints. Its \"over 20 "
        "fold\" by the GPU is not measured here.");
    Json facts;
    facts["fig_1"] = reconstruction(*patient, folder, page, job);
    facts["fig_2"] = injection(patient, folder, page, job);
    facts["contacts"] = contacts(options, page, job);
    facts["fig_3"] = tear(patient, folder, options, page, job);
    page.write(folder / "index.html");
    return facts;
}

}  // namespace hepatica
