// SPDX-License-Identifier: BSD-3-Clause
// [run], [material.NAME], [outlet.NAME], [output] and [measure.NAME]: sections that stand for
// themselves.
#include "common/error.hpp"
#include "common/text.hpp"
#include "runtime/case/scene_sections.hpp"

namespace dem::runtime {

RunSettings read_run(const Values& values) {
    RunSettings run;
    run.end_time = values.number("end_time");
    run.time_step = values.optional_number("time_step");
    run.time_step_divisor = values.number("time_step_divisor");
    run.time_step_force = values.yes_no("time_step_force");
    run.gravity = values.vector("gravity");
    run.seed = values.count("seed");
    run.threads = static_cast<int>(values.count("threads"));
    run.stop_at_rest = values.word("stop") == "at_rest";
    run.overlap_limit = values.number("overlap_limit");
    run.skin = values.optional_number("skin");
    run.domain_exit = values.choice<DomainExit>("domain_exit");
    if (run.time_step && *run.time_step > run.end_time) {
        throw Error(values.where("time_step"),
                    "found " + in_quotes(values.text("time_step")) +
                        ", expected less than end_time = " + in_quotes(values.text("end_time")));
    }
    if (values.has("domain")) {
        const Region region = values.region("domain");
        const auto* box = std::get_if<BoxRegion>(&region);
        if (box == nullptr) {
            throw Error(values.where("domain"), "found a cylinder, expected 'box x y z  x y z'");
        }
        run.domain = box->box;
    }
    return run;
}

Material read_material(const Values& values) {
    Material material;
    material.name = own_name(values.section_name());
    material.density = values.optional_number("density").value_or(0.0);
    material.poissons_ratio = values.number("poissons_ratio");
    const bool has_shear = values.has("shear_modulus");
    if (has_shear == values.has("youngs_modulus")) {
        throw Error(has_shear ? values.where("shear_modulus") : values.section_where(),
                    std::string(has_shear ? "both" : "neither") +
                        " youngs_modulus and shear_modulus in [" + values.section_name() +
                        "], expected one of them");
    }
    material.youngs_modulus =
        has_shear ? 2.0 * values.number("shear_modulus") * (1.0 + material.poissons_ratio)
                  : values.number("youngs_modulus");
    return material;
}

Outlet read_outlet(const Values& values) {
    Outlet outlet;
    outlet.name = own_name(values.section_name());
    outlet.where = values.section_where();
    outlet.kind = values.choice<Outlet::Kind>("kind");
    const bool has_region = outlet.kind == Outlet::Kind::remove && values.has("region");
    if (has_region) {
        for (const char* key : {"point", "normal"}) {
            if (!values.has(key)) continue;
            throw Error(values.where(key), "found a plane beside 'region' in [" +
                                               values.section_name() + "], expected one of them");
        }
        const Region region = values.region("region");
        std::visit([&](const auto& place) { outlet.place = place; }, region);
        return outlet;
    }
    for (const char* key : {"point", "normal"}) {
        if (values.has(key)) continue;
        throw Error(
            values.section_where(),
            "no " + in_quotes(key) + " in [" + values.section_name() + "], expected " +
                (outlet.kind == Outlet::Kind::remove ? "a plane (point and normal) or a region"
                                                     : "a plane (point and normal)"));
    }
    outlet.place = HalfSpace{values.vector("point"), values.direction("normal")};
    if (outlet.kind == Outlet::Kind::flow)
        outlet.radius = values.optional_number("radius").value_or(outlet.radius);
    return outlet;
}

// Ten million frames would be terabytes of a small bed.
constexpr double most_samples = 1e7;

OutputSettings read_output(const Values& values, const RunSettings& run) {
    OutputSettings output;
    output.frames_every = values.optional_number("frames_every");
    output.history_every = values.optional_number("history_every");
    for (const char* key : {"frames_every", "history_every"}) {
        const double count = run.end_time / values.optional_number(key).value_or(run.end_time);
        if (count <= most_samples) continue;
        throw Error(values.where(key),
                    "makes more than ten million samples until end_time, "
                    "expected a longer interval");
    }
    output.checkpoint_every = values.number("checkpoint_every");
    output.wall_forces = values.choice<WallForceColumns>("wall_forces");
    output.surfaces = values.yes_no("surfaces");
    output.contacts = values.yes_no("contacts");
    output.wall_contacts = values.yes_no("wall_contacts");
    output.picture = values.yes_no("picture");
    return output;
}

MeasureSettings read_measure(const Values& values) {
    MeasureSettings measure;
    measure.name = own_name(values.section_name());
    measure.kind = values.choice<MeasureSettings::Kind>("kind");
    measure.every = values.optional_number("every");
    if (measure.kind == MeasureSettings::Kind::solid_fraction) {
        measure.bottom = values.number("bottom");
        measure.top = values.optional_number("top");
        if (measure.top && *measure.top <= measure.bottom)
            throw Error(values.where("top"),
                        "found " + in_quotes(values.text("top")) +
                            ", expected more than bottom = " + in_quotes(values.text("bottom")));
    }
    return measure;
}

}  // namespace dem::runtime
