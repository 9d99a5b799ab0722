// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegen/import/obj_reader.hpp"
#include "tests/fuzz/targets/mesh.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::byte* data, std::size_t size) {
    dem::fuzz::reads_mesh(dem::shapegen::read_obj, {data, size});
    return 0;
}
