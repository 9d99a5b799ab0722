// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegen/certificate/clump_certificate.hpp"

namespace dem::shapegen {

Certificate clump_certificate(const BuiltClump& clump, const MassBalance& masses,
                              std::size_t components, double display_mesh_error) {
    const ClumpQuality& q = clump.quality;
    return {{"coverage", q.coverage},
            {"outside", q.outside},
            {"volume_ratio", q.volume_ratio},
            {"rms_deviation", q.rms_deviation},
            {"max_deviation_in", q.max_deviation_in},
            {"max_deviation_out", q.max_deviation_out},
            {"moment_errors_x", q.moment_errors.x()},
            {"moment_errors_y", q.moment_errors.y()},
            {"moment_errors_z", q.moment_errors.z()},
            {"slope_rms", q.slope_rms * 180.0 / pi},
            {"ceiling", clump.ceiling},
            {"components", static_cast<double>(components)},
            {"mass_tolerance", masses.tolerance},
            {"mass_product_tolerance", masses.product_tolerance},
            {"mass_center_tolerance", masses.center_tolerance},
            {"display_mesh_error_max", display_mesh_error}};
}

}  // namespace dem::shapegen
