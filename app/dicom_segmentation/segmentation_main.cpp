// SPDX-License-Identifier: GPL-3.0-or-later
// hepatica-dicom-segmentation FOLDER VERSION FILE: writes the segments that FOLDER describes
// (order.h) as a DICOM segmentation of the CT slices it names. A program of its own, started by
// core/image/segmentation_writer.cpp under limits, because DCMTK reads the CT's headers, which may
// come from anybody. On failure two lines on standard error: the problem, the remedy.
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
    return 1;
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
