// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/dicom_frames/segment_pixels.h"

#include <limits>
#include <new>
#include <string>

#include "app/dicom_frames/refusal.h"

namespace hepatica::dicom_frames {

namespace {

const std::string mask_remedy = "Export the segmentation as NIfTI or NRRD";

Uint16 short_at(DcmDataset& file, const DcmTagKey& element, Uint16 otherwise = 0) {
    Uint16 number = otherwise;
    file.findAndGetUint16(element, number);
    return number;
}

}  // namespace

SegmentPixels::SegmentPixels(DcmDataset& file, std::size_t frames) {
    OFString type;
    file.findAndGetOFString(DCM_SegmentationType, type);
    const Uint16 bits = short_at(file, DCM_BitsAllocated);
    const bool is_binary = type == "BINARY" && bits == 1;
    if (!is_binary && !(type == "FRACTIONAL" && bits == 8))
        throw Refusal{std::string("is a segmentation of the type \"") + type.c_str() +
                          "\" (0062,0001) with " + std::to_string(bits) + " bits a pixel",
                      mask_remedy};
    if (!is_binary) {
        pixels_per_byte_ = 1;
        whole_ = short_at(file, DCM_MaximumFractionalValue, 255);
        if (whole_ == 0)
            throw Refusal{"says that the whole of its fractions is 0 (0062,000e)", mask_remedy};
    }
    file.findAndGetElement(DCM_PixelData, pixels_);
    if (pixels_ == nullptr) throw Refusal{"has no pixels (7fe0,0010)", mask_remedy};
    if (DcmXfer(file.getOriginalXfer()).isEncapsulated())
        throw Refusal{"is a compressed segmentation", mask_remedy};
    frame_pixels_ =
        static_cast<std::size_t>(short_at(file, DCM_Rows)) * short_at(file, DCM_Columns);
    if (frame_pixels_ == 0) throw Refusal{"has frames without rows or columns", mask_remedy};
    // Frames follow one another without padding, even within a byte.
    const std::size_t wanted = (frame_pixels_ * frames + pixels_per_byte_ - 1) / pixels_per_byte_;
    if (wanted > std::numeric_limits<Uint32>::max() || pixels_->getLength() < wanted)
        throw Refusal{"holds " + std::to_string(pixels_->getLength()) + " bytes of pixels, but " +
                          std::to_string(frames) + " frames of " + std::to_string(frame_pixels_) +
                          " pixels take " + std::to_string(wanted),
                      mask_remedy};
}

std::vector<Uint8> SegmentPixels::bytes_from(std::size_t first, std::size_t end,
                                             std::size_t frame) {
    std::vector<Uint8> bytes(end - first);
    const OFCondition got =
        pixels_->getPartialValue(bytes.data(), static_cast<Uint32>(first),
                                 static_cast<Uint32>(bytes.size()), &cache_, EBO_LittleEndian);
    if (got.bad())
        throw Refusal{
            "is cut short: the pixels of frame " + std::to_string(frame + 1) + " cannot be read",
            mask_remedy};
    return bytes;
}

bool SegmentPixels::is_set(const std::vector<Uint8>& bytes, std::size_t pixel,
                           std::size_t first_pixel) const {
    const std::size_t first_byte = first_pixel / pixels_per_byte_;
    const Uint8 byte = bytes[pixel / pixels_per_byte_ - first_byte];
    if (pixels_per_byte_ == 1) return 2 * byte >= whole_;
    return (byte >> (pixel % 8) & 1) != 0;  // the first pixel is the lowest bit
}

void SegmentPixels::copy(std::size_t frame, Uint16 segment, DcmDataset& slice) {
    const std::size_t first = frame * frame_pixels_, end = first + frame_pixels_;
    const std::vector<Uint8> bytes = bytes_from(
        first / pixels_per_byte_, (end + pixels_per_byte_ - 1) / pixels_per_byte_, frame);
    std::vector<Uint16> labels(frame_pixels_);
    for (std::size_t i = 0; i < frame_pixels_; ++i)
        labels[i] = is_set(bytes, first + i, first) ? segment : Uint16{0};
    slice.putAndInsertUint16(DCM_BitsAllocated, 16);
    slice.putAndInsertUint16(DCM_BitsStored, 16);
    slice.putAndInsertUint16(DCM_HighBit, 15);
    slice.putAndInsertUint16(DCM_PixelRepresentation, 0);
    if (slice.putAndInsertUint16Array(DCM_PixelData, labels.data(), labels.size()).bad())
        throw std::bad_alloc();
}

}  // namespace hepatica::dicom_frames
