// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegen/pipeline/generate.hpp"

#include "common/error.hpp"
#include "common/state_hash.hpp"
#include "common/threads/thread_team.hpp"
#include "formats/template_check.hpp"
#include "formats/template_header.hpp"
#include "formats/template_writer.hpp"
#include "shapegen/pipeline/cook_convex.hpp"

#include <algorithm>
#include <array>
#include <cstdio>

namespace dem::shapegen {

namespace {

constexpr std::uint64_t block_size = 4096;  // grains that are in memory in two forms

std::string grain_name(const GranularOptions& grains, std::uint64_t index) {
    std::array<char, 40> text{};
    std::snprintf(text.data(), text.size(), "%s_%06llu",
                  grains.kind == GranularOptions::Kind::sand ? "sand" : "woodchip",
                  static_cast<unsigned long long>(index));
    return text.data();
}

ParticleTemplate grain_template(const GranularOptions& options, std::uint64_t index, int& redrawn) {
    Grain grain = make_grain(options, index);
    redrawn = grain.redrawn;
    const double d_eq = grain.solid.shape.equivalent_diameter;
    const Certificate certificate = {
        {"rounding", grain.solid.shape.rounding / d_eq},
        {"rounding_loss", grain.solid.rounding_loss},
        {"display_mesh_error_max", grain.display_mesh.max_deviation / d_eq}};
    ParticleTemplate shape = convex_template(std::move(grain.solid), grain_name(options, index));
    shape.certificate = certificate;
    shape.display_mesh = std::move(grain.display_mesh);
    return shape;
}

/// Grains begin .. begin + shapes.size() - 1.
void make_block(const LibraryRequest& request, const std::filesystem::path& path,
                std::uint64_t begin, std::vector<ParticleTemplate>& shapes,
                LibrarySummary& summary) {
    std::vector<int> redrawn(shapes.size(), 0);
    share_each(shapes.size(), 1, [&](std::size_t k) {
        shapes[k] = grain_template(request.grains, begin + k, redrawn[k]);
        check_template(shapes[k], shape_place(path.string(), begin + k, shapes[k].name));
    });
    for (const int count : redrawn) summary.redrawn += static_cast<std::uint64_t>(count);
}

/// Hash of all that a library follows from.
std::uint64_t hash_of(const LibraryRequest& request) {
    const GranularOptions& grains = request.grains;
    const Rounding rounding = grains.rounding.value_or(Rounding{});
    const std::array counts{static_cast<std::uint64_t>(grains.kind),
                            static_cast<std::uint64_t>(grains.base), grains.seed, request.count,
                            std::uint64_t{rounding.is_share}};
    const std::array lengths{grains.size, rounding.value};
    StateHash hash;
    hash.add(std::span<const std::uint64_t>(counts));
    hash.add(std::span<const double>(lengths));
    return hash.value();
}

/// After the first block, which tells how large a grain is.
void check_size(std::uint64_t count, std::uint64_t made, std::uint64_t bytes,
                const std::filesystem::path& path) {
    constexpr double margin = 0.98;
    const double each = static_cast<double>(bytes) / static_cast<double>(made);
    const double most = margin * static_cast<double>(largest_template_payload) / each;
    if (static_cast<double>(count) <= most) return;
    std::array<char, 200> text{};
    std::snprintf(text.data(), text.size(),
                  "found %llu shapes, expected at most %.0f: a template holds 2 GB, each of these "
                  "takes %.0f bytes; write several, each with its own --seed",
                  static_cast<unsigned long long>(count), std::floor(most / 1000.0) * 1000.0, each);
    throw Error(path.string(), text.data());
}

}  // namespace

LibrarySummary generate_library(const LibraryRequest& request, const std::filesystem::path& path) {
    TemplateBuilder builder(request.count);
    LibrarySummary summary;
    std::vector<ParticleTemplate> shapes;
    for (std::uint64_t begin = 0; begin < request.count; begin += block_size) {
        if (request.progress)
            request.progress(static_cast<double>(begin) / static_cast<double>(request.count),
                             std::to_string(begin) + " shapes");
        shapes.resize(std::min(block_size, request.count - begin));
        make_block(request, path, begin, shapes, summary);
        for (const ParticleTemplate& shape : shapes) {
            builder.add(shape);
            const double volume = shape.mass_properties.volume;
            const bool is_first = summary.mean == 0.0;
            summary.smallest = is_first ? volume : std::min(summary.smallest, volume);
            summary.largest = std::max(summary.largest, volume);
            summary.mean += volume;
            const auto& convex = std::get<ConvexShape>(shape.shape);
            summary.mean_vertices += static_cast<double>(convex.vertices.size());
            summary.surface_deviation =
                std::max(summary.surface_deviation,
                         shape.display_mesh.max_deviation / convex.equivalent_diameter);
        }
        if (begin == 0) check_size(request.count, shapes.size(), builder.byte_size(), path);
    }
    summary.mean /= static_cast<double>(request.count);
    summary.mean_vertices /= static_cast<double>(request.count);
    TemplateFile content;
    content.command = request.command;
    content.input_hash = hash_of(request);
    content.shapegen_version = DEM_VERSION;
    builder.write(path, content);
    return summary;
}

}  // namespace dem::shapegen
