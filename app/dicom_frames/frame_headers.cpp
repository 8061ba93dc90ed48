// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/dicom_frames/frame_headers.h"

#include <cstdlib>
#include <string>

#include "app/dicom_frames/refusal.h"

namespace hepatica::dicom_frames {

namespace {

struct MovedValue {
    DcmTagKey sequence;
    DcmTagKey element;
};

// Values moved from the functional groups to the top level, where a classic slice has them.
const std::vector<MovedValue>& moved_values() {
    static const std::vector<MovedValue> values{
        {DCM_PlanePositionSequence, DCM_ImagePositionPatient},
        {DCM_PlaneOrientationSequence, DCM_ImageOrientationPatient},
        {DCM_PixelMeasuresSequence, DCM_PixelSpacing},
        {DCM_PixelMeasuresSequence, DCM_SliceThickness},
        {DCM_PixelMeasuresSequence, DCM_SpacingBetweenSlices},
        {DCM_PixelValueTransformationSequence, DCM_RescaleIntercept},
        {DCM_PixelValueTransformationSequence, DCM_RescaleSlope},
        {DCM_CTAcquisitionDetailsSequence, DCM_GantryDetectorTilt}};
    return values;
}

// Values common to all frames, which are at the top level already.
const std::vector<DcmTagKey>& copied_elements() {
    static const std::vector<DcmTagKey> elements{DCM_SpecificCharacterSet,
                                                 DCM_Modality,
                                                 DCM_SeriesInstanceUID,
                                                 DCM_SeriesNumber,
                                                 DCM_SamplesPerPixel,
                                                 DCM_PhotometricInterpretation,
                                                 DCM_Rows,
                                                 DCM_Columns,
                                                 DCM_BitsAllocated,
                                                 DCM_BitsStored,
                                                 DCM_HighBit,
                                                 DCM_PixelRepresentation,
                                                 DCM_PixelPaddingValue,
                                                 DCM_PixelPaddingRangeLimit};
    return elements;
}

OFString value_in(DcmItem* group, const DcmTagKey& sequence, const DcmTagKey& element) {
    DcmItem* item = nullptr;
    OFString text;
    if (group != nullptr && group->findAndGetSequenceItem(sequence, item).good() && item != nullptr)
        item->findAndGetOFStringArray(element, text);
    return text;
}

}  // namespace

FrameHeaders::FrameHeaders(DcmDataset& file) : file_(file) {
    Sint32 stated = 0;
    if (file.findAndGetSint32(DCM_NumberOfFrames, stated).bad() || stated < 1)
        throw Refusal{"states no number of frames (0028,0008)"};
    file.findAndGetSequenceItem(DCM_SharedFunctionalGroupsSequence, shared_);
    DcmSequenceOfItems* groups = nullptr;
    if (file.findAndGetSequence(DCM_PerFrameFunctionalGroupsSequence, groups).bad() ||
        groups == nullptr)
        throw Refusal{"says nothing of its single frames (Per-Frame Functional Groups, 5200,9230)"};
    for (DcmObject* group = nullptr; (group = groups->nextInContainer(group)) != nullptr;)
        frames_.push_back(dynamic_cast<DcmItem*>(group));
    if (frames_.size() != static_cast<std::size_t>(stated))
        throw Refusal{"states " + std::to_string(stated) + " frames (0028,0008), but describes " +
                      std::to_string(frames_.size()) + " (5200,9230)"};
}

OFString FrameHeaders::value(std::size_t frame, const DcmTagKey& sequence,
                             const DcmTagKey& element) const {
    const OFString own = value_in(frames_[frame], sequence, element);
    return own.empty() ? value_in(shared_, sequence, element) : own;
}

void FrameHeaders::require_one_stack() const {
    struct Kind {
        DcmTagKey element;
        const char* words;
    };
    for (const Kind& kind : {Kind{DCM_StackID, "stacks (0020,9056)"},
                             Kind{DCM_TemporalPositionIndex, "points in time (0020,9128)"}}) {
        const OFString first = value(0, DCM_FrameContentSequence, kind.element);
        for (std::size_t i = 1; i < count(); ++i) {
            const OFString other = value(i, DCM_FrameContentSequence, kind.element);
            if (other != first)
                throw Refusal{std::string("holds several ") + kind.words + ", \"" + first.c_str() +
                                  "\" and \"" + other.c_str() + "\" among them",
                              "Export each of them as a series of its own"};
        }
    }
}

Uint16 FrameHeaders::segment_of(std::size_t frame) const {
    const OFString text =
        value(frame, DCM_SegmentIdentificationSequence, DCM_ReferencedSegmentNumber);
    const int number = std::atoi(text.c_str());
    if (number < 1 || number > 65535)
        throw Refusal{"frame " + std::to_string(frame + 1) + " names no segment (0062,000b)",
                      "Export the segmentation as NIfTI or NRRD"};
    return static_cast<Uint16>(number);
}

void FrameHeaders::describe(std::size_t frame, DcmDataset& slice) const {
    for (const DcmTagKey& element : copied_elements()) {
        DcmElement* copy = nullptr;
        if (file_.findAndGetElement(element, copy, OFFalse, OFTrue).bad() || copy == nullptr)
            continue;
        if (slice.insert(copy, OFTrue).bad()) delete copy;
    }
    for (const MovedValue& moved : moved_values()) {
        const OFString text = value(frame, moved.sequence, moved.element);
        if (!text.empty()) slice.putAndInsertOFStringArray(moved.element, text);
    }
    const std::string number = std::to_string(frame + 1);
    slice.putAndInsertString(DCM_SOPClassUID, UID_CTImageStorage);
    slice.putAndInsertString(DCM_SOPInstanceUID, ("2.25." + number).c_str());
    slice.putAndInsertString(DCM_InstanceNumber, number.c_str());
}

}  // namespace hepatica::dicom_frames
