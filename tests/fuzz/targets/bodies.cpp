// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/files/body_table.hpp"
#include "tests/fuzz/promise.hpp"

#include <array>

extern "C" int LLVMFuzzerTestOneInput(const std::byte* data, std::size_t size) {
    using namespace dem;
    using namespace dem::runtime;
    static const std::array<std::string, 1> places = {"x.csv:"};
    fuzz::accepts(places, [&] {
        const auto rows = parse_body_table(fuzz::as_text({data, size}), "x.csv");
        fuzz::promise(!rows.empty(), "a table holds bodies");
        for (const BodyRow& row : rows) {
            fuzz::promise_finite(row.position, "a position");
            fuzz::promise_finite(row.velocity, "a velocity");
            fuzz::promise_finite(row.angular_velocity, "an angular velocity");
            fuzz::promise(std::abs(row.orientation.norm() - 1.0) < 1e-9, "an orientation is unit");
            fuzz::promise(row.line > 0, "a body has a line");
        }
    });
    return 0;
}
