// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "common/shapes/wall_template.hpp"

#include <cstdint>
#include <filesystem>
#include <memory>

namespace flatbuffers {
class DetachedBuffer;
}

namespace dem {

/// Writes a `.tpl` file (docs/template-format.md), whole or not at all. The same content gives the
/// same bytes. Throws Error: a value out of range (check_template), more than the 2 GB that
/// FlatBuffers can address, the disk.
void write_template(const std::filesystem::path& path, const TemplateFile& content);

/// The same with one wall in the place of shapes; of `head` all but the shapes.
void write_template(const std::filesystem::path& path, const TemplateFile& head,
                    const WallTemplate& wall);

/// Writes a `.tpl` file shape by shape, for libraries too large to hold in two forms at once.
class TemplateBuilder {
  public:
    /// `count`: shapes that will be added, for messages.
    explicit TemplateBuilder(std::size_t count);
    ~TemplateBuilder();
    TemplateBuilder(const TemplateBuilder&) = delete;
    TemplateBuilder& operator=(const TemplateBuilder&) = delete;

    /// Checks nothing but the size: check_template() first. Throws Error beyond 2 GB.
    void add(const ParticleTemplate& shape);
    void add(const WallTemplate& wall);

    std::uint64_t byte_size() const;  ///< of the payload so far

    /// Ends the payload; of `content` all but the shapes.
    flatbuffers::DetachedBuffer finish(const TemplateFile& content);

    /// Ends the payload and writes the file.
    void write(const std::filesystem::path& path, const TemplateFile& content);

  private:
    struct Encoder;
    std::unique_ptr<Encoder> encoder_;
};

/// The payload alone, its values unchecked. Throws Error when it would exceed 2 GB.
flatbuffers::DetachedBuffer encode_template(const TemplateFile& content);

}  // namespace dem
