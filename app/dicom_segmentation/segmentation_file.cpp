// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/dicom_segmentation/segmentation_file.h"

#include <dcmtk/dcmdata/dcostrmf.h>
#include <dcmtk/dcmdata/dcwcache.h>
#include <dcmtk/dcmfg/fgderimg.h>
#include <dcmtk/dcmfg/fgfracon.h>
#include <dcmtk/dcmfg/fgpixmsr.h>
#include <dcmtk/dcmfg/fgplanor.h>
#include <dcmtk/dcmfg/fgplanpo.h>
#include <dcmtk/dcmiod/cielabutil.h>
#include <dcmtk/dcmiod/iodreferences.h>
#include <dcmtk/dcmseg/segdoc.h>
#include <dcmtk/dcmseg/segment.h>

#include <array>
#include <cstdio>
#include <memory>
#include <vector>

namespace hepatica::dicom_segmentation {

namespace {

constexpr const char* number_of_series = "300";

void require(const OFCondition& condition, const char* what) {
    if (condition.good()) return;
    throw Refusal{std::string("cannot be written: ") + what + " (" + condition.text() + ")",
                  "Export the CT again from the archive, with its identifiers"};
}

CodeSequenceMacro snomed(const std::string& code, const std::string& meaning) {
    return {code.c_str(), "SCT", meaning.c_str()};
}

std::unique_ptr<DcmSegmentation> empty_file(SourceSlices& source, const std::string& version) {
    const IODGeneralEquipmentModule::EquipmentInfo equipment("Hepatica", "Hepatica", "0",
                                                             version.c_str());
    ContentIdentificationMacro* content = nullptr;
    require(ContentIdentificationMacro::create("1", "LIVER_VESSELS", "Vessels of the liver", "",
                                               content),
            "its content");
    const std::unique_ptr<ContentIdentificationMacro> owner(content);
    DcmSegmentation* made = nullptr;
    require(DcmSegmentation::createBinarySegmentation(made, source.rows(), source.columns(),
                                                      equipment, *content),
            "its size");
    std::unique_ptr<DcmSegmentation> file(made);
    require(file->importHierarchy(source.first(), OFTrue, OFTrue, OFTrue, OFFalse, OFTrue),
            "the CT's patient and study");
    IODFoRModule& frame_of_reference = file->getFrameOfReference();
    if (source.text(DCM_FrameOfReferenceUID).empty()) {
        std::array<char, 65> unique{};
        frame_of_reference.setFrameOfReferenceUID(
            dcmGenerateUniqueIdentifier(unique.data(), SITE_INSTANCE_UID_ROOT));
    }
    file->getSeries().setSeriesDescription("Hepatica: vessels of the liver");
    file->getSegmentationSeriesModule().setSeriesNumber(number_of_series);
    return file;
}

void add_segments(DcmSegmentation& file, const std::vector<Segment>& segments) {
    for (const Segment& from : segments) {
        DcmSegment* segment = nullptr;
        require(DcmSegment::create(
                    segment, from.label.c_str(), snomed(from.category_code, from.category),
                    snomed(from.type_code, from.type), DcmSegTypes::SAT_AUTOMATIC, "Hepatica"),
                "a segment");
        double l = 0, a = 0, b = 0;
        IODCIELabUtil::rgb2DicomLab(l, a, b, from.colour[0] / 255.0, from.colour[1] / 255.0,
                                    from.colour[2] / 255.0);
        segment->setRecommendedDisplayCIELabValue(static_cast<Uint16>(l + 0.5),
                                                  static_cast<Uint16>(a + 0.5),
                                                  static_cast<Uint16>(b + 0.5));
        Uint16 number = 0;
        require(file.addSegment(segment, number), "a segment");
    }
}

// Sets what all frames have in common.
void describe_frames(DcmSegmentation& file, const SourceSlices& source) {
    const auto axis = [&](unsigned long i) {
        return source.number(DCM_ImageOrientationPatient, i);
    };
    const std::unique_ptr<FGPlaneOrientationPatient> orientation(
        FGPlaneOrientationPatient::createMinimal(axis(0), axis(1), axis(2), axis(3), axis(4),
                                                 axis(5)));
    if (!orientation)
        throw Refusal{"cannot be written: the CT has no orientation (0020,0037)",
                      "Export the CT again"};
    require(file.addForAllFrames(*orientation), "the CT's orientation");
    FGPixelMeasures measures;
    const OFString pixels =
        source.number(DCM_PixelSpacing, 0) + "\\" + source.number(DCM_PixelSpacing, 1);
    require(measures.setPixelSpacing(pixels), "the CT's pixel spacing");
    const OFString spacing = decimal(source.spacing_mm());
    OFString thickness = source.number(DCM_SliceThickness);
    if (thickness.empty()) thickness = spacing;
    require(measures.setSliceThickness(thickness), "the CT's slice thickness");
    require(measures.setSpacingBetweenSlices(spacing), "the spacing of slices");
    require(file.addForAllFrames(measures), "the CT's pixel spacing");
    std::array<char, 65> unique{};
    const OFString organization =
        dcmGenerateUniqueIdentifier(unique.data(), SITE_INSTANCE_UID_ROOT);
    IODMultiframeDimensionModule& dimensions = file.getDimensions();
    require(dimensions.addDimensionIndex(DCM_ReferencedSegmentNumber, organization,
                                         DCM_SegmentIdentificationSequence, "Segment"),
            "its dimensions");
    require(dimensions.addDimensionIndex(DCM_ImagePositionPatient, organization,
                                         DCM_PlanePositionSequence, "Slice"),
            "its dimensions");
}

void add_frame(DcmSegmentation& file, const SourceSlice& slice, Frame& frame) {
    const std::unique_ptr<FGPlanePosPatient> position(
        FGPlanePosPatient::createMinimal(slice.position[0], slice.position[1], slice.position[2]));
    FGFrameContent content;
    require(content.setDimensionIndexValues(frame.segment, 0), "a frame");
    require(content.setDimensionIndexValues(frame.slice + 1, 1), "a frame");
    ImageSOPInstanceReferenceMacro* reference = nullptr;
    require(ImageSOPInstanceReferenceMacro::create(slice.sop_class, slice.sop_instance, reference),
            "a reference to the CT");
    const std::unique_ptr<ImageSOPInstanceReferenceMacro> owner(reference);
    OFVector<ImageSOPInstanceReferenceMacro> references;
    references.push_back(*reference);
    const std::unique_ptr<FGDerivationImage> derivation(
        DcmSegmentation::createDerivationImageFG(references, "Segmented by Hepatica"));
    if (!position || !derivation)
        throw Refusal{"cannot be written: a slice has no position or identifier",
                      "Export the CT again"};
    OFVector<FGBase*> groups;
    for (FGBase* group : {static_cast<FGBase*>(position.get()), static_cast<FGBase*>(&content),
                          static_cast<FGBase*>(derivation.get())})
        groups.push_back(group);
    require(file.addFrame(frame.pixels.data(), frame.segment, groups), "a frame");
}

// Pixels as one bit each, lowest bit first, frame after frame without a gap (PS3.5 8.1.1). DCMTK
// 3.6.7 misplaces frames whose pixels do not fill whole bytes, so its pixels are replaced by these.
class PackedPixels {
  public:
    void add(const std::vector<std::uint8_t>& pixels) {
        for (const std::uint8_t pixel : pixels) {
            if (bits_ % 8 == 0) bytes_.push_back(0);
            if (pixel != 0) bytes_.back() |= static_cast<Uint8>(1u << (bits_ % 8));
            ++bits_;
        }
    }
    void put_into(DcmDataset& data) {
        if (bytes_.size() % 2 != 0) bytes_.push_back(0);
        require(data.putAndInsertUint8Array(DCM_PixelData, bytes_.data(), bytes_.size()),
                "its pixels");
    }

  private:
    std::vector<Uint8> bytes_;
    std::size_t bits_ = 0;
};

void refer_to(DcmSegmentation& file, SourceSlices& source) {
    IODReferences references;
    for (const SourceSlice& slice : source.all())
        references.add(new IODImageReference(
            source.text(DCM_PatientID), source.text(DCM_StudyInstanceUID),
            source.text(DCM_SeriesInstanceUID), slice.sop_instance, slice.sop_class));
    file.getCommonInstanceReference().addReferences(references, source.text(DCM_StudyInstanceUID));
}

// DCMTK closes a file without checking whether the last bytes were written. Without a buffer each
// write reports its own failure.
void save(DcmFileFormat& format, const std::filesystem::path& file) {
    const Refusal refusal{"cannot be written: the disk takes no more",
                          "Free some space there, or choose another folder", exit_unwritable};
    std::FILE* const out = std::fopen(file.c_str(), "wb");
    if (out == nullptr) throw refusal;
    std::setvbuf(out, nullptr, _IONBF, 0);
    DcmOutputFileStream stream(out);  // closes the file
    DcmWriteCache cache;
    format.transferInit();
    const OFCondition saved =
        format.write(stream, EXS_LittleEndianExplicit, EET_UndefinedLength, &cache);
    format.transferEnd();
    if (saved.bad() || stream.status().bad()) throw refusal;
}

}  // namespace

void write_segmentation(Order& order, SourceSlices& source, const std::string& version,
                        const std::filesystem::path& file) {
    const std::unique_ptr<DcmSegmentation> segmentation = empty_file(source, version);
    add_segments(*segmentation, order.segments());
    describe_frames(*segmentation, source);
    const std::size_t pixels = std::size_t{source.rows()} * source.columns();
    Frame frame;
    PackedPixels packed;
    while (order.next(pixels, frame)) {
        add_frame(*segmentation, source.all()[frame.slice], frame);
        packed.add(frame.pixels);
    }
    refer_to(*segmentation, source);
    DcmFileFormat written;
    require(segmentation->writeDataset(*written.getDataset()), "patient, study or frames");
    packed.put_into(*written.getDataset());
    save(written, file);
}

}  // namespace hepatica::dicom_segmentation
