// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/deform/stepper/stepper_checkpoint.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>

#include "core/base/error.h"
#include "core/base/hash.h"

namespace hepatica {
namespace {

static_assert(std::endian::native == std::endian::little, "numbers are written as they lie");

constexpr std::string_view heading = "hepatica checkpoint 4\n";

// Visits all fields in order; shared by writing, reading and hashing.
template <class Visit>
void fields(Visit& visit, auto& value) requires requires {
    value.weights;
}
{
    for (auto& vertex : value.vertices) visit(vertex);
    for (auto& weight : value.weights) visit(weight);
    visit(value.target_mm);
    visit(value.stiffness_un_per_mm);
    visit(value.force_limit_un);
}

template <class Visit>
void fields(Visit& visit, auto& value) requires requires {
    value.opens;
}
{
    visit(value.shape.centre_mm);
    visit(value.shape.half_axis_mm);
    visit(value.shape.radius_mm);
    visit(value.opens);
    visit(value.led_by_mm);
    visit(value.led_half_axis_mm);
}

template <class Visit>
void fields(Visit& visit, auto& value) requires requires {
    value.pressure_pa;
}
{
    visit(value.parts);
    visit(value.opening_mm);
    visit(value.target_mm);
    visit(value.turn_rad);
    visit(value.opening_target_mm);
    visit(value.led_over_s);
    visit(value.pad_mm);
    visit(value.pressure_pa);
    visit(value.friction);
    visit(value.force_limit_un);
}

template <class Visit>
void fields(Visit& visit, auto& value) requires requires {
    value.pad_mm;
    value.corners;
}
{
    for (auto& corner : value.corners) visit(corner);
    visit(value.pad_mm);
}

template <class Visit>
void fields(Visit& visit, auto& value) requires requires {
    value.in_first;
}
{
    for (auto& node : value.nodes) visit(node);
    visit(value.in_first);
    visit(value.pad_mm);
    visit(value.most_mm);
    visit(value.share);
}

template <class Visit>
void fields(Visit& visit, auto& value) requires requires {
    value.start_mm;
}
{
    fields(visit, value.tool);
    visit(value.start_mm);
}

template <class Visit>
void fields(Visit& visit, auto& value) requires requires {
    value.led;
}
{
    fields(visit, value.tool);
    visit(value.led);
    visit(value.last_load.force_un);
    visit(value.last_load.torque_un_mm);
    visit(value.last_load.grip_un);
    visit(value.last_load.at_mm);
    visit(value.last_load.impulse_un_s);
    visit(value.last_load.contacts);
    visit(value.last_load.least_gap_mm);
    visit(value.last_load.touched);
    visit(value.last_contact);
}

template <class Visit>
void fields(Visit& visit, auto& value) requires requires {
    value.buried;
}
{
    visit(value.touching);
    visit(value.buried);
}

template <class Visit>
void fields(Visit& visit, auto& value) requires requires {
    value.overlaps;
    value.last_contact;
}
{
    fields(visit, value.overlaps);
    visit(value.last_load.contacts);
    visit(value.last_load.least_gap_mm);
    visit(value.last_contact);
}

template <class Visit>
void fields(Visit& visit, auto& value) requires requires {
    value.touch;
}
{
    fields(visit, value.touch);
    visit(value.last_force_un);
    visit(value.last_impulse_un_s);
}

template <class Visit>
void fields(Visit& visit, auto& value) requires requires {
    value.iterate_mm;
}
{
    visit(value.dt_s);
    visit(value.first_mm);
    visit(value.iterate_mm);
    visit(value.taut_mm);
    visit(value.collapse);
    visit(value.held);
    visit(value.grabs);
    visit(value.gravity_mm_per_s2);
    visit(value.velocity_error.alpha_per_s);
    visit(value.velocity_error.beta_s);
}

template <class Visit>
void fields(Visit& visit, auto& value) requires requires {
    value.reference_mm;
}
{
    visit(value.live);
    visit(value.still_s);
    visit(value.held);
    visit(value.reference_mm);
}

template <class Visit>
void fields(Visit& visit, auto& value) requires requires {
    value.weakness;
}
{
    visit(value.parents);
    visit(value.tetrahedra);
    visit(value.corners);
    visit(value.parted);
    visit(value.most_mm);
    visit(value.weakened);
    visit(value.weakness);
    visit(value.begun);
    visit(value.stopped);
    visit(value.entropy_before_nats);
    visit(value.entropy_nats);
}

template <class Visit>
void fields(Visit& visit, auto& value) requires requires {
    value.solver;
}
{
    visit(value.nodes.positions_mm);
    visit(value.nodes.velocities_mm_per_s);
    visit(value.grabs);
    visit(value.gravity_mm_per_s2);
    visit(value.unreported_tool_work);
    visit(value.unreported_loss);
    visit(value.still_s);
    visit(value.settled_s);
    visit(value.last_kinetic);
    visit(value.last_elastic);
    visit(value.last_grab);
    visit(value.last_tether);
    visit(value.solver.made_from);
    visit(value.solver.memory);
    visit(value.region);
    visit.behind_all(value.tool, value.solver.tool, value.self, value.solver.overlaps, value.tear,
                     value.obstacles, value.solver.began_mm, value.solver.coupled,
                     value.swing_mm_per_s);
}

// The overlaps in what a checkpoint holds of surfaces or of obstacles.
auto& overlaps_in(auto& of_surfaces) {
    if constexpr (requires { of_surfaces.touch; })
        return of_surfaces.touch.overlaps;
    else
        return of_surfaces.overlaps;
}

// Passes the bytes of every field to a sink.
template <class Sink>
class Writer {
  public:
    explicit Writer(Sink& sink) : sink_(sink) {}

    void operator()(double value) { put(&value, sizeof value); }
    void operator()(bool value) { (*this)(value ? 1 : 0); }
    void operator()(int value) {
        const auto wide = static_cast<std::int64_t>(value);
        put(&wide, sizeof wide);
    }
    void operator()(const Vec3& value) { put(value.data(), sizeof value); }
    void operator()(const std::vector<Vec3>& values) { put_array(values); }
    void operator()(const std::vector<double>& values) { put_array(values); }
    void operator()(const std::vector<std::uint8_t>& values) { put_array(values); }
    template <class Record>
    void operator()(const std::vector<Record>& values) {
        put_length(values.size());
        for (const Record& value : values) put_record(value);
    }
    template <class Record>
    void operator()(const std::optional<Record>& value) {
        put_length(value ? 1 : 0);
        if (value) put_record(*value);
    }
    void behind_all(const auto& tool, const auto& made_with, const auto& self, const auto& overlaps,
                    const auto& tear, const auto& obstacles, const auto& began_mm,
                    const auto& coupled, double swing) {
        const OverlapsKept none;
        const auto kept = [&](const auto& some) { return some ? &overlaps_in(*some) : &none; };
        // No matrix of a solver that carries one on is that of a torn body.
        const std::array surfaces{kept(self), kept(obstacles)};
        const bool of_tears = std::ranges::any_of(
            surfaces, [](auto* some) { return !some->lying.empty() || !some->pads.empty(); });
        const bool of_thin_pads = any_thin(tool) || any_thin(made_with) || of_tears;
        const bool of_swing = swing > 0.0 || of_thin_pads;
        const bool of_couplings = !coupled.numbers.empty() || of_swing;
        const bool of_friction =
            obstacles || overlaps.obstacles || !began_mm.empty() || of_couplings;
        const bool of_surfaces = self || overlaps.self || tear || of_friction;
        if (!tool && !made_with && !of_surfaces) return;
        (*this)(tool);
        (*this)(made_with);
        if (!of_surfaces) return;
        (*this)(self);
        (*this)(overlaps.self);
        if (!tear && !of_friction) return;
        (*this)(tear);
        if (!of_friction) return;
        (*this)(obstacles);
        (*this)(overlaps.obstacles);
        (*this)(began_mm);
        if (!of_couplings) return;
        (*this)(coupled.pairs);
        (*this)(coupled.numbers);
        if (!of_swing) return;
        (*this)(swing);
        if (!of_thin_pads) return;
        (*this)(tool ? tool->tool.thin_pads : std::vector<ThinPad>{});
        (*this)(made_with ? made_with->tool.thin_pads : std::vector<ThinPad>{});
        if (!of_tears) return;
        for (const OverlapsKept* some : surfaces) {
            (*this)(some->lying);
            (*this)(some->pads);
        }
    }

  private:
    static bool any_thin(const auto& with_tool) {
        return with_tool && !with_tool->tool.thin_pads.empty();
    }
    void put(const void* data, std::size_t size) { sink_(data, size); }
    void put_length(std::size_t length) {
        const std::uint64_t wide = length;
        put(&wide, sizeof wide);
    }
    template <class T>
    void put_array(const std::vector<T>& values) {
        put_length(values.size());
        put(values.data(), values.size() * sizeof(T));
    }
    void put_record(int value) { (*this)(value); }
    template <class Record>
    void put_record(const Record& value) {
        fields(*this, value);
    }

    Sink& sink_;
};

[[noreturn]] void refuse(const std::string& problem) {
    throw InputError(problem, "the checkpoint of a body", "Take another one");
}

class Reader {
  public:
    explicit Reader(std::string_view bytes) : rest_(bytes) {}

    void operator()(double& value) {
        take(&value, sizeof value);
        require_finite(std::isfinite(value));
    }
    void operator()(int& value) {
        std::int64_t wide = 0;
        take(&wide, sizeof wide);
        value = static_cast<int>(wide);
        if (value != wide) refuse("holds an index of " + std::to_string(wide));
    }
    void operator()(bool& value) {
        int number = 0;
        (*this)(number);
        if (number != 0 && number != 1) refuse("has a switch that is neither on nor off");
        value = number == 1;
    }
    void operator()(Vec3& value) {
        take(value.data(), sizeof value);
        require_finite(value.allFinite());
    }
    void operator()(std::vector<Vec3>& values) {
        take_array(values);
        for (const Vec3& value : values) require_finite(value.allFinite());
    }
    void operator()(std::vector<double>& values) {
        take_array(values);
        for (const double value : values) require_finite(std::isfinite(value));
    }
    void operator()(std::vector<std::uint8_t>& values) { take_array(values); }
    template <class Record>
    void operator()(std::vector<Record>& values) {
        const std::size_t length = take_length(sizeof(std::int64_t));
        for (std::size_t i = 0; i < length; ++i) take_record(values.emplace_back());
    }
    template <class Record>
    void operator()(std::optional<Record>& value) {
        if (take_flag()) take_record(value.emplace());
    }
    void behind_all(auto& tool, auto& made_with, auto& self, auto& overlaps, auto& tear,
                    auto& obstacles, auto& began_mm, auto& coupled, double& swing) {
        if (rest_.empty()) return;
        (*this)(tool);
        (*this)(made_with);
        bool used = tool || made_with;
        if (!rest_.empty()) {
            (*this)(self);
            (*this)(overlaps.self);
            used = self || overlaps.self;
        }
        if (!rest_.empty()) {
            (*this)(tear);
            used = tear.has_value();
        }
        if (!rest_.empty()) {
            (*this)(obstacles);
            (*this)(overlaps.obstacles);
            (*this)(began_mm);
            used = obstacles || overlaps.obstacles || !began_mm.empty();
        }
        if (!rest_.empty()) {
            (*this)(coupled.pairs);
            (*this)(coupled.numbers);
            used = !coupled.numbers.empty();
        }
        if (!rest_.empty()) {
            (*this)(swing);
            used = swing > 0.0;
        }
        // Lists in braces are evaluated from left to right.
        const auto any = [](std::initializer_list<bool> some) {
            return std::ranges::any_of(some, [](bool one) { return one; });
        };
        if (!rest_.empty()) used = any({take_thin_pads(tool), take_thin_pads(made_with)});
        if (!rest_.empty()) used = any({take_tears(self), take_tears(obstacles)});
        if (!used) refuse("goes on after its end");
    }

    void expect_end() const {
        if (!rest_.empty())
            refuse("goes on for " + std::to_string(rest_.size()) + " bytes after its end");
    }

  private:
    // Whether there were any.
    bool take_thin_pads(auto& with_tool) {
        std::vector<ThinPad> thin;
        (*this)(thin);
        if (thin.empty()) return false;
        if (!with_tool) refuse("holds the pads of a tool that it has not");
        with_tool->tool.thin_pads = std::move(thin);
        return true;
    }
    bool take_tears(auto& with_surfaces) {
        OverlapsKept kept;
        (*this)(kept.lying);
        (*this)(kept.pads);
        if (kept.lying.empty() && kept.pads.empty()) return false;
        if (!with_surfaces) refuse("holds the tears of surfaces that it has not");
        overlaps_in(*with_surfaces).lying = std::move(kept.lying);
        overlaps_in(*with_surfaces).pads = std::move(kept.pads);
        return true;
    }
    void take(void* data, std::size_t size) {
        if (rest_.size() < size) refuse("is cut off");
        if (size > 0) std::memcpy(data, rest_.data(), size);
        rest_.remove_prefix(size);
    }
    std::size_t take_length(std::size_t least_size) {
        std::uint64_t length = 0;
        take(&length, sizeof length);
        if (length > rest_.size() / least_size) refuse("is cut off");
        return static_cast<std::size_t>(length);
    }
    bool take_flag() {
        std::uint64_t flag = 0;
        take(&flag, sizeof flag);
        if (flag > 1) refuse("holds " + std::to_string(flag) + " of something it has once");
        return flag == 1;
    }
    template <class T>
    void take_array(std::vector<T>& values) {
        values.resize(take_length(sizeof(T)));
        take(values.data(), values.size() * sizeof(T));
    }
    void take_record(int& value) { (*this)(value); }
    template <class Record>
    void take_record(Record& value) {
        fields(*this, value);
    }
    static void require_finite(bool finite) {
        if (!finite) refuse("holds a number that is not finite");
    }

    std::string_view rest_;
};

}  // namespace

std::uint64_t hash_of(const StepperCheckpoint& checkpoint) {
    Hasher hasher;
    const auto sink = [&](const void* data, std::size_t size) { hasher.add_bytes(data, size); };
    Writer writer(sink);
    fields(writer, checkpoint);
    return hasher.value();
}

std::uint64_t Stepper::state_hash() const {
    return hash_of(checkpoint());
}

std::string to_bytes(const StepperCheckpoint& checkpoint) {
    std::string bytes(heading);
    const auto sink = [&](const void* data, std::size_t size) {
        bytes.append(static_cast<const char*>(data), size);
    };
    Writer writer(sink);
    fields(writer, checkpoint);
    return bytes;
}

StepperCheckpoint checkpoint_from_bytes(std::string_view bytes) {
    if (!bytes.starts_with(heading)) refuse("does not begin as one");
    Reader reader(bytes.substr(heading.size()));
    StepperCheckpoint checkpoint;
    fields(reader, checkpoint);
    reader.expect_end();
    return checkpoint;
}

}  // namespace hepatica
