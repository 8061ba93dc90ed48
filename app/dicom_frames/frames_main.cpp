// SPDX-License-Identifier: GPL-3.0-or-later
// hepatica-dicom-frames FILE FOLDER: splits an enhanced multi-frame CT, or a segmentation, into
// classic CT slices frame_000001.dcm and so on, which core/image reads like any others. It is a
// separate program, which core/image/dicom_frames.cpp starts under limits of memory and time,
// because its library parses files from untrusted sources. On failure it writes two lines to
// standard error: the problem and the remedy.
#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dctk.h>
#include <dcmtk/oflog/oflog.h>

#include <array>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <functional>
#include <new>
#include <string>

#include "app/dicom_frames/frame_headers.h"
#include "app/dicom_frames/frame_pixels.h"
#include "app/dicom_frames/refusal.h"
#include "app/dicom_frames/segment_pixels.h"

namespace hepatica::dicom_frames {

namespace {

namespace fs = std::filesystem;

constexpr Uint32 longest_in_memory = 4096;  // longer values stay in the file until needed

// Writes the slices one after another, each filled by `fill(frame, slice)`.
void write_slices(const FrameHeaders& headers, E_TransferSyntax syntax, const fs::path& folder,
                  const std::function<void(std::size_t, DcmDataset&)>& fill) {
    for (std::size_t i = 0; i < headers.count(); ++i) {
        DcmFileFormat slice;
        headers.describe(i, *slice.getDataset());
        fill(i, *slice.getDataset());
        std::array<char, 32> name{};
        std::snprintf(name.data(), name.size(), "frame_%06zu.dcm", i + 1);
        const OFCondition saved = slice.saveFile((folder / name.data()).c_str(), syntax);
        if (saved.bad())
            throw Refusal{std::string("its frames cannot be written to the temporary folder (") +
                              saved.text() + ")",
                          "Free some space there"};
    }
}

void split(const fs::path& from, const fs::path& folder) {
    if (!dcmDataDict.isDictionaryLoaded())
        throw Refusal{"cannot be read: the dictionary of DICOM's elements is missing",
                      "Install the package libdcmtk17 again"};
    DcmFileFormat file;
    const OFCondition loaded =
        file.loadFile(from.c_str(), EXS_Unknown, EGL_noChange, longest_in_memory);
    if (loaded.bad()) throw Refusal{std::string("cannot be read (") + loaded.text() + ")"};
    DcmDataset& data = *file.getDataset();
    const FrameHeaders headers(data);
    OFString kind;
    data.findAndGetOFString(DCM_SOPClassUID, kind);
    // DCMTK 3.6.7 has no constant for label maps.
    if (kind == UID_SegmentationStorage || kind == "1.2.840.10008.5.1.4.1.1.66.7") {
        SegmentPixels pixels(data, headers.count());
        write_slices(headers, EXS_LittleEndianExplicit, folder, [&](std::size_t i, DcmDataset& to) {
            pixels.copy(i, headers.segment_of(i), to);
        });
        return;
    }
    headers.require_one_stack();
    FramePixels pixels(data, headers.count());
    write_slices(headers, pixels.syntax(), folder,
                 [&](std::size_t i, DcmDataset& to) { pixels.copy(i, to); });
}

int refused(const Refusal& refusal) {
    std::fprintf(stderr, "%s\n%s\n", refusal.problem.c_str(), refusal.remedy.c_str());
    return 1;
}

int run(const fs::path& from, const fs::path& folder) {
    OFLog::configure(OFLogger::OFF_LOG_LEVEL);
    try {
        split(from, folder);
        return 0;
    } catch (const Refusal& refusal) {
        return refused(refusal);
    } catch (const std::bad_alloc&) {
        return refused({"takes more memory than a file of its size should"});
    } catch (const std::exception& error) {
        return refused({std::string("cannot be read (") + error.what() + ")"});
    }
}

}  // namespace

}  // namespace hepatica::dicom_frames

int main(int count, char** arguments) {
    if (count != 3) {
        std::fputs("usage: hepatica-dicom-frames FILE FOLDER\n", stderr);
        return 2;
    }
    return hepatica::dicom_frames::run(arguments[1], arguments[2]);
}
