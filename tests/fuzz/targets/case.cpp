// SPDX-License-Identifier: BSD-3-Clause
// Case files, read into a scene. A template "t.tpl" with a sphere, a surface of revolution, a clump
// and a polyhedron and a table "b.csv" of two bodies are at hand. What follows a zero byte is put
// over the case as `--set` does.
#include "common/atomic_file.hpp"
#include "runtime/case/read_scene.hpp"
#include "runtime/case/region.hpp"
#include "runtime/time_step.hpp"
#include "tests/formats/sample_template.hpp"
#include "tests/fuzz/promise.hpp"

#include <array>

namespace dem::fuzz {

using namespace runtime;

namespace {

std::string make_folder() {
    const std::string& folder = scratch_folder();
    const sample::Bytes file = sample::unchecked(sample::file());
    write_file(folder + "/t.tpl", as_text(file.bytes));
    write_file(folder + "/b.csv", "template,x,y,z\nball,0,0,0.01\nring,0.01,0,0.01\n");
    return folder;
}

void look_at(const Wall& wall) {
    for (const double time : {0.0, 0.37}) {
        const WallState state = wall_state(wall, time);
        promise_finite(state.position, "the position of a wall");
        promise_finite(state.body.velocity, "the velocity of a wall");
        promise(std::abs(state.body.orientation.norm() - 1.0) < 1e-9, "a wall is turned");
    }
}

void look_at(const InsertionGroup& group, const Scene& scene) {
    promise(group.count > 0, "a group has bodies");
    promise(!group.kinds.empty(), "a group has kinds");
    for (const std::uint32_t kind : group.kinds)
        promise(kind < scene.kinds.size(), "a kind is one");
    promise_finite(group.velocity, "the velocity of a group");
    promise_finite(group.angular_velocity, "the spin of a group");
    promise_finite(group.start, "the start of a group");
    promise(group.batch > 0 && group.every >= 0.0, "batches come");
    for (const BodyPlacement& body : group.placements) promise_finite(body.position, "a place");
    if (group.mode == InsertionGroup::Mode::file) return;
    promise_positive(volume(group.region), "the volume of a region");
    promise_finite(bounds(group.region).lower, "a region");
    promise_finite(bounds(group.region).upper, "a region");
}

void look_at(const Scene& scene) {
    promise_positive(scene.run.end_time, "the end time");
    promise_finite(scene.run.gravity, "gravity");
    promise(!scene.kinds.empty() && !scene.insertions.empty(), "a scene has bodies");
    for (const BodyKind& kind : scene.kinds) {
        promise_positive(kind.mass, "a mass");
        for (int i = 0; i < 3; ++i) promise_positive(kind.inertia[i], "a moment of inertia");
        promise_finite(kind.inverse_inertia.mass, "one over a mass");
        promise_finite(kind.inverse_inertia.moments, "one over a moment of inertia");
    }
    for (const Wall& wall : scene.walls) look_at(wall);
    for (const InsertionGroup& group : scene.insertions) look_at(group, scene);
    if (scene.output.frames_every)
        promise_positive(*scene.output.frames_every, "the time between frames");
    if (scene.output.history_every)
        promise_positive(*scene.output.history_every, "the time between rows");
    promise_positive(time_step(scene).value, "the time step");
}

}  // namespace
}  // namespace dem::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::byte* data, std::size_t size) {
    using namespace dem;
    using namespace dem::runtime;
    static const std::string folder = fuzz::make_folder();
    static const std::array<std::string, 2> places = {folder + "/", "--set"};
    const std::string_view text = fuzz::as_text({data, size});
    const std::size_t end = std::min(text.find('\0'), size);
    fuzz::accepts(places, [&] {
        CaseFile file = parse_case(text.substr(0, end), folder + "/case.ini");
        if (end < size) override_value(file, text.substr(end + 1));
        fuzz::look_at(read_scene(file));
    });
    return 0;
}
