// SPDX-License-Identifier: BSD-3-Clause
#include "common/error.hpp"
#include "runtime/files/history_writer.hpp"
#include "runtime/files/run_summary.hpp"
#include "tests/formats/temporary_folder.hpp"

#include <limits>

#include <nlohmann/json.hpp>

namespace dem::runtime {
namespace {

using RunOutput = TemporaryFolder;

TEST_F(RunOutput, EveryHistoryRowIsOnTheDiskAsSoonAsItIsWritten) {
    HistoryWriter history(folder_ / "history.csv", std::vector<std::string>{"time", "step"});
    EXPECT_EQ(text("history.csv"), "time,step\n");
    history.append(std::vector<std::optional<double>>{0.1, 1e6});
    EXPECT_EQ(text("history.csv"), "time,step\n0.1,1000000\n");
    history.append(std::vector<std::optional<double>>{0.2, {}});
    EXPECT_EQ(text("history.csv"), "time,step\n0.1,1000000\n0.2,\n");
}

TEST_F(RunOutput, AHistoryThatCannotBeWrittenIsAnError) {
    const std::vector<std::string> columns = {"time"};
    EXPECT_EQ(
        message_of<Error>([&] { HistoryWriter(folder_ / "no" / "history.csv", columns); }),
        (folder_ / "no" / "history.csv").string() + ": cannot write: No such file or directory");
    EXPECT_EQ(message_of<Error>([&] { HistoryWriter("/dev/full", columns); }),
              "/dev/full: cannot write: No space left on device");
}

TEST_F(RunOutput, TheSummaryIsReadableJsonWhateverTheNumbersAre) {
    RunSummary summary;
    summary.case_path = "case.ini";
    summary.steps = 20000000;
    summary.time = 4.0;
    summary.state_hash = 0xfedcba9876543210ULL;
    summary.measures = {{"height", 0.0668}, {"bad", std::numeric_limits<double>::quiet_NaN()}};
    write_summary(folder_ / "summary.json", summary);
    const auto json = nlohmann::json::parse(text("summary.json"));
    EXPECT_EQ(json["steps"], 20000000);
    EXPECT_EQ(json["state_hash"], "fedcba9876543210");
    EXPECT_EQ(json["measures"]["height"], 0.0668);
    EXPECT_TRUE(json["measures"]["bad"].is_null());
    EXPECT_EQ(json["versions"]["shapedem"], DEM_VERSION);
}

}  // namespace
}  // namespace dem::runtime
