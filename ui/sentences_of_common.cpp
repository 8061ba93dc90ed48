// SPDX-License-Identifier: GPL-3.0-or-later
// Sentences used throughout core: files, numbers, names of vessels.
#include <array>

#include "ui/core_sentences.h"
#include "ui/words.h"

namespace hepatica {
namespace {

constexpr std::array sentences_common{
    Words::id("portal vein"),
    Words::id("hepatic veins"),
    Words::id("artery"),
    Words::id("unknown system"),
    Words::id("Portal vein"),
    Words::id("Hepatic veins"),
    Words::id("Artery"),
    Words::id("Unknown system"),
    Words::id("Built-in patient"),
    Words::id("internal error: %1"),
    Words::id("%1, %2, %3 mm"),
    Words::id("cannot be written (%1)"),
    Words::id("cannot be written: the disk is full"),
    Words::id("cannot be written"),
    Words::id("cannot be written to its end"),
    Words::id("Check that the folder exists, may be written and has free space"),
    Words::id("was in the folder and could not be put back into it"),
    Words::id("Move it to %1 by hand"),
    Words::id("cannot be started (%1)"),
    Words::id("End other programs, and try again"),
    Words::id("cannot be read"),
    Words::id("cannot be read (%1)"),
    Words::id("cannot be read; check its permissions"),
    Words::id("ended after %1 of %2 bytes: it was cut while it was read"),
    Words::id("Read it again when no other program writes it"),
    Words::id("Check that it exists"),
    Words::id("Check that it exists and may be read"),
    Words::id("must be a whole number in range, but is %1"),
    Words::id("is damaged (%1)"),
    Words::id("is damaged"),
    Words::id("%1 mm, which is farther than %2 m from the origin of its coordinates"),
    Words::id("Check the unit of its positions and export it again in millimetres"),
    Words::id("a file of the program itself is missing"),
    Words::id("Install Hepatica again, or run it where it was built"),
    Words::id("is no folder for temporary files"),
    Words::id("Make that folder, or let TMPDIR name one that is there"),
    Words::id("no temporary folder can be made"),
    Words::id("Free some space there"),
    Words::id("Free some space there, or set TMPDIR to a folder with more"),
    Words::id("does not exist"),
    Words::id("is a folder"),
    Words::id("is a pipe, a socket or a device, not a file"),
    Words::id("nests lists and objects deeper than any file of this program"),
    Words::id("is empty"),
    Words::id("is missing"),
    Words::id("is not finite"),
    Words::id("is %1; it must lie from %2 to %3"),
    Words::id("is not known, and no key is"),
    Words::id("is not known; choose from %1"),
    Words::id("is not known; the nearest key is \"%1\""),
    Words::id("is not known"),
    Words::id("is not an object"),
    Words::id("Choose one of: %1"),
    Words::id("Give a value from %1"),
    Words::id("Reconstruct the patient first"),
    Words::id("Reconstruct the patient again"),
    Words::id("the vessel tree has no segments"),
    Words::id("Choose a value from 0 to 1"),
    // The system's messages about files.
    Words::id("No such file or directory"),
    Words::id("Permission denied"),
    Words::id("No space left on device"),
    Words::id("Read-only file system"),
    Words::id("Is a directory"),
    Words::id("Not a directory"),
    Words::id("File exists"),
    Words::id("Input/output error"),
    Words::id("Too many open files"),
    Words::id("File name too long"),
    Words::id("Device or resource busy"),
    Words::id("Disk quota exceeded"),
    Words::id("File too large"),
    Words::id("Invalid argument"),
    Words::id("Too many levels of symbolic links"),
    Words::id("Stale file handle"),
    Words::id("Operation not permitted"),
};

}  // namespace

std::span<const char* const> sentences_of_common() {
    return sentences_common;
}

}  // namespace hepatica
