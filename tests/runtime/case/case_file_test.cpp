// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/case/case_file.hpp"

#include "common/error.hpp"
#include "common/random.hpp"

#include <gtest/gtest.h>

namespace dem::runtime {
namespace {

constexpr const char* small_case =
    "# a comment\n"
    "[run]\n"
    "end_time = 4 s      # seconds\n"
    "gravity=0 0 -9.81\r\n"
    "\n"
    "[contact.coating.steel] ; a pair\n"
    "friction\t=\t0.22\n"
    "file = a#1;2.csv\n";

std::string message_of(const std::string& text) {
    try {
        parse_case(text, "c.ini");
    } catch (const Error& error) {
        return error.what();
    }
    return "no error";
}

TEST(CaseFile, KeepsOrderValuesAndLines) {
    const CaseFile file = parse_case(small_case, "c.ini");
    ASSERT_EQ(file.sections.size(), 2U);
    EXPECT_EQ(file.sections[0].name, "run");
    EXPECT_EQ(file.sections[0].where, "c.ini:2");
    EXPECT_EQ(file.sections[1].name, "contact.coating.steel");
    EXPECT_EQ(file.find("run")->find("end_time")->value, "4 s");
    EXPECT_EQ(file.find("run")->find("gravity")->value, "0 0 -9.81");
    EXPECT_EQ(file.find("run")->find("gravity")->where, "c.ini:4");
    EXPECT_EQ(file.sections[1].find("friction")->value, "0.22");
    EXPECT_EQ(file.find("wall.a"), nullptr);
    EXPECT_EQ(file.find("run")->find("seed"), nullptr);
}

TEST(CaseFile, ACommentMarkInsideAWordIsPartOfTheValue) {
    const CaseFile file = parse_case(small_case, "c.ini");
    EXPECT_EQ(file.sections[1].find("file")->value, "a#1;2.csv");
}

TEST(CaseFile, AByteOrderMarkIsSkipped) {
    EXPECT_EQ(parse_case("\xEF\xBB\xBF[run]\n", "c.ini").sections[0].name, "run");
}

TEST(CaseFile, EveryErrorNamesTheLine) {
    EXPECT_EQ(message_of("[run]\n\nend_time\n"),
              "c.ini:3: found 'end_time', expected 'key = value' or '[section]'");
    EXPECT_EQ(message_of("[run]\na = 1\nb = 2\na = 3\n"),
              "c.ini:4: key 'a' given twice in [run], expected it once (first at c.ini:2)");
    EXPECT_EQ(message_of("[run]\n[wall.a]\n[run]\n"),
              "c.ini:3: section [run] given twice, expected it once (first at c.ini:1)");
    EXPECT_EQ(message_of("a = 1\n"),
              "c.ini:1: key 'a' before any section, expected [run] or another above it");
    EXPECT_EQ(message_of("[run\n"), "c.ini:1: no ']' at the end of '[run', expected [section]");
    EXPECT_EQ(message_of("[run]\nseed = # none\n"),
              "c.ini:2: no value for key 'seed', expected 'key = value'");
    EXPECT_NE(message_of("[wall..a]\n").find("c.ini:1: bad section name"), std::string::npos);
    EXPECT_NE(message_of("[run]\nend time = 3\n").find("c.ini:2: bad key"), std::string::npos);
}

TEST(CaseFile, AnEmptyOrBinaryFileIsNoCase) {
    for (const std::string text : {"", "\n\n", "# only a comment\n"}) {
        EXPECT_EQ(message_of(text),
                  "c.ini: found no section, expected a case file with [run] and others");
    }
    EXPECT_EQ(message_of(std::string("[run]\nx = \0\n", 11)),
              "c.ini:2: found byte 0x00, expected text");
    EXPECT_EQ(message_of("\x89HDF\r\n\x1a\n"), "c.ini:2: found byte 0x1a, expected text");
}

TEST(CaseFile, AMissingFileOrAFolderIsNamed) {
    EXPECT_THROW(
        {
            try {
                read_case_file("/nowhere/c.ini");
            } catch (const Error& error) {
                EXPECT_STREQ(error.what(), "/nowhere/c.ini: no such file, expected a case file");
                throw;
            }
        },
        Error);
    EXPECT_THROW(read_case_file("/"), Error);
}

TEST(CaseFile, ADeviceThatNeverEndsIsRefused) {
    try {
        read_case_file("/dev/zero");
        FAIL();
    } catch (const Error& error) {
        EXPECT_STREQ(error.what(), "/dev/zero: found more than 16 MB, expected a case file");
    }
}

TEST(CaseFile, AQuotedLineIsShortAndReadable) {
    const std::string line(3'000'000, 'a');
    EXPECT_EQ(message_of("[run]\n" + line + "\n"), "c.ini:2: found '" + std::string(40, 'a') +
                                                       "..." + std::string(17, 'a') +
                                                       "', expected 'key = value' or '[section]'");
    EXPECT_EQ(message_of("[run]\nx\ry\tz\n"),
              "c.ini:2: found 'x\\ry\\tz', expected 'key = value' or '[section]'");
    EXPECT_LT(message_of("[" + line + "]\n").size(), 200U);
    EXPECT_LT(message_of("[run]\n" + line + " = 1\n").size(), 200U);
}

TEST(CaseFile, AnOverrideReplacesAddsAndSaysWhoItIs) {
    CaseFile file = parse_case(small_case, "c.ini");
    override_value(file, "run.end_time=1 ms");
    override_value(file, "run.seed = 7");
    override_value(file, "contact.coating.steel.friction=0.3");
    override_value(file, "wall.floor.shape=plane");
    EXPECT_EQ(file.find("run")->find("end_time")->value, "1 ms");
    EXPECT_EQ(file.find("run")->find("end_time")->where, "--set run.end_time");
    EXPECT_EQ(file.find("run")->find("seed")->value, "7");
    EXPECT_EQ(file.sections[1].find("friction")->value, "0.3");
    EXPECT_EQ(file.find("wall.floor")->find("shape")->value, "plane");
    override_value(file, "run.seed = 8");
    EXPECT_EQ(file.find("run")->find("seed")->value, "8") << "the last one counts";
    for (const char* bad : {"", "run", "end_time=1", "run.end_time", "run.=1", ".x=1", "run.x="}) {
        EXPECT_THROW(override_value(file, bad), Error) << bad;
    }
}

// Whatever the bytes: a result or one Error, never anything else.
TEST(CaseFile, RandomDamageGivesACaseOrAnError) {
    Random random(1, 0);
    const std::string good = small_case;
    for (int round = 0; round < 20000; ++round) {
        std::string text = good.substr(0, random.next() % (good.size() + 1));
        for (int k = 0; k < round % 4 && !text.empty(); ++k) {
            text[random.next() % text.size()] = static_cast<char>(random.next() % 256);
        }
        try {
            const CaseFile file = parse_case(text, "c.ini");
            EXPECT_FALSE(file.sections.empty());
        } catch (const Error& error) {
            EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos);
        }
    }
}

}  // namespace
}  // namespace dem::runtime
