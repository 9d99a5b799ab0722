// SPDX-License-Identifier: BSD-3-Clause
// Checkpoints in both halves of their reader. The bytes as a file: HDF5 sees none that the checksum
// does not pass. The bytes as changes to the arrays of a sound checkpoint, loaded into a simulation
// that then goes on for a step: what a file would hold whose checksum was made to fit.
#include "common/atomic_file.hpp"
#include "runtime/case/read_scene.hpp"
#include "runtime/checkpoint/state_archive.hpp"
#include "runtime/simulation.hpp"
#include "tests/fuzz/promise.hpp"

#include <array>
#include <cstring>
#include <iterator>

namespace dem::fuzz {

using namespace runtime;

namespace {

constexpr double time_step = 1e-6;  // [s]

const Scene& scene() {
    static const Scene one =
        read_scene(parse_case("[run]\n"
                              "end_time = 1\n"
                              "[material.m]\n"
                              "density = 1000\n"
                              "youngs_modulus = 1e6\n"
                              "poissons_ratio = 0.3\n"
                              "[contact]\n"
                              "restitution = 0.5\n"
                              "friction = 0.5\n"
                              "[particles.a]\n"
                              "radius = 5 mm\n"
                              "material = m\n"
                              "count = 3\n"
                              "insert = lattice\n"
                              "region = box 0 0 0  40 20 20 mm\n"
                              "velocity = 0 0 -1\n"
                              "[wall.floor]\n"
                              "shape = plane\n"
                              "point = 0 0 0\n"
                              "normal = 0 0 1\n"
                              "material = m\n",
                              "x.ini"));
    return one;
}

Checkpoint sound_checkpoint() {
    Simulation simulation(scene(), time_step);
    while (simulation.largest_overlap().relative == 0.0) simulation.step();
    StateWriter writer;
    simulation.save(writer);
    return writer.take();
}

/// Takes the bytes for instructions: an array, what to do with it, where, and with what.
void change(Checkpoint& checkpoint, Bytes& bytes) {
    constexpr std::size_t size = 4;
    const auto number = [&](std::size_t k) { return std::to_integer<std::size_t>(bytes[k]); };
    const auto entry =
        std::next(checkpoint.begin(), static_cast<std::ptrdiff_t>(number(0) % checkpoint.size()));
    PlainValues& values = entry->second;
    const std::size_t action = number(1) % 8;
    const std::size_t at = number(2) | number(3) << 8U;
    bytes = bytes.subspan(size);
    if (action == 0) {
        checkpoint.erase(entry);
    } else if (action == 1) {
        values.type += "?";
    } else if (action == 2) {
        values.bytes.resize(at % 64 * values.value_bytes);
    } else if (!values.bytes.empty()) {
        const std::size_t room = values.bytes.size() - at % values.bytes.size();
        const std::size_t count = std::min({room, bytes.size(), std::size_t{8}});
        std::memcpy(values.bytes.data() + at % values.bytes.size(), bytes.data(), count);
        bytes = bytes.subspan(count);
    }
}

void load(const Checkpoint& checkpoint, Simulation& simulation) {
    StateReader reader(checkpoint, "checkpoint.h5");
    simulation.load(reader);
    reader.finish();
}

/// Bodies that were moved may overlap or be lost, of which the step tells.
void go_on(Simulation& simulation) {
    try {
        simulation.step();
    } catch (const Error&) {
        return;
    }
    for (const Vec3& x : simulation.particles().position) promise_finite(x, "a position");
}

}  // namespace
}  // namespace dem::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::byte* data, std::size_t size) {
    using namespace dem;
    using namespace dem::runtime;
    static const std::string path = fuzz::scratch_folder() + "/checkpoint.h5";
    static const std::array<std::string, 2> places = {path, "checkpoint.h5"};
    static const Checkpoint sound = fuzz::sound_checkpoint();
    fuzz::Bytes bytes(data, size);
    fuzz::accepts(places, [&] {
        write_file(path, fuzz::as_text(bytes));
        read_checkpoint(path);
    });
    Checkpoint changed = sound;
    while (bytes.size() >= 4 && !changed.empty()) fuzz::change(changed, bytes);
    Simulation simulation(fuzz::scene(), fuzz::time_step);
    if (fuzz::accepts(places, [&] { fuzz::load(changed, simulation); })) fuzz::go_on(simulation);
    return 0;
}
