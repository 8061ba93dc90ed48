// SPDX-License-Identifier: GPL-3.0-or-later
// Plays tones on the system's sound device, by Qt Multimedia. UI thread only.
#pragma once

#include <memory>

#include "ui/tones.h"

class QAudioSink;
class QBuffer;

namespace hepatica {

class Loudspeaker {
  public:
    Loudspeaker();
    ~Loudspeaker();

    // Whether the system has a device for sound now.
    static bool there();
    // Returns at once; a tone that still sounds is cut off. Without a device nothing is heard.
    void play(Tone tone);

  private:
    std::unique_ptr<QBuffer> samples_;
    std::unique_ptr<QAudioSink> sink_;  // opened by the first tone
};

}  // namespace hepatica
