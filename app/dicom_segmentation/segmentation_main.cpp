// SPDX-License-Identifier: GPL-3.0-or-later
// hepatica-dicom-segmentation FOLDER VERSION FILE: writes the segments described in FOLDER
// (order.h) as a DICOM segmentation of the CT slices named there. It is a separate program, which
// core/image/segmentation_writer.cpp starts under limits, because DCMTK parses CT headers from
// untrusted sources. On failure it writes two lines to standard error: the problem and the remedy;
// where it is FILE that cannot be written, it ends with exit_unwritable.
#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dctk.h>
#include <dcmtk/oflog/oflog.h>

#include <cstdio>
#include <exception>

#include "app/dicom_segmentation/segmentation_file.h"

namespace hepatica::dicom_segmentation {

namespace {

int refused(const Refusal& refusal) {
    std::fprintf(stderr, "%s\n%s\n", refusal.problem.c_str(), refusal.remedy.c_str());
    return refusal.exit_code;
}

int run(const std::filesystem::path& folder, const char* version,
        const std::filesystem::path& file) {
    OFLog::configure(OFLogger::OFF_LOG_LEVEL);
    try {
        if (!dcmDataDict.isDictionaryLoaded())
            throw Refusal{"cannot be made: the dictionary of DICOM's elements is missing",
                          "Install the package libdcmtk17 again"};
        Order order(folder);
        SourceSlices source(order.slices());
        write_segmentation(order, source, version, file);
        return 0;
    } catch (const Refusal& refusal) {
        return refused(refusal);
    } catch (const std::exception& error) {
        return refused({std::string("cannot be made (") + error.what() + ")",
                        "Free some memory and try again"});
    }
}

}  // namespace

}  // namespace hepatica::dicom_segmentation

int main(int count, char** arguments) {
    if (count != 4) {
        std::fputs("usage: hepatica-dicom-segmentation FOLDER VERSION FILE\n", stderr);
        return 2;
    }
    return hepatica::dicom_segmentation::run(arguments[1], arguments[2], arguments[3]);
}
