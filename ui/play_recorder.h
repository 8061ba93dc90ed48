// SPDX-License-Identifier: GPL-3.0-or-later
// Records a free play on request into a file that is only appended to. Times at which nothing moves
// are left out.
#pragma once

#include <filesystem>
#include <memory>

#include "ui/recording_guard.h"
#include "ui/simulation.h"

namespace hepatica {

// UI thread only.
class PlayRecorder {
  public:
    PlayRecorder();
    ~PlayRecorder();

    bool recording() const { return tape_ != nullptr; }
    const std::filesystem::path& file() const { return file_; }  // of this or the last recording
    // Creates the folder if needed.
    void begin(Simulation& simulation, const std::filesystem::path& folder);
    // No effect if not recording. `simulation` is null if it is gone. Returns whether anything was
    // recorded; an empty recording is removed. Throws InputError if it could not be written.
    bool end(Simulation* simulation);

  private:
    class Tape;  // shared with the thread that steps

    std::filesystem::path file_;
    std::shared_ptr<Tape> tape_;
    std::unique_ptr<RecordingGuard> guard_;
};

}  // namespace hepatica
