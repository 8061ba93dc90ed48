// SPDX-License-Identifier: GPL-3.0-or-later
// What objects of this room hold before anyone has written to them.
#include "tests/support/initial_values.h"

#include <gtest/gtest.h>

#include "core/image/brush.h"
#include "core/image/codestream.h"
#include "core/image/dicom_frames.h"
#include "core/image/dicom_header.h"
#include "core/image/dicom_reader.h"
#include "core/image/dicom_series.h"
#include "core/image/dicom_slices.h"
#include "core/image/filters.h"
#include "core/image/morphology.h"
#include "core/image/section.h"
#include "core/image/segmentation_writer.h"
#include "core/image/series_choice.h"
#include "core/image/slice.h"
#include "core/image/thumbnail.h"
#include "core/image/volume.h"
#include "core/image/volume_reader.h"
#include "core/image/volume_writer.h"
#include "core/image/voxel_file.h"
#include "tests/support/recorded_figures.h"

namespace hepatica {
namespace {

TEST(ImageInitialFigures, AreThoseRecorded) {
    test::Figures figures;
    HEPATICA_ADD_INITIAL(figures, BrushStroke);
    HEPATICA_ADD_INITIAL(figures, CodestreamSize);
    HEPATICA_ADD_INITIAL(figures, SplitFrames);
    HEPATICA_ADD_INITIAL(figures, FileRange);
    HEPATICA_ADD_INITIAL(figures, DicomHeader);
    HEPATICA_ADD_INITIAL(figures, DicomWish);
    HEPATICA_ADD_INITIAL(figures, DicomPlace);
    HEPATICA_ADD_INITIAL(figures, OrderedSeries);
    HEPATICA_ADD_INITIAL(figures, DicomSlice);
    HEPATICA_ADD_INITIAL(figures, IndexBox);
    HEPATICA_ADD_INITIAL(figures, Components);
    HEPATICA_ADD_INITIAL(figures, Section);
    HEPATICA_ADD_INITIAL(figures, SnomedConcept);
    HEPATICA_ADD_INITIAL(figures, SegmentMeaning);
    HEPATICA_ADD_INITIAL(figures, SegmentLayer);
    HEPATICA_ADD_INITIAL(figures, SeriesWish);
    HEPATICA_ADD_INITIAL(figures, GreyWindow);
    HEPATICA_ADD_INITIAL(figures, Thumbnail);
    HEPATICA_ADD_INITIAL(figures, SlicePixels);
    HEPATICA_ADD_INITIAL(figures, Grid);
    HEPATICA_ADD_INITIAL(figures, SeriesDescription);
    HEPATICA_ADD_INITIAL(figures, SegmentDescription);
    HEPATICA_ADD_INITIAL(figures, DicomSeriesInfo);
    HEPATICA_ADD_INITIAL(figures, VoxelFile);
    HEPATICA_ADD_INITIAL(figures, PlacedGrid);
    test::expect_recorded("image", "initial", figures);
}

}  // namespace
}  // namespace hepatica
