// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

#include <gtest/gtest.h>
#include <unistd.h>

namespace dem {

/// A fixture with an empty folder of its own.
class TemporaryFolder : public testing::Test {
  protected:
    TemporaryFolder() {
        const auto* info = testing::UnitTest::GetInstance()->current_test_info();
        folder_ =
            std::filesystem::temp_directory_path() / ("dem-" + std::to_string(getpid()) + "-" +
                                                      info->test_suite_name() + "-" + info->name());
        std::filesystem::remove_all(folder_);
        std::filesystem::create_directories(folder_);
    }
    ~TemporaryFolder() override { std::filesystem::remove_all(folder_); }

    std::string text(const std::string& name) const {
        std::ifstream in(folder_ / name, std::ios::binary);
        std::ostringstream content;
        content << in.rdbuf();
        return content.str();
    }
    void write(const std::string& name, std::string_view content) const {
        std::ofstream(folder_ / name, std::ios::binary) << content;
    }

    std::filesystem::path folder_;
};

/// The message of the dem::Error that `call` throws, "" if it throws none.
template <class ErrorType, class Call>
std::string message_of(Call call) {
    try {
        call();
    } catch (const ErrorType& e) {
        return e.what();
    }
    return "";
}

}  // namespace dem
