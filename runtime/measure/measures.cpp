// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/measure/measures.hpp"

#include "common/error.hpp"
#include "runtime/measure/contact_count.hpp"
#include "runtime/measure/fill_height.hpp"
#include "runtime/measure/solid_fraction.hpp"
#include "runtime/measure/vessel.hpp"

namespace dem {

namespace {

using Kind = MeasureSettings::Kind;

double mean_coordination(const Simulation& simulation) {
    std::uint64_t sum = 0;
    for (const std::uint32_t number : coordination_numbers(simulation)) sum += number;
    const auto count = static_cast<double>(simulation.particles().size());
    return count > 0.0 ? static_cast<double>(sum) / count : 0.0;
}

}  // namespace

std::vector<std::string> measure_columns(const Scene& scene) {
    std::vector<std::string> columns;
    for (const MeasureSettings& measure : scene.measures) {
        if (measure.kind == Kind::fill_height) {
            for (const char* way : {"_highest", "_top_ten", "_surface"}) {
                columns.push_back(measure.name + way);
            }
            continue;
        }
        if (measure.kind == Kind::solid_fraction && !find_vessel(scene)) {
            throw Error(scene.case_path, "[measure." + measure.name +
                                             "]: a solid fraction needs walls that form a vessel: "
                                             "an upright inside cylinder or box with a floor");
        }
        if (measure.kind == Kind::contacts) {
            columns.push_back(measure.name + "_coordination");
            continue;
        }
        for (const char* where : {"_solid_fraction", "_near_wall", "_core", "_bulk_density"}) {
            columns.push_back(measure.name + where);
        }
    }
    return columns;
}

std::vector<double> measure_values(const Simulation& simulation) {
    std::vector<double> values;
    for (const MeasureSettings& measure : simulation.scene().measures) {
        switch (measure.kind) {
            case Kind::contacts:
                values.push_back(mean_coordination(simulation));
                break;
            case Kind::fill_height: {
                const FillHeight h = fill_height(simulation.particles(), simulation.scene());
                values.insert(values.end(), {h.highest, h.top_ten, h.surface});
                break;
            }
            case Kind::solid_fraction: {
                const Scene& scene = simulation.scene();
                const double top =
                    measure.top ? *measure.top : fill_height(simulation.particles(), scene).surface;
                const SolidFraction f = solid_fraction(simulation.particles(), scene,
                                                       *find_vessel(scene), {measure.bottom, top});
                values.insert(values.end(), {f.overall, f.near_wall, f.core, f.bulk_density});
                break;
            }
        }
    }
    return values;
}

}  // namespace dem
