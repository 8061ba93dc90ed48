// SPDX-License-Identifier: GPL-3.0-or-later
// A report never takes the place of another, and one that is cancelled leaves nothing.
#include "ui/report_writing.h"

#include <gtest/gtest.h>
#include <sys/resource.h>

#include <QImage>
#include <QTemporaryDir>
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string>
#include <thread>
#include <vector>

#include "app/report/page_printer.h"
#include "core/base/error.h"
#include "tests/patient/parted_patient.h"
#include "ui/paths.h"

namespace hepatica {
namespace {

namespace fs = std::filesystem;

class ReportWriting : public ::testing::Test {
  protected:
    // Stands in for the program; gets the folder as its fourth argument.
    QString program(const std::string& does) {
        const fs::path file = folder() / "program";
        std::ofstream(file) << "#!/bin/sh\n" << does << "\n";
        fs::permissions(file, fs::perms::owner_all);
        return to_text(file);
    }
    fs::path folder() const { return to_path(temporary_.path()); }
    std::size_t count() const {
        return static_cast<std::size_t>(
            std::distance(fs::directory_iterator(folder()), fs::directory_iterator()));
    }

    QTemporaryDir temporary_;
    Job job_;
};

TEST_F(ReportWriting, EachGetsAFolderOfItsOwn) {
    const QDateTime played(QDate(2026, 11, 26), QTime(3, 40));
    const fs::path first = report_folder(folder(), "Sanfter Zug", played);
    EXPECT_EQ(first.filename(), "Sanfter Zug 2026-11-26 03-40");
    fs::create_directories(first);
    const fs::path second = report_folder(folder(), "Sanfter Zug", played);
    EXPECT_EQ(second.filename(), "Sanfter Zug 2026-11-26 03-40 (2)");
    fs::create_directories(folder() / "50%2 2026-11-26 03-40");
    EXPECT_EQ(report_folder(folder(), "50%2", played).filename(), "50%2 2026-11-26 03-40 (2)");
    EXPECT_EQ(report_folder(folder(), "../a/b: c?", played), folder() / "a b c 2026-11-26 03-40");
    EXPECT_EQ(report_folder(folder(), "", played).filename(), "2026-11-26 03-40");
}

TEST_F(ReportWriting, PassesTheProgressOnAndAppearsWhole) {
    const QString tool = program(
        "echo '{\"stage\": \"Replaying\", \"fraction\": 0.5, \"number\": 1, \"count\": 1}'\n"
        "echo done > \"$4/report.html\"");
    order_report(tool, {}, folder() / "report", job_);
    EXPECT_TRUE(fs::exists(folder() / "report" / "report.html"));
    EXPECT_EQ(job_.progress().stage, "Replaying");
    EXPECT_EQ(job_.progress().fraction, 0.5);
    EXPECT_EQ(count(), 2u);
}

// One bar of the whole, which never goes back to an earlier stage.
TEST_F(ReportWriting, ItsStagesAreThoseOfTheProcessAndSoIsTheirCount) {
    const auto line = [](const char* stage, double fraction, int number) {
        return "echo '{\"stage\": \"" + std::string(stage) +
               "\", \"fraction\": " + std::to_string(fraction) +
               ", \"number\": " + std::to_string(number) + ", \"count\": 4}'\n";
    };
    std::vector<double> shares;
    job_.observe([&](JobEvent event) {
        const JobProgress now = job_.progress();
        if (event != JobEvent::progress || now.stage_number == 0) return;
        EXPECT_EQ(now.stage_count, 4);
        shares.push_back((now.stage_number - 1 + now.fraction) / now.stage_count);
    });
    order_report(program(line("Reading the case", 0.0, 1) + line("Building the scene", 0.0, 2) +
                         line("Building the scene", 1.0, 2) + line("Replaying", 0.0, 3) +
                         line("Replaying", 0.5, 3) + "echo done > \"$4/report.html\""),
                 {}, folder() / "report", job_);
    ASSERT_FALSE(shares.empty());
    EXPECT_TRUE(std::ranges::is_sorted(shares));
    EXPECT_NEAR(shares.back(), 2.5 / 4.0, 1e-12);
}

// A lesson that is played meanwhile would be slow. But the system gives a process of nice 15 a
// thirtieth of what it gives another: on a machine with more to do a report of half a minute took
// a quarter of an hour.
TEST_F(ReportWriting, LetsThePlayGoFirstAndDoesNotStarve) {
    order_report(program("nice > \"$4/niceness\""), {}, folder() / "report", job_);
    int of_report = 0;
    std::ifstream(folder() / "report" / "niceness") >> of_report;
    const int own = ::getpriority(PRIO_PROCESS, 0);
    EXPECT_GE(of_report, std::min(19, own + 3));
    EXPECT_LE(of_report, own + 6);
}

TEST_F(ReportWriting, SaysWhyItFailedAndLeavesNothing) {
    const QString tool = program("echo half > \"$4/report.html\"\necho no room >&2\nexit 1");
    try {
        order_report(tool, {}, folder() / "report", job_);
        FAIL();
    } catch (const InputError& error) {
        EXPECT_EQ(error.problem(), "no room");
    }
    EXPECT_EQ(count(), 1u);
}

// As one does that the system ends for want of memory.
TEST_F(ReportWriting, SaysSoWhereItEndedWithoutAWord) {
    try {
        order_report(program("exit 1"), {}, folder() / "report", job_);
        FAIL();
    } catch (const InputError& error) {
        EXPECT_TRUE(error.problem().find("without a word") != std::string::npos) << error.problem();
        EXPECT_NE(error.remedy(), "");
    }
}

// His case may have been saved with other vessels while it waited, or may never have been saved.
TEST_F(ReportWriting, GivesTheProcessACopyOfWhoWasPlayed) {
    const auto played = std::make_shared<const PatientCase>(test::patient_with_bridges());
    const QString tool = program(
        "while [ \"$1\" != --patient ]; do shift; done\n"
        "cp -r \"$2\" '" +
        (folder() / "given.hep").string() + "'");
    ReportOrder order;
    order.patient = played;
    order_report(tool, order, folder() / "report", job_);
    EXPECT_EQ(hash_of(read_case(folder() / "given.hep")), hash_of(*played));
}

// Of the voxels only the organs, which may be obstacles, and all of the rest.
TEST_F(ReportWriting, GivesTheProcessALightCopy) {
    PatientCase played = test::patient_with_bridges();
    Grid grid;
    grid.dims = {6, 5, 4};
    for (Mask* voxels : {&played.mask, &played.skeleton, &played.organs}) *voxels = Mask(grid, 1);
    played.source.name = "Nr. 7";
    played.doubts = doubts_of(played.tree);
    played.warnings = {"of the image", "of the vessels"};
    played.warnings_of_image = 1;
    played.measured = {
        KeptMeasurement{MeasurementKind::distance, {Vec3(1, 2, 3), Vec3(4, 5, 6)}, {}}};
    played.corrections.rebuilt = {Rebuilding{0, 2}};
    const QString tool = program(
        "while [ \"$1\" != --patient ]; do shift; done\n"
        "cp -r \"$2\" '" +
        (folder() / "given.hep").string() + "'");
    ReportOrder order;
    order.patient = std::make_shared<const PatientCase>(played);
    order_report(tool, order, folder() / "report", job_);
    const PatientCase given = read_case(folder() / "given.hep");
    EXPECT_TRUE(given.mask.voxels.empty() && given.skeleton.voxels.empty());
    EXPECT_EQ(given.organs.voxels, played.organs.voxels);
    EXPECT_EQ(hash_of(given), hash_of(played));
    EXPECT_EQ(given.source.name, played.source.name);
    EXPECT_EQ(given.surface.triangles, played.surface.triangles);
    EXPECT_EQ(given.corrections.bridges.size(), played.corrections.bridges.size());
    EXPECT_EQ(given.corrections.rebuilt, played.corrections.rebuilt);
    EXPECT_TRUE(given.doubts.has_value());
    EXPECT_EQ(given.warnings, played.warnings);
    EXPECT_EQ(given.warnings_of_image, 1u);
    EXPECT_EQ(given.measured, played.measured);
}

TEST_F(ReportWriting, ACancelEndsTheProcessAndLeavesNothing) {
    const QString tool = program(
        "echo half > \"$4/report.html\"\n"
        "echo '{\"stage\": \"Replaying\", \"fraction\": 0.5, \"number\": 1, \"count\": 1}'\n"
        "read answer");  // which never comes
    std::thread user([this] {
        while (job_.progress().stage != "Replaying") std::this_thread::yield();
        job_.cancel();
    });
    EXPECT_THROW(order_report(tool, {}, folder() / "report", job_), Cancelled);
    user.join();
    EXPECT_EQ(count(), 1u);
}

// Wherever the end of a page comes.
TEST_F(ReportWriting, APlotStaysOnOnePageWithItsCaption) {
    QImage plot(600, 300, QImage::Format_RGB32);
    plot.fill(Qt::gray);
    ASSERT_TRUE(plot.save(to_text(folder() / "plot.png")));
    int pages = 0;
    for (int lines = 0; lines < 60; ++lines) {
        std::string html = "<html><body><h1>Report</h1>";
        for (int line = 0; line < lines; ++line) html += "<p>A line</p>";
        html +=
            "<h2>Over time</h2><figure><img src=\"plot.png\" alt=\"\"><figcaption>The force over "
            "time</figcaption></figure></body></html>";
        const auto found = printed_pages(html, folder()).pictures;
        ASSERT_EQ(found.size(), 1u);
        EXPECT_EQ(found[0].picture, found[0].caption) << lines;
        pages = std::max(pages, found[0].caption);
    }
    EXPECT_GE(pages, 1) << "there was an end of a page among them";
}

// With pictures as wide as the text nearly half of a page came to be white.
TEST_F(ReportWriting, NoPageButTheLastIsLeftHalfEmpty) {
    QImage picture(1100, 780, QImage::Format_RGB32), plot(900, 320, QImage::Format_RGB32);
    picture.fill(Qt::gray);
    plot.fill(Qt::lightGray);
    ASSERT_TRUE(picture.save(to_text(folder() / "picture.png")));
    ASSERT_TRUE(plot.save(to_text(folder() / "plot.png")));
    const auto figures = [](const char* file, int count) {
        std::string html;
        for (int i = 0; i < count; ++i)
            html += std::string("<figure><img src=\"") + file +
                    "\" alt=\"\"><figcaption>A caption</figcaption></figure>";
        return html;
    };
    for (int lines = 0; lines <= 44; lines += 11) {
        std::string html = "<html><body><h1>Report</h1>";
        for (int line = 0; line < lines; ++line) html += "<p>A line</p>";
        html += "<h2>Over time</h2>" + figures("plot.png", 2);
        html += "<h2>Pictures</h2><p>From the front.</p>" + figures("picture.png", 5);
        const PrintedPages pages = printed_pages(html + "</body></html>", folder());
        EXPECT_LT(pages.largest_white, 0.3) << lines;
        ASSERT_EQ(pages.pictures.size(), 7u);
        for (const PrintedPages::OfPicture& one : pages.pictures)
            EXPECT_EQ(one.picture, one.caption) << lines;
    }
}

TEST_F(ReportWriting, APdfIsWholeOrSaidNotToBe) {
    const std::string html = "<html><body><h1>Report</h1></body></html>";
    const fs::path file = folder() / "report.pdf";
    print_pdf(html, folder(), file);
    std::ifstream in(file, std::ios::binary);
    const std::string made{std::istreambuf_iterator<char>(in), {}};
    EXPECT_TRUE(made.starts_with("%PDF-"));
    EXPECT_NE(made.rfind("%%EOF"), std::string::npos);
    EXPECT_THROW(print_pdf(html, folder(), file / "report.pdf"), InputError);
}

}  // namespace
}  // namespace hepatica
