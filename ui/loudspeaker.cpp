// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/loudspeaker.h"

#include <QAudioDevice>
#include <QAudioFormat>
#include <QAudioSink>
#include <QBuffer>
#include <QMediaDevices>

namespace hepatica {

Loudspeaker::Loudspeaker() : samples_(std::make_unique<QBuffer>()) {}

Loudspeaker::~Loudspeaker() = default;

bool Loudspeaker::there() {
    return !QMediaDevices::defaultAudioOutput().isNull();
}

void Loudspeaker::play(Tone tone) {
    if (!there()) return;
    if (!sink_) {
        QAudioFormat format;
        format.setSampleRate(tone_rate_hz);
        format.setChannelCount(1);
        format.setSampleFormat(QAudioFormat::Int16);
        sink_ = std::make_unique<QAudioSink>(QMediaDevices::defaultAudioOutput(), format);
    }
    sink_->stop();
    samples_->close();
    const std::vector<std::int16_t> samples = samples_of(tone);
    samples_->setData(reinterpret_cast<const char*>(samples.data()),
                      static_cast<int>(samples.size() * sizeof samples.front()));
    samples_->open(QIODevice::ReadOnly);
    sink_->start(samples_.get());
}

}  // namespace hepatica
