// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/measure/measures.hpp"

#include "common/error.hpp"
#include "runtime/measure/contact_count.hpp"
#include "runtime/measure/fill_height.hpp"
#include "runtime/measure/solid_fraction.hpp"
#include "runtime/measure/vessel.hpp"

#include <initializer_list>

namespace dem::runtime {

namespace {

using Kind = MeasureSettings::Kind;

double mean_coordination(const Simulation& simulation) {
    std::uint64_t sum = 0;
    for (const std::uint32_t number : coordination_numbers(simulation)) sum += number;
    const auto count = static_cast<double>(simulation.particles().size());
    return count > 0.0 ? static_cast<double>(sum) / count : 0.0;
}

}  // namespace

std::vector<std::string> measure_columns(const MeasureSettings& measure) {
    std::vector<std::string> columns;
    const auto add = [&](std::initializer_list<const char*> endings) {
        for (const char* ending : endings) columns.push_back(measure.name + ending);
    };
    switch (measure.kind) {
        case Kind::contacts:
            add({"_coordination"});
            break;
        case Kind::fill_height:
            add({"_highest", "_top_ten", "_surface"});
            break;
        case Kind::solid_fraction:
            add({"_solid_fraction", "_near_wall", "_core", "_bulk_density"});
            break;
    }
    return columns;
}

std::vector<std::string> measure_columns(const Scene& scene) {
    std::vector<std::string> columns;
    for (const MeasureSettings& measure : scene.measures) {
        if (measure.kind == Kind::solid_fraction && !find_vessel(scene)) {
            throw Error(scene.case_path, "[measure." + measure.name +
                                             "]: a solid fraction needs walls that form a vessel: "
                                             "an upright inside cylinder or box with a floor");
        }
        const auto own = measure_columns(measure);
        columns.insert(columns.end(), own.begin(), own.end());
    }
    return columns;
}

std::vector<double> measure_values(const Simulation& simulation, const MeasureSettings& measure) {
    const Scene& scene = simulation.scene();
    switch (measure.kind) {
        case Kind::contacts:
            return {mean_coordination(simulation)};
        case Kind::fill_height: {
            const FillHeight h = fill_height(simulation.particles(), scene);
            return {h.highest, h.top_ten, h.surface};
        }
        case Kind::solid_fraction: {
            const double top =
                measure.top ? *measure.top : fill_height(simulation.particles(), scene).surface;
            const SolidFraction f = solid_fraction(simulation.particles(), scene,
                                                   *find_vessel(scene), {measure.bottom, top});
            return {f.overall, f.near_wall, f.core, f.bulk_density};
        }
    }
    return {};
}

}  // namespace dem::runtime
