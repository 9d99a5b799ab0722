// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/files/run_summary.hpp"

#include "common/atomic_file.hpp"

#include <cinttypes>
#include <cstdio>
#include <fstream>

#include <nlohmann/json.hpp>

namespace dem::runtime {

namespace {

// A 64-bit number would lose its last digits in readers that know doubles only.
std::string hexadecimal(std::uint64_t hash) {
    char text[17];
    std::snprintf(text, sizeof text, "%016" PRIx64, hash);
    return text;
}

}  // namespace

void write_summary(const std::filesystem::path& path, const RunSummary& summary) {
    using Json = nlohmann::ordered_json;
    Json measures = Json::object();
    for (const auto& [name, value] : summary.measures) measures[name] = value;
    Json missing = Json::object();
    for (const auto& [group, count] : summary.missing) missing[group] = count;
    Json outlets = Json::object();
    for (const OutletSummary& outlet : summary.outlets)
        outlets[outlet.name] = {
            {"kind", outlet.kind}, {"bodies", outlet.bodies}, {"mass", outlet.mass}};
    Json inputs = Json::object();
    for (const auto& [name, input_hash] : summary.inputs) inputs[name] = hexadecimal(input_hash);
    const Json json = {{"case", summary.case_path},
                       {"end", summary.end},
                       {"reason", summary.reason},
                       {"steps", summary.steps},
                       {"time", summary.time},
                       {"time_step", summary.time_step},
                       {"particles", summary.particles},
                       {"missing", missing},
                       {"outlets", outlets},
                       {"core_overlaps", summary.core_overlaps},
                       {"wall_time", summary.wall_time},
                       {"measure_time", summary.measure_time},
                       {"output_time", summary.output_time},
                       {"microseconds_per_particle_step", summary.microseconds_per_particle_step},
                       {"threads", summary.threads},
                       {"threads_used", summary.threads_used},
                       {"lanes", summary.lanes},
                       {"seed", summary.seed},
                       {"state_hash", hexadecimal(summary.state_hash)},
                       {"measures", measures},
                       {"inputs", inputs},
                       {"versions", {{"shapedem", DEM_VERSION}, {"compiler", __VERSION__}}}};
    write_file(path, json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n");
}

bool tells_of(const std::filesystem::path& path, const RunSummary& summary) {
    std::ifstream in(path);
    const auto json = nlohmann::json::parse(in, nullptr, false);
    if (!json.is_object()) return false;
    const auto says = [&](const char* key, const std::string& value) {
        const auto entry = json.find(key);
        return entry != json.end() && *entry == value;
    };
    return says("end", summary.end) && says("reason", summary.reason) &&
           says("state_hash", hexadecimal(summary.state_hash));
}

}  // namespace dem::runtime
