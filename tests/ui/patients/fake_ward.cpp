// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/ui/patients/fake_ward.h"

#include <QCoreApplication>
#include <QTest>
#include <chrono>
#include <thread>

#include "core/base/error.h"
#include "core/tree/editing/tree_edit.h"

namespace hepatica::testing {

void need_event_loop() {
    static int count = 1;
    static char name[] = "patients_tests";
    static char* names[] = {name, nullptr};
    static QCoreApplication application(count, names);
}

TreeEdit edit(int number) {
    TreeEdit edit;
    edit.kind = TreeEditKind::cut_link;
    edit.at_mm = Vec3(number, 0, 0);
    return edit;
}

std::vector<int> numbers_of(const std::vector<TreeEdit>& edits) {
    std::vector<int> numbers;
    for (const TreeEdit& one : edits) numbers.push_back(static_cast<int>(one.at_mm.x()));
    return numbers;
}

FakeWard::FakeWard() {
    need_event_loop();
    PatientKeeper::Questions answers;
    answers.unsaved = [this](const std::string& title) {
        ++questions;
        if (on_question) on_question(title);
        return answer;
    };
    answers.strokes = [this](const std::string&, std::size_t strokes) {
        strokes_asked.push_back(strokes);
        return strokes_answer;
    };
    answers.changed_on_disk = [this](const std::filesystem::path& place) {
        changed_asked.push_back(place.filename().string());
        return changed_answer;
    };
    answers.where_to_save =
        [this](const std::filesystem::path& to) -> std::optional<std::filesystem::path> {
        ++places_asked;
        proposed = to;
        if (!place) return std::nullopt;
        return path_of(*place);
    };
    answers.which_series = [this](const std::vector<SeriesDescription>&) {
        ++series_asked;
        return series;
    };
    PatientKeeper::Screen screen;
    screen.show = [this](LoadedPatient patient, bool corrected) {
        if (before_show) before_show(corrected);
        shown.push_back(corrected ? "+" : patient.title);
    };
    screen.changed = [] {};
    screen.failed = [this](const std::string& doing, const Failure& failure) {
        failures.push_back(doing + ": " + failure.problem);
        if (on_word) on_word();
    };
    screen.say = [this](const std::string& text) {
        said.push_back(text);
        if (on_word) on_word();
    };
    screen.remember = [](const std::filesystem::path&) {};
    screen.case_written = [this](const std::filesystem::path& place) {
        written.push_back(place.filename().string());
    };
    screen.remake_painted = [this] { remake_painted(); };
    keeper_ = std::make_unique<PatientKeeper>(
        ways(), std::move(answers), std::move(screen),
        JobQueue::Watcher{[this](const std::string& title) { titles.push_back(title); },
                          [](const JobProgress&) {}, [] {}});
}

bool FakeWard::finish() {
    return QTest::qWaitFor([this] { return !keeper_->jobs().busy(); }, 20000);
}

std::filesystem::path FakeWard::path_of(const std::string& name) {
    return "/disk/" + name;
}

void FakeWard::open(const std::string& name) {
    OpenRequest request;
    request.reconstruct.ct = path_of(name);
    keeper_->open(request);
}

void FakeWard::open_built_in() {
    keeper_->open(OpenRequest{true, {}});
}

std::string FakeWard::digest(const std::string& name) const {
    return digest_at(path_of(name));
}

std::string FakeWard::digest_at(const std::filesystem::path& place) const {
    const std::lock_guard lock(mutex_);
    const auto found = disk_.find(place);
    return found == disk_.end() ? "" : "of " + edits_to_json(found->second.corrections.edits);
}

bool FakeWard::disk_holds(const std::string& name) const {
    const std::lock_guard lock(mutex_);
    return disk_.contains(path_of(name));
}

std::vector<int> FakeWard::on_disk(const std::string& name) const {
    return numbers_of(edits_on_disk(name));
}

std::vector<TreeEdit> FakeWard::edits_on_disk(const std::string& name) const {
    const std::lock_guard lock(mutex_);
    return disk_.at(path_of(name)).corrections.edits;
}

void FakeWard::save_by_another(const std::string& name, const std::vector<TreeEdit>& edits) {
    const std::lock_guard lock(mutex_);
    disk_[path_of(name)].corrections.edits = edits;
}

void FakeWard::remove_by_another(const std::string& name) {
    const std::lock_guard lock(mutex_);
    disk_.erase(path_of(name));
}

void FakeWard::hold(const std::atomic<bool>& held, Job& job) const {
    job.begin_stage("work");
    if (slowness_us > 0) std::this_thread::sleep_for(std::chrono::microseconds(slowness_us));
    while (held) {
        std::this_thread::sleep_for(std::chrono::microseconds(200));
        job.throw_if_cancelled();
    }
    job.advance(1.0);
}

LoadedPatient FakeWard::load(const OpenRequest& request, Job& job) {
    hold(hold_openings, job);
    LoadedPatient loaded;
    const std::filesystem::path& path = request.reconstruct.ct;
    loaded.title = request.built_in ? "built-in" : path.filename().string();
    PatientCase patient;
    patient.mask = Mask(Grid{{1, 1, 1}}, 1);
    if (!request.built_in && loaded.title.starts_with("ct")) {
        loaded.image = path;
        if (const int chosen = request.reconstruct.series; chosen != 0)
            loaded.title += ", series " + std::to_string(chosen);
        loaded.worth_saving = true;
    } else if (request.unsaved_copy) {
        loaded.kept_copy = path;
        loaded.worth_saving = true;
    } else if (!request.built_in) {
        const std::lock_guard lock(mutex_);
        if (!disk_.contains(path)) throw InputError("there is no such case", path.string(), "");
        patient = disk_.at(path);
        loaded.folder = path;
    }
    loaded.patient = std::make_shared<const PatientCase>(std::move(patient));
    return loaded;
}

PatientKeeper::Ways FakeWard::ways() {
    PatientKeeper::Ways ways;
    ways.load = [this](const OpenRequest& request, Job& job) { return load(request, job); };
    ways.list_series = [](const OpenRequest& request, Job&) -> std::vector<SeriesDescription> {
        const bool two = request.reconstruct.ct.filename().string().starts_with("ct of two");
        if (!two || request.reconstruct.series != 0) return {};
        return {2, SeriesDescription{}};
    };
    ways.look = [](const OpenRequest&, Job&) {};  // what cannot be opened shows when it is read
    // As write_case(): without a job, so that nothing cancels it half-way.
    ways.save = [this](const std::filesystem::path& folder, const PatientCase& patient) {
        Job unheard;
        hold(hold_saves, unheard);
        if (disk_full) throw InputError("the disk is full", folder.string(), "");
        const std::lock_guard lock(mutex_);
        disk_[folder] = patient;
    };
    ways.digest = [this](const std::filesystem::path& place) { return digest_at(place); };
    ways.correct = [this](const PatientCase& patient, const std::vector<TreeEdit>& edits,
                          Job& job) {
        ++corrections_begun;
        hold(hold_corrections, job);
        PatientCase corrected = patient;
        corrected.corrections.edits = edits;
        return corrected;
    };
    ways.offers = [this](const PatientCase&, const std::vector<TreeEdit>& edits, double, Job& job) {
        offers_asked = edits;
        hold(hold_offers, job);
        return offered;
    };
    ways.remake = [this](const PatientCase& patient, Mask vessels, const Volume&, Job& job) {
        hold(hold_remakings, job);
        if (vessels.voxels.empty()) throw InputError("no vessel is left", "", "");
        RemadeCase made{patient, {}};
        made.patient.mask = std::move(vessels);
        std::erase_if(made.patient.corrections.edits,
                      [](const TreeEdit& edit) { return edit.at_mm.x() >= 100; });
        return made;
    };
    ways.archive = [this](const PatientCase& patient, const std::filesystem::path& ct,
                          const std::filesystem::path& file, Job& job) {
        hold(hold_archiving, job);
        if (disk_full) throw InputError("the disk is full", file.string(), "");
        const std::lock_guard lock(mutex_);
        archived.push_back(ct.string() + " to " + file.string() + " with " +
                           std::to_string(patient.corrections.edits.size()));
    };
    ways.check = [](const PatientCase&, const std::vector<TreeEdit>& edits) {
        for (const int number : numbers_of(edits))
            if (number < 0) throw InputError("cannot be made", std::to_string(number), "");
    };
    ways.play_on = [](std::shared_ptr<const PatientCase> patient, Job&) {
        LoadedPatient loaded;
        loaded.patient = std::move(patient);
        return loaded;
    };
    return ways;
}

}  // namespace hepatica::testing
