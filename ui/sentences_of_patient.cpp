// SPDX-License-Identifier: GPL-3.0-or-later
// Core's sentences about patients: stages of a reconstruction, cases, doubts.
#include <array>

#include "ui/core_sentences.h"
#include "ui/words.h"

namespace hepatica {
namespace {

constexpr std::array sentences_patient{
    Words::id("Reading the case"),
    Words::id("Reading the tree"),
    Words::id("Reading the built-in patient"),
    Words::id("Making the mesh"),
    Words::id("Meshing the vessels"),
    Words::id("Editing the tree"),
    Words::id("Parting the liver into segments"),
    Words::id("Growing the vessels"),
    Words::id("Drawing the body"),
    Words::id("Scanning"),
    Words::id("Extracting the tree"),
    Words::id("Making the skeleton one voxel wide"),
    Words::id("Thinning to the skeleton"),
    Words::id("Telling the systems apart"),
    Words::id("Smoothing the vessels"),
    Words::id("Filling the vessels"),
    Words::id("Choosing the vessels"),
    Words::id("Looking for doubtful branches"),
    Words::id("Drawing thin vessels"),
    Words::id("Finding the liver"),
    Words::id("Measuring the contrast"),
    Words::id("Refining the surface"),
    Words::id("Resampling the liver"),
    Words::id("Segmenting the vessels"),
    Words::id("Following the vessel"),
    Words::id("Building the scene"),
    Words::id("Replaying"),
    Words::id("Measuring the reference"),
    Words::id("Measuring the settings"),
    Words::id("check the name, and that its disk is connected"),
    Words::id("holds another patient by now than the unsaved edits were made on"),
    Words::id("Bring the case back as it was, then open them again"),
    Words::id("there is no such file or folder"),
    Words::id("holds no voxels of vessels or organs"),
    Words::id("Reconstruct the case from its CT"),
    Words::id("the CT %1 is not there any more"),
    Words::id("choose the folder or file where it lies now, or connect its disk"),
    Words::id("it is not known where this patient's CT lies"),
    Words::id("choose its folder or file"),
    Words::id("this is not the CT that the patient was reconstructed from"),
    Words::id("choose the one that was opened when the case was made; its files may have other "
              "names, but the voxels must be the same"),
    Words::id("%1 is passed over: %2"),
    Words::id("Ask for the case again, or for its folder NAME.hep"),
    Words::id("Choose a folder you may write to, on a disk with room"),
    Words::id("Free some space among the temporary files: %1"),
    Words::id("cannot be unpacked"),
    Words::id("holds a file whose name no file of a case has: \"%1\""),
    Words::id("holds more files than a case can"),
    Words::id("holds more than a case can: %1 is too large"),
    Words::id("holds %1 twice"),
    Words::id("is damaged at %1"),
    Words::id("is encrypted"),
    Words::id("is not a case in one file (.hepz), or is damaged"),
    Words::id("is not a patient's case: it holds no case.json"),
    Words::id("has version %1; this program reads versions %2"),
    Words::id("Check the path: a case is a folder NAME.hep or one file NAME.hepz"),
    Words::id("Reconstruct the patient again: hepatica-cli reconstruct CT --out CASE.hep"),
    Words::id("is not the file that case.json was written for (its hash differs)"),
    Words::id("was not written by this program"),
    Words::id("edit %1 at %2"),
    Words::id("there is no such tumour to be erased"),
    Words::id("there is nothing that could become tumour"),
    Words::id("Lead the brush elsewhere, or take the edit out"),
    Words::id("the edits leave nothing of the tree"),
    Words::id("the last edit"),
    Words::id("Take it back, or delete a smaller branch"),
    Words::id("is there already and is not a patient's case"),
    Words::id("is a folder, and no case in one file can take its place"),
    Words::id("Choose another name, or rename the folder or move it away"),
    Words::id("Give --out another name; only an older case is replaced"),
    Words::id("Put the case back that was there, or open this one anew"),
    Words::id("holds another patient than when it was opened"),
    Words::id("holds edits without the tree that they were made on"),
    Words::id("its parameter mesh is %1, not an object"),
    Words::id("its parameter mesh.%1 is %2, not a number"),
    Words::id("its parameter mesh.%1 is %2, not a whole number in range"),
    Words::id("its parameter %1 is %2, not true or false"),
    Words::id(
        "The tumours' masks hold %1 separate pieces, and a case holds %2 tumours at most: the %3 "
        "smallest are left out, %4 ml together. Remove specks from the masks."),
    Words::id(
        "Of the tumours numbered %1 from the masks %2 of %3 ml lie outside the box about the liver "
        "and are left out of the case. Check that the masks of tumours and liver are of this CT, "
        "or "
        "give a liver mask that includes them."),
    Words::id("nothing measures a %1"),
    Words::id("has %1 points_mm in place of %2"),
    Words::id("measures at %1, which is farther than 10 m from the origin"),
    Words::id("has a stenosis of %1, which is above 1"),
    Words::id("has the format %1"),
    Words::id("has version %1; this program reads version 1"),
    Words::id("Correct that value, or remove the file: the case is whole without it"),
    Words::id("Take a newer program, or remove the file"),
    Words::id("Make it readable, or remove it: the case is whole without it"),
    Words::id("%1, measurement %2"),
    Words::id(
        "What was painted at %1 is left out of the tree: it is too short or too round to be a "
        "vessel. Paint along the vessel, or undo the rebuilding."),
    Words::id("No hepatic vein is known where the liver's segments part: an adult's usual planes "
              "stand in for them. A seed inside a hepatic vein helps."),
    Words::id("Not all three hepatic veins are known where the liver's segments part: an adult's "
              "usual planes stand in for them. A seed inside a hepatic vein helps."),
    Words::id("No portal branch to the liver's segment %1 was found: its part of the liver counts "
              "to the neighbours."),
    Words::id("No portal branch to the liver's segments %1 was found: their part of the liver "
              "counts to the neighbours."),
    Words::id("%1, %2 and %3"),
    Words::id("%1 and %2"),
    Words::id("For %1 of the liver it is less than 80 % sure to which of Couinaud's segments it "
              "belongs: the branches there run across the usual borders."),
    Words::id("For %1 of the vessels' length nothing tells which system they belong to. A seed "
              "inside the portal vein and one inside a hepatic vein would tell them apart."),
    Words::id(
        "For %1 of the vessels' length it is less than 80 % sure whether they belong to the portal "
        "vein or to the hepatic veins. Look at branches where both touch; a seed inside a wrong "
        "one, or giving the branch to the other system, mends all that hangs on it."),
    Words::id("The vessels rise only %1 HU above the liver, where the noise is %2 HU: most thin "
              "branches are missing, and some that are found may be noise. A scan in the portal "
              "venous phase, or a smoother kernel, shows more."),
    Words::id(
        "The liver was found by the program: on real patients about 6 % of such a liver lay "
        "outside of an expert's, and 10 % of the expert's were missed. A segment beside "
        "stomach or pancreas, mostly III, may lie outside of it by nearly half. Where volumes "
        "matter, give a mask of the liver."),
    Words::id("%1 loop within one system, made where branches touch in the image, was opened. "
              "Thinner slices would part such branches."),
    Words::id("%1 loops within one system, made where branches touch in the image, were opened. "
              "Thinner slices would part such branches."),
    Words::id("%1 loop is left in the vessels. Cut those that are no real connections."),
    Words::id("%1 loops are left in the vessels. Cut those that are no real connections."),
    Words::id("In one tree (%1) blood comes in at an end of %2 mm radius (%3), and the end at %4, "
              "of %5 mm, is a wide way out for it. If that one is the trunk, set the root there."),
    Words::id("%1 piece of vessels, %2 mm in all, was left out of the tree: %3. A seed inside such "
              "a piece keeps it."),
    Words::id("%1 pieces of vessels, %2 mm in all, were left out of the tree: %3. A seed inside "
              "such a piece keeps it."),
    Words::id("%1 piece as wide as an organ, %2 mm in all, was left out of the tree: %3. A seed "
              "inside such a piece keeps it."),
    Words::id("%1 pieces as wide as an organ, %2 mm in all, were left out of the tree: %3. A seed "
              "inside such a piece keeps it."),
    Words::id("pieces shorter than %1 mm that nothing joins are often noise"),
    Words::id("what hangs on a vessel by a neck and is wide and short is hardly one"),
    Words::id("what joins the portal trunk before it divides mostly comes from other organs"),
    Words::id("The labels of the vessel mask were taken for systems: %1. If they mean something "
              "else, name them: --vessel-label LABEL=SYSTEM,LABEL=SYSTEM."),
    Words::id("%1 as %2, %3 as %4, %5 as %6"),
    Words::id("%1 as %2, %3 as %4"),
    Words::id("%1 as %2"),
    Words::id("Give a mask whose vessels are not 0"),
    Words::id("Name those that are vessels: --vessel-label LABEL=SYSTEM,LABEL=SYSTEM, where SYSTEM "
              "is portal, hepatic, artery or unknown; the others are left out"),
    Words::id("holds the labels %1, and %2 is no vascular system (%3)"),
    Words::id("%1 and others"),
    Words::id("no vessels were found"),
    Words::id("Give a window (--window LO,HI) or a vessel mask (--vessel-mask)"),
    Words::id("Give a window (--window LO,HI), a seed inside a vessel (--seed-mm) or a vessel mask "
              "(--vessel-mask)"),
    Words::id("Give the liver, too (--liver-mask): blood reaches tumours through it"),
    Words::id("the vessels found are too small for a tree"),
    Words::id("Choose a mask that holds whole vessels"),
    Words::id("tumours are given without a liver"),
    Words::id("The correction number %1 is left out, because it cannot be made on these vessels: "
              "%2 (%3)"),
    Words::id("The seed at %1 is left out: %2"),
    Words::id("Take back what was erased, or paint more of the vessels"),
    Words::id("no vessel is left that is long enough for a tree"),
    Words::id("%1 lies outside the image, which reaches from %2 to %3"),
    Words::id("%1 lies %2 mm from the liver of %3"),
    Words::id(
        "Give a place inside a vessel in or at the liver, in mm to the patient's left, back and "
        "head (LPS)"),
    Words::id(
        "Give a place inside a vessel, in mm to the patient's left, back and head (LPS); other "
        "programs may show RAS: there change the sign of X and Y"),
    Words::id("the window from %1 to %2 HU takes in the liver's own tissue, which has %3 HU"),
    Words::id("only %1 % of the liver lie between %2 and %3 HU and hang together as vessels do; "
              "the tissue itself has %4 HU"),
    Words::id("what lies between %1 and %2 HU is darker than the tissue, which has %3 HU"),
    Words::id("what lies between %1 and %2 HU and hangs together as vessels do rises only %3 HU "
              "above the tissue, which has %4 HU"),
    Words::id("The slices are %1 mm apart: thin branches may be broken or missing. Up to 1.5 mm is "
              "better."),
    Words::id("Choose a window that reaches from between tissue and vessels to above the brightest "
              "vessel, or give none."),
    Words::id("Give a mask of the whole liver."),
    Words::id("Use a scan with contrast medium (portal-venous phase for veins, arterial phase for "
              "arteries), or give a vessel mask."),
    Words::id("liver mask"),
    Words::id("the liver mask is so thin that nothing of it is further than 3 mm inside"),
    Words::id("the vessels do not stand out from the liver: the brightest structures cover %1 % of "
              "it and rise %2 HU above its %3 HU, where the noise is %4 HU"),
    Words::id("the number of recursions of the refinement is %1"),
    Words::id("the refinement's level is %1"),
    Words::id("the refinement's sigma is %1 mm"),
    Words::id("Use 0 (no refinement) or more."),
    Words::id("Use a level between 0 and 1."),
    Words::id("Use a sigma above 0."),
    Words::id("a working spacing of %1 mm was asked for"),
    Words::id("Use 0.3 to 1.5 mm."),
    Words::id("Give a mask in which the liver is not 0."),
    Words::id("Give the mask of the same patient, in the same space as the CT."),
    Words::id("the liver mask is empty"),
    Words::id("the liver mask lies outside the CT"),
    Words::id("no liver was found: the largest soft organ between %1 and %2 HU has %3 ml"),
    Words::id("no liver was found: the largest soft organ has no border that it is told by"),
    Words::id("Check that the scan shows the liver, or give a liver mask."),
    Words::id("Choose a CT of the upper abdomen; where it does show the liver, give a liver mask."),
    Words::id("no liver was found: the largest soft organ is enclosed by bone (%1 of what lies "
              "around it), as a brain is"),
    Words::id("no liver was found: the largest soft organ lies between the lungs (%1 of what lies "
              "around it), as a heart does"),
    Words::id("Give a mask that lies inside the CT."),
    Words::id("the liver region is empty"),
    Words::id("Give the lower value first."),
    Words::id("the window runs from %1 to %2 HU"),
    Words::id("a seed's place is no number"),
    Words::id("Give three finite numbers in mm."),
    Words::id("Place the seed inside a vessel that the segmentation found."),
    Words::id("no vessel lies within 3 mm of the seed at %1"),
    Words::id("a vesselness scale of %1 mm is below half a voxel"),
    Words::id("Resample the volume to one spacing first."),
    Words::id("Use scales of at least half the spacing."),
    Words::id("vesselness needs cubic voxels, these are %1 by %2 mm"),
};

}  // namespace

std::span<const char* const> sentences_of_patient() {
    return sentences_patient;
}

}  // namespace hepatica
