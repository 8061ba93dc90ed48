// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/simulation_thread.h"

#include <utility>

namespace hepatica {

SimulationThread::SimulationThread(std::unique_ptr<Session> session)
    : session_(std::move(session)),
      thread_([this](const std::stop_token& stop) { session_->run(stop); }) {}

SimulationThread::~SimulationThread() {
    thread_.request_stop();
    thread_.join();
}

void SimulationThread::post(Command command) {
    session_->post(std::move(command));
}

}  // namespace hepatica
