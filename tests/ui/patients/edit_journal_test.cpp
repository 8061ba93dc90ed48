// SPDX-License-Identifier: GPL-3.0-or-later
// The file of a journal of corrections: what is read of a damaged one, and how it goes on after a
// full disk.
#include "ui/edit_journal.h"

#include <gtest/gtest.h>
#include <sys/resource.h>

#include <QTemporaryDir>
#include <QTest>
#include <chrono>
#include <csignal>
#include <cstdint>
#include <fstream>

#include "core/base/quoted_name.h"
#include "core/base/text_file.h"
#include "tests/session/small_patient.h"
#include "tests/ui/patients/fake_ward.h"
#include "ui/recovery.h"

namespace hepatica {
namespace {

namespace fs = std::filesystem;

// Lets no file grow beyond this size, as a full disk does.
class SmallDisk {
  public:
    explicit SmallDisk(std::uintmax_t most_bytes) {
        ::getrlimit(RLIMIT_FSIZE, &before_);
        rlimit small = before_;
        small.rlim_cur = static_cast<rlim_t>(most_bytes);
        ::setrlimit(RLIMIT_FSIZE, &small);
    }
    ~SmallDisk() {
        ::setrlimit(RLIMIT_FSIZE, &before_);
        std::signal(SIGXFSZ, handler_);
    }
    SmallDisk(const SmallDisk&) = delete;
    SmallDisk& operator=(const SmallDisk&) = delete;

  private:
    rlimit before_{};
    void (*handler_)(int) = std::signal(SIGXFSZ, SIG_IGN);
};

class JournalFile : public ::testing::Test {
  protected:
    static Journalled state(std::uint64_t change, std::vector<int> edits) {
        Journalled state{{"anton.hep", "/data/anton.hep", 7}, {}, {}, change};
        for (const int edit : edits) state.edits.push_back(testing::edit(edit));
        return state;
    }
    static void note(const Journalled& state, EditJournal& journal) {
        journal.append(state);
        journal.wait_until_written();
    }
    JournalLoss loss() const {
        JournalLoss loss{JournalLoss::Kind::read, 99};
        read_edit_journal(file_, &loss);
        return loss;
    }
    void add(const std::string& text) { std::ofstream(file_, std::ios::app) << text; }

    QTemporaryDir temporary_;
    const fs::path file_ = fs::path(temporary_.path().toStdString()) / "edits.jsonl";
};

TEST_F(JournalFile, IsReadUpToATornLineAndFromTheNextBase) {
    const Journalled whole = state(2, {1, 2});
    {
        EditJournal journal(file_);
        note(state(1, {1}), journal);
        note(whole, journal);
    }
    EXPECT_EQ(loss(), JournalLoss{});
    add(R"({"change": 9, "keep": 2, "add": [{"ed)");
    EXPECT_EQ(read_edit_journal(file_), whole);
    EXPECT_EQ(loss(), (JournalLoss{JournalLoss::Kind::end, 4}));
    add("\n{\"change\": 10, \"keep\": 0, \"add\": []}\n");
    EXPECT_EQ(read_edit_journal(file_), whole) << "what stands behind damage is not believed";
    EXPECT_EQ(loss(), (JournalLoss{JournalLoss::Kind::line, 4})) << "and named";
    add(R"({"format": "hepatica-edits", "version": 1, "title": "berta.hep", )"
        R"("case": "", "extracted": "0"})"
        "\n");
    EXPECT_EQ(read_edit_journal(file_), whole);
    add("{\"change\": 11, \"keep\": 0, \"add\": []}\n");
    EXPECT_EQ(read_edit_journal(file_), (Journalled{{"berta.hep", "", 0}, {}, {}, 11}))
        << "it begins anew";
    EXPECT_EQ(loss(), JournalLoss{}) << "nothing of the newest state is missing";
}

// With the work that is offered, and where it is missing.
TEST_F(JournalFile, ThatIsDamagedIsToldOf) {
    {
        EditJournal journal(file_);
        note(state(1, {1}), journal);
    }
    const auto lost = [this] { return Recovery::unsaved_work(file_).request.lost; };
    EXPECT_EQ(lost(), "");
    add(R"({"change": 2, "keep": 1, "ad)");
    EXPECT_NE(lost().find("The last change"), std::string::npos) << lost();
    add("\n");
    EXPECT_NE(lost().find("line 3"), std::string::npos) << lost();
    EXPECT_NE(lost().find(file_.string()), std::string::npos) << lost();
    // Where the journal is of no use the copy beside it is offered.
    add("\n");
    const fs::path copy = file_.parent_path() / "1" / "anton.hep";
    EXPECT_NE(Recovery::unsaved_work(copy).request.lost.find("line 3"), std::string::npos);
}

TEST_F(JournalFile, ThatCannotBeReadIsNamed) {
    EXPECT_EQ(loss(), JournalLoss{}) << "there is none";
    fs::create_directory(file_);
    EXPECT_FALSE(read_edit_journal(file_));
    EXPECT_EQ(loss(), (JournalLoss{JournalLoss::Kind::read, 1}));
}

TEST_F(JournalFile, WithoutABaseHoldsNothing) {
    EXPECT_FALSE(read_edit_journal(file_)) << "there is none";
    add(R"({"format": "hepatica-edits", "version": 1)");
    EXPECT_FALSE(read_edit_journal(file_));
}

TEST_F(JournalFile, GoesOnAfterALineThatWasCutOff) {
    EditJournal journal(file_);
    const Journalled first = state(1, {1});
    note(first, journal);
    ASSERT_EQ(read_edit_journal(file_), first);
    const std::uintmax_t whole = fs::file_size(file_);
    Journalled later = state(2, {1, 2});
    later.strokes = {{{{Vec3(1, 0, 0), Vec3(1, 1, 0)}, 2.0, false}, 2}};
    {
        const SmallDisk full(whole + 10);
        note(later, journal);
    }
    EXPECT_TRUE(journal.failed());
    EXPECT_EQ(loss().kind, JournalLoss::Kind::end);
    EXPECT_EQ(fs::file_size(file_), whole + 10) << "a part of the line is there";
    EXPECT_EQ(read_edit_journal(file_), first);
    note(later, journal);
    EXPECT_FALSE(journal.failed());
    EXPECT_EQ(read_edit_journal(file_), later) << "though nothing was changed since";
    EXPECT_EQ(loss(), JournalLoss{});
    later.edits.push_back(testing::edit(3));
    later.change = 3;
    note(later, journal);
    EXPECT_EQ(read_edit_journal(file_), later);
}

KeptMeasurement distance(double to_mm) {
    return {MeasurementKind::distance, {Vec3::Zero(), Vec3(0, 0, to_mm)}};
}

// Each line says only what has changed.
TEST_F(JournalFile, HoldsWhatWasMeasured) {
    EditJournal journal(file_);
    Journalled now = state(1, {1});
    now.measured = {distance(1), {MeasurementKind::diameter, {Vec3::Zero(), Vec3(0, 3, 0)}, 0.25}};
    note(now, journal);
    EXPECT_EQ(read_edit_journal(file_), now);
    now.measured->push_back(distance(5));
    now.change = 2;
    note(now, journal);
    EXPECT_EQ(read_edit_journal(file_), now);
    now.measured->erase(now.measured->begin());
    now.change = 3;
    note(now, journal);
    EXPECT_EQ(read_edit_journal(file_), now);
    const std::uintmax_t before = fs::file_size(file_);
    now.edits.push_back(testing::edit(2));
    now.change = 4;
    note(now, journal);
    EXPECT_EQ(read_edit_journal(file_), now);
    const std::string line = read_text_file(file_, "").substr(before);
    EXPECT_NE(line.find("add"), std::string::npos);
    EXPECT_EQ(line.find("measured"), std::string::npos) << line;
    now.measured->clear();
    now.change = 5;
    note(now, journal);
    EXPECT_EQ(read_edit_journal(file_), now) << "that all were removed is said, too";
}

TEST_F(JournalFile, BeginsItsMeasurementsAnewAfterALineThatWasCutOff) {
    EditJournal journal(file_);
    Journalled now = state(1, {});
    now.measured = {distance(1), distance(2)};
    note(now, journal);
    const std::uintmax_t whole = fs::file_size(file_);
    now.measured->push_back(distance(3));
    now.change = 2;
    {
        const SmallDisk full(whole + 10);
        note(now, journal);
    }
    ASSERT_TRUE(journal.failed());
    note(now, journal);
    EXPECT_EQ(read_edit_journal(file_), now);
}

// As programs wrote them that noted no measurements: those of the case hold.
TEST_F(JournalFile, OfAnOlderProgramSaysNothingOfMeasurements) {
    add(R"({"format": "hepatica-edits", "version": 1, "title": "anton.hep", )"
        R"("case": "/data/anton.hep", "extracted": "7"})"
        "\n{\"change\": 3, \"keep\": 0, \"add\": []}\n");
    const auto read = read_edit_journal(file_);
    ASSERT_TRUE(read);
    EXPECT_EQ(*read, state(3, {}));
    EXPECT_FALSE(read->measured);
}

// Lines behind a measurement that nobody could have made are not believed.
TEST_F(JournalFile, RefusesMeasurementsThatAreDamaged) {
    const Journalled whole = state(1, {1});
    const std::string none =
        R"({"format": "hepatica-measurements", "version": 1, "measurements": []})";
    const auto read_with = [&](const std::string& measured) {
        fs::remove(file_);
        {
            EditJournal journal(file_);
            note(whole, journal);
        }
        add(R"({"change": 2, "keep": 1, "add": [], )" + measured + "}\n");
        return read_edit_journal(file_);
    };
    Journalled next = whole;
    next.change = 2;
    next.measured.emplace();
    EXPECT_EQ(read_with(R"("keep_measured": 0, "add_measured": )" + none), next);
    for (const std::string& damaged :
         {R"("keep_measured": 1, "add_measured": )" + none, R"("add_measured": )" + none,
          std::string(R"("keep_measured": 0, "add_measured": [])")})
        EXPECT_EQ(read_with(damaged), whole) << damaged;
}

// No copy of the case holds a stroke, and no later change tells of it.
TEST_F(JournalFile, IsToldOfWhereItCouldNotTakeTheLastStroke) {
    testing::need_event_loop();
    OpenedPatient opened;
    opened.title = "a.hep";
    opened.folder = "/disk/a.hep";
    opened.patient = test::small_patient();
    Workspace workspace;
    workspace.open(opened);
    workspace.add_stroke({{Vec3(1, 0, 0), Vec3(1, 1, 0)}, 2.0, false});
    std::vector<Failure> failures;
    Recovery program(fs::path(temporary_.path().toStdString()) / "kept", write_case,
                     [&](const Failure& one) { failures.push_back(one); });
    {
        const SmallDisk full(0);
        program.follow(workspace);
        ASSERT_TRUE(QTest::qWaitFor([&] { return !failures.empty(); }, 60000));
    }
    EXPECT_EQ(failures[0].problem, "corrections cannot be noted at once");
}

// A program was killed after it had taken over what another one had left.
TEST_F(JournalFile, OfWorkThatANewerOneHoldsIsListedOnceAndGoesWithThat) {
    testing::need_event_loop();
    const fs::path folder = fs::path(temporary_.path().toStdString()) / "kept";
    const auto leave = [&](const char* program, const Journalled& state, int minutes_ago) {
        const fs::path file = folder / program / "edits.jsonl";
        fs::create_directories(file.parent_path());
        {
            EditJournal journal(file);
            note(state, journal);
        }
        fs::last_write_time(file,
                            fs::file_time_type::clock::now() - std::chrono::minutes(minutes_ago));
        return file;
    };
    leave("first", state(1, {1}), 3);
    const fs::path second = leave("second", state(5, {1, 2}), 2);
    const fs::path other = leave("other", state(2, {3}), 1);
    Recovery recovery(
        folder, [](const fs::path&, const PatientCase&) {}, [](const Failure&) {});
    EXPECT_EQ(recovery.left_behind(), (std::vector<fs::path>{other, second}));
    OpenedPatient opened;
    opened.title = "anton.hep";
    opened.patient = test::small_patient();
    opened.kept_copy = second;
    Workspace workspace;
    workspace.open(opened);
    workspace.saved("/data/anton.hep", workspace.edits(), {});
    recovery.follow(workspace);
    EXPECT_EQ(recovery.left_behind(), std::vector<fs::path>{other}) << "the first has gone, too";
}

// The name of a file may have 255 bytes, to which that of a case would add some.
TEST(KeptCopy, IsMadeOfACtWithTheLongestName) {
    testing::need_event_loop();
    const QTemporaryDir temporary;
    const fs::path folder = fs::path(temporary.path().toStdString()) / "kept";
    OpenedPatient opened;
    opened.title = "x";
    for (int i = 0; i < 125; ++i) opened.title += "ä";
    opened.title += ".nii";
    opened.patient = test::small_patient();
    opened.worth_saving = true;
    Workspace workspace;
    workspace.open(opened);
    std::vector<Failure> failures;
    const auto failed = [&](const Failure& one) { failures.push_back(one); };
    {
        Recovery crashed(folder, write_case, failed);
        crashed.follow(workspace);
        ASSERT_TRUE(QTest::qWaitFor([&] { return crashed.resting(); }, 60000));
    }
    EXPECT_TRUE(failures.empty());
    const auto left = Recovery(folder, write_case, failed).left_behind();
    ASSERT_EQ(left.size(), 1u);
    EXPECT_TRUE(is_utf8(left[0].filename().string())) << "no letter is cut in two";
}

}  // namespace
}  // namespace hepatica
