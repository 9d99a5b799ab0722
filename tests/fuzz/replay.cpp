// SPDX-License-Identifier: BSD-3-Clause
// The main function of a fuzz target in an ordinary build: reads the files and the files of the
// folders that are its arguments, one after the other.
#include "tests/fuzz/promise.hpp"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <vector>

namespace {

void replay(const std::filesystem::path& path) {
    std::ifstream stream(path, std::ios::binary);
    const std::vector<char> bytes{std::istreambuf_iterator<char>(stream), {}};
    std::printf("%s\n", path.filename().c_str());
    std::fflush(stdout);  // names the file if reading it ends the program
    LLVMFuzzerTestOneInput(reinterpret_cast<const std::byte*>(bytes.data()), bytes.size());
}

}  // namespace

int main(int argc, char** argv) {
    std::vector<std::filesystem::path> files;
    for (const std::filesystem::path argument :
         std::span(argv, static_cast<std::size_t>(argc)).subspan(1)) {
        if (std::filesystem::is_directory(argument)) {
            for (const auto& entry : std::filesystem::directory_iterator(argument))
                files.push_back(entry.path());
        } else {
            files.push_back(argument);
        }
    }
    std::sort(files.begin(), files.end());
    for (const auto& file : files) replay(file);
    std::printf("%zu inputs\n", files.size());
    return files.empty() ? 1 : 0;
}
