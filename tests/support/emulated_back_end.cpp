// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/emulated_back_end.h"

#include <atomic>
#include <memory>
#include <utility>

#include "gpu/cuda_back_end.h"
#include "gpu/machine/device_error.h"
#include "gpu/machine/emulator.h"

namespace hepatica::test {
namespace {

// The emulator, until it is lost: then nothing can be had of it but its memory be given back.
class LosableMachine final : public gpu::MachineBy<LosableMachine> {
  public:
    explicit LosableMachine(std::shared_ptr<std::atomic<bool>> lost) : lost_(std::move(lost)) {}

    std::string name() const override { return emulator_->name(); }

    template <class Kernel>
    void execute(const Kernel& kernel) {
        require_there();
        emulator_->launch(kernel);
    }

  private:
    void require_there() const {
        if (*lost_) throw gpu::DeviceError("the device does not answer: it was pulled out");
    }
    void* take(std::size_t bytes) override {
        require_there();
        return emulator_->allocate(bytes);
    }
    void give_back(void* memory) noexcept override { emulator_->release(memory, 0); }
    void copy_in(void* to, const void* from, std::size_t bytes) override {
        require_there();
        emulator_->upload(to, from, bytes);
    }
    void copy_out(void* to, const void* from, std::size_t bytes) override {
        require_there();
        emulator_->download(to, from, bytes);
    }
    void begin_copy_out(void* to, const void* from, std::size_t bytes) override {
        require_there();
        emulator_->begin_download(to, from, bytes);
    }
    void finish_copies() override {
        emulator_->finish_downloads();
        require_there();
    }

    std::shared_ptr<std::atomic<bool>> lost_;
    std::unique_ptr<gpu::Machine> emulator_ = gpu::make_emulator();
};

}  // namespace

EmulatedBackEnd emulated_back_end(const std::function<void(const std::string&)>& say) {
    const auto lost = std::make_shared<std::atomic<bool>>(false);
    const std::shared_ptr<gpu::Machine> machine = std::make_shared<LosableMachine>(lost);
    gpu::CudaOptions cuda;
    cuda.say = say;
    return {device_back_end(
                "cuda-emulated", machine->name(),
                [machine, cuda](const BodyDescription& body, const StepperOptions& options) {
                    return gpu::make_cuda_back_end(body, options, machine, cuda);
                }),
            [share = cuda.share] { return share->device; }, [lost] { *lost = true; }};
}

}  // namespace hepatica::test
