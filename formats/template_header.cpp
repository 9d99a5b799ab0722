// SPDX-License-Identifier: BSD-3-Clause
#include "formats/template_header.hpp"

#include "common/error.hpp"
#include "common/file_hash.hpp"
#include "common/state_hash.hpp"

#include <algorithm>
#include <bit>
#include <cstring>

namespace dem {

namespace {

static_assert(std::endian::native == std::endian::little,
              "templates are mapped as they are: a big-endian machine needs a reader that swaps");

constexpr char magic[] = {'D', 'E', 'M', 'T', 'P', 'L', '\r', '\n'};
constexpr std::size_t version_at = 8;
constexpr std::size_t header_size_at = 12;
constexpr std::size_t payload_size_at = 16;
constexpr std::size_t checksum_at = 24;

template <class T>
T load(std::span<const std::byte> file, std::size_t at) {
    T value;
    std::memcpy(&value, file.data() + at, sizeof value);
    return value;
}

std::uint64_t checksum(std::span<const std::byte> payload, std::uint32_t version) {
    if (version > 1) return file_hash(payload);
    StateHash hash;
    hash.add_bytes(payload);
    return hash.value();
}

}  // namespace

std::array<std::byte, template_header_size> template_header(std::span<const std::byte> payload) {
    std::array<std::byte, template_header_size> header;
    const auto header_size = static_cast<std::uint32_t>(template_header_size);
    const std::uint64_t payload_size = payload.size();
    const std::uint64_t sum = checksum(payload, template_format_version);
    std::memcpy(header.data(), magic, sizeof magic);
    std::memcpy(header.data() + version_at, &template_format_version, 4);
    std::memcpy(header.data() + header_size_at, &header_size, 4);
    std::memcpy(header.data() + payload_size_at, &payload_size, 8);
    std::memcpy(header.data() + checksum_at, &sum, 8);
    return header;
}

std::span<const std::byte> template_payload(std::span<const std::byte> file,
                                            const std::string& where) {
    if (file.empty()) throw Error(where, "is empty, expected a template made by shapegen");
    const std::size_t known = std::min(file.size(), sizeof magic);
    if (std::memcmp(file.data(), magic, known) != 0) {
        throw Error(where, "is not a template, expected a .tpl file made by shapegen");
    }
    if (file.size() < template_header_size) {
        throw Error(where, "is truncated: it has " + std::to_string(file.size()) +
                               " bytes, expected a header of 32 and more");
    }
    const auto version = load<std::uint32_t>(file, version_at);
    if (version < 1 || version > template_format_version) {
        throw Error(where, "is of format version " + std::to_string(version) +
                               ", this program reads versions 1 to " +
                               std::to_string(template_format_version) +
                               ": make it again with this shapegen");
    }
    const auto size = load<std::uint64_t>(file, payload_size_at);
    const std::span<const std::byte> payload = file.subspan(template_header_size);
    if (payload.size() != size) {
        throw Error(where, std::string(payload.size() < size ? "is truncated" : "is too long") +
                               ": it has " + std::to_string(payload.size()) +
                               " bytes after its header, expected " + std::to_string(size));
    }
    if (load<std::uint32_t>(file, header_size_at) != template_header_size ||
        load<std::uint64_t>(file, checksum_at) != checksum(payload, version)) {
        throw Error(where, "is damaged: its checksum does not match, copy or make it again");
    }
    return payload;
}

}  // namespace dem
