// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/files/body_table.hpp"

#include "common/error.hpp"
#include "common/random.hpp"
#include "formats/number_text.hpp"
#include "runtime/files/csv_rows.hpp"
#include "tests/formats/temporary_folder.hpp"

#include <bit>
#include <charconv>

namespace dem::runtime {
namespace {

using BodyTable = TemporaryFolder;

Vec3 any_vector(Random& random) {
    Vec3 v = random.direction();
    return v * std::exp(random.uniform(-30.0, 30.0));
}

TEST_F(BodyTable, EveryBodySurvivesTheRoundTripBitByBit) {
    std::vector<BodyRow> bodies;
    for (std::uint64_t i = 0; i < 500; ++i) {
        Random random(7, i);
        bodies.push_back({i * 1000003, i % 2 == 0 ? "tablet" : "a \"b\", c", " group\n2 ",
                          any_vector(random), random.orientation(), any_vector(random),
                          any_vector(random), 0});
    }
    write_body_table(folder_ / "final.csv", bodies);
    const std::vector<BodyRow> read = read_body_table(folder_ / "final.csv");
    ASSERT_EQ(read.size(), bodies.size());
    for (std::size_t i = 0; i < read.size(); ++i) {
        EXPECT_EQ(read[i].id, bodies[i].id);
        EXPECT_EQ(read[i].template_name, bodies[i].template_name);
        EXPECT_EQ(read[i].group, bodies[i].group);
        EXPECT_EQ(read[i].position, bodies[i].position);
        EXPECT_EQ(read[i].orientation.coeffs(), bodies[i].orientation.coeffs());
        EXPECT_EQ(read[i].velocity, bodies[i].velocity);
        EXPECT_EQ(read[i].angular_velocity, bodies[i].angular_velocity);
        EXPECT_EQ(read[i].line, 2 + 2 * i) << "the group's name takes a line end";
    }
}

TEST_F(BodyTable, MissingColumnsAreZeroAndIdentityAndTheOrderIsFree) {
    const auto bodies =
        parse_body_table("\xEF\xBB\xBFz, vx ,x\r\n\r\n 3,-1e-3,+0.5e1\r\n1,2,3", "b");
    ASSERT_EQ(bodies.size(), 2U);
    EXPECT_EQ(bodies[0].position, Vec3(5, 0, 3));
    EXPECT_EQ(bodies[0].velocity, Vec3(-1e-3, 0, 0));
    EXPECT_EQ(bodies[0].orientation.coeffs(), Quat::Identity().coeffs());
    EXPECT_EQ(bodies[0].angular_velocity, Vec3::Zero());
    EXPECT_EQ(bodies[0].line, 3U);
    EXPECT_EQ(bodies[1].line, 4U);
}

TEST_F(BodyTable, ATypedQuaternionIsNormalized) {
    const auto bodies = parse_body_table("qw,qx,qy,qz\n0.7071,0,0.7071,0\n", "b");
    EXPECT_NEAR(bodies[0].orientation.norm(), 1.0, 1e-15);
    EXPECT_NEAR(bodies[0].orientation.w(), std::sqrt(0.5), 1e-15);
}

TEST_F(BodyTable, EveryFaultIsReportedWithItsLine) {
    const struct {
        const char* text;
        const char* message;
    } cases[] = {
        {"", "b.csv: is empty, expected a header row and bodies"},
        {"\n\n", "b.csv: is empty, expected a header row and bodies"},
        {"x,y,z\n", "b.csv: holds only a header row, expected bodies below it"},
        {"x,y,Z\n0,0,0\n", "b.csv:1: unknown column 'Z', did you mean 'z'?"},
        {"1,2,3\n", "b.csv:1: unknown column '1'"},
        {"x,y,x\n", "b.csv:1: column 'x' is given twice, expected it once"},
        {"x,qw\n0,1\n", "b.csv:1: found 1 of qw, qx, qy and qz, expected all or none of them"},
        {"x,y\n0,0\n1\n", "b.csv:3: 1 fields, expected 2"},
        {"x,y\n0,0,0\n", "b.csv:2: 3 fields, expected 2"},
        {"x,y\n0,1 mm\n", "b.csv:2: column 'y': found '1 mm', expected a finite number"},
        {"x,y\n0,\n", "b.csv:2: column 'y': found ''"},
        {"x,y\n0,nan\n", "b.csv:2: column 'y': found 'nan'"},
        {"x,y\n0,1e999\n", "b.csv:2: column 'y': found '1e999'"},
        {"x,y\n0,+-1\n", "b.csv:2: column 'y': found '+-1', expected a finite number"},
        {"x,y\n0,\"1\n2\"\n", "b.csv:2: column 'y': found '1\\n2', expected a finite number"},
        {"x\ty,z\n0,0\n", "b.csv:1: unknown column 'x\\ty', expected a header row of id,"},
        {"id\n-1\n", "b.csv:2: column 'id': found '-1', expected a whole number"},
        {"qw,qx,qy,qz\n1,0,0,0\n0,0,0,0\n", "b.csv:3: the quaternion qw, qx, qy, qz has length 0,"},
        {"qw,qx,qy,qz\n1,1,0,0\n", "b.csv:2: the quaternion qw, qx, qy, qz has length 1.41"},
        {"group,x\n\"a,1\n", "b.csv:2: a quote is not closed"},
        {"group,x\n\"a\"b,1\n", "b.csv:2: text after a closing quote"},
    };
    for (const auto& c : cases) {
        const auto message = message_of<Error>([&] { parse_body_table(c.text, "b.csv"); });
        EXPECT_EQ(message.substr(0, std::string(c.message).size()), c.message);
    }
}

TEST_F(BodyTable, RandomTextNeverCrashes) {
    constexpr std::string_view letters = "xyzqwid,,,\n\n\"\" \r.0123e-+";
    for (std::uint64_t round = 0; round < 5000; ++round) {
        Random random(3, round);
        std::string text = round % 2 == 0 ? "x,y\n" : "";
        for (std::uint64_t k = random.next() % 60; k > 0; --k) {
            text += letters[random.next() % letters.size()];
        }
        try {
            parse_body_table(text, "b");
        } catch (const Error&) {
        }
    }
}

TEST(NumberText, EveryDoubleReadsBackAndWholeNumbersStayReadable) {
    EXPECT_EQ(number_text(1000000.0), "1000000");
    EXPECT_EQ(number_text(-0.0), "-0");
    EXPECT_EQ(number_text(1e300), "1e+300");
    EXPECT_EQ(number_text(5e-7), "5e-07");
    EXPECT_EQ(number_text(0.1), "0.1");
    Random random(5, 0);
    for (int i = 0; i < 20000; ++i) {
        const auto value = std::bit_cast<double>(random.next());
        if (std::isnan(value)) continue;
        const std::string text = number_text(value);
        double read = 0.0;
        std::from_chars(text.data(), text.data() + text.size(), read);
        ASSERT_EQ(std::bit_cast<std::uint64_t>(read), std::bit_cast<std::uint64_t>(value)) << text;
    }
}

}  // namespace
}  // namespace dem::runtime
