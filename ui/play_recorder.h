// SPDX-License-Identifier: GPL-3.0-or-later
// Records a free play from the moment on at which it is asked to, into a file that only grows; what
// happens while nothing moves takes no time in it.
#pragma once

#include <filesystem>
#include <memory>

#include "ui/recording_guard.h"
#include "ui/simulation.h"

namespace hepatica {

// UI thread.
class PlayRecorder {
  public:
    PlayRecorder();
    ~PlayRecorder();

    bool recording() const { return tape_ != nullptr; }
    const std::filesystem::path& file() const { return file_; }  // of this or the last recording
    // The folder is made where it is not there.
    void begin(Simulation& simulation, const std::filesystem::path& folder);
    // Nothing where it does not record. `simulation` may be gone: null. True where something was
    // recorded; an empty recording is removed. Throws InputError where it could not be written.
    bool end(Simulation* simulation);

  private:
    class Tape;  // shared with the thread that steps

    std::filesystem::path file_;
    std::shared_ptr<Tape> tape_;
    std::unique_ptr<RecordingGuard> guard_;
};

}  // namespace hepatica
