// SPDX-License-Identifier: BSD-3-Clause
#include "shapegen/profile/profile_file.hpp"

#include "common/error.hpp"
#include "tests/shapegen/profile/sample_profiles.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <string>

#include <gtest/gtest.h>

namespace dem::shapegen {
namespace {

Profile parse(const std::string& text) {
    return parse_profile(text, "x.profile").profile;
}

std::string message_of(const std::string& text) {
    try {
        parse(text);
    } catch (const Error& error) {
        return error.what();
    }
    return "accepted";
}

/// The message names the place and holds the words.
void expect_message(const std::string& text, const std::string& place, const std::string& words) {
    const std::string message = message_of(text);
    EXPECT_EQ(message.substr(0, place.size()), place) << message;
    EXPECT_NE(message.find(words), std::string::npos) << message << "\n expected: " << words;
    EXPECT_EQ(message.find('\n'), std::string::npos);
}

/// Largest distance of points of one outline from the other.
double distance_between(const Profile& one, const Profile& other) {
    double largest = 0.0;
    for (const ProfilePiece& piece : one.pieces())
        for (const double share : {0.0, 0.3, 1.0}) {
            const double t = piece.t0 + share * (piece.t1 - piece.t0);
            const Vec2 point = evaluate(one.segments()[piece.segment], t).point;
            largest = std::max(largest, other.nearest(point).distance);
        }
    return largest;
}

void expect_same(const Profile& a, const Profile& b, double tolerance) {
    EXPECT_LE(distance_between(a, b), tolerance);
    EXPECT_LE(distance_between(b, a), tolerance);
}

TEST(ProfileFile, ATabletIsTheSameByNameByPathAndByFillets) {
    const Profile named = parse(
        "units = mm\nshape = tablet\nband_radius = 5.675\nband_height = 4\ncap_height = 1.23\n");
    expect_same(named, sample::tablet(5.675e-3, 4e-3, 1.23e-3), 1e-16);
    const Profile path = parse(
        "units = mm\nstart 0 -3.23\narc 5.675 -2 radius 13.706717479674797\nline 5.675 2  # band\n"
        "arc 0 3.23 radius 13.706717479674797\n");
    expect_same(named, path, 1e-15);
    const Profile through = parse(
        "units = mm\nstart 0 -3.23\narc 5.675 -2 through 2 -3.0833011068767213\nline 5.675 2\n"
        "arc 0 3.23 through 2 3.0833011068767213\n");
    expect_same(named, through, 1e-11);

    const Profile rounded = parse(
        "units = mm\nshape = tablet\nband_radius = 5.675\nband_height = 4\ncap_height = 1.23\n"
        "edge_radius = 0.19");
    const Profile fillets = parse(
        "units = mm\nstart 0 -3.23\narc 5.675 -2 radius 13.706717479674797\nfillet 0.19\n"
        "line 5.675 2\nfillet 0.19\narc 0 3.23 radius 13.706717479674797\n");
    expect_same(rounded, fillets, 1e-15);
    EXPECT_TRUE(rounded.corners(179.9 * pi / 180.0).empty());
    EXPECT_NEAR(rounded.max_radius(), named.max_radius(), 1e-17);
}

TEST(ProfileFile, UnitsScaleEverythingAndValuesMayCarryTheirOwn) {
    const Profile meters =
        parse("start 0 -0.003\nline 0.002 -0.003\nline 0.002 0.003\nline 0 0.003\n");
    expect_same(meters, parse("units=mm\nstart 0 -3\nline 2 -3 2 3 0 3\n"), 1e-17);
    expect_same(meters,
                parse("units = cm\nstart 0 -3mm\nline 2 mm -0.3\nline 0.2 0.3\nline 0 3000 um"),
                1e-17);
    expect_same(meters, parse("shape = cylinder\ndiameter = 4 mm\nheight = 0.6 cm\n"), 1e-17);
    const Profile inches = parse("units = in\nshape = sphere\nradius = 1");
    EXPECT_DOUBLE_EQ(inches.max_radius(), 0.0254);
}

TEST(ProfileFile, OpenEndsAreClosedByDiscsAndPathsMayRunDownwards) {
    const Profile cylinder = sample::cylinder(2.0, 6.0);
    expect_same(parse("start 2 -3\nline 2 3"), cylinder, 1e-16);
    expect_same(parse("start 0 3\nline 2 3\nline 2 -3"), cylinder, 1e-16);
    expect_same(parse("r,z\n2,-3\n2,3\n"), cylinder, 1e-16);
    expect_same(parse("2;3\n2;-3"), cylinder, 1e-16);
    expect_same(parse("\xEF\xBB\xBF# outline\r\nr  z\r\n2\t-3\r\n2\t-3\r\n2\t3\r\n"), cylinder,
                1e-16);
    EXPECT_NE(parse("start 2 -3\nline 2 3").label(0).find("closing disc"), std::string::npos);
}

TEST(ProfileFile, ArcsFollowTheirSense) {
    const Profile sphere = parse("start 0 -2\narc 0 2 radius 2");
    expect_same(sphere, sample::sphere(2.0), 3e-15);
    expect_same(parse("start 0 -2\narc 0 2 through 2 0"), sample::sphere(2.0), 3e-15);
    expect_same(parse("start 0 -2\nellipse_arc 5 0 semi_axes 5 2\nellipse_arc 0 2 semi_axes 5 2"),
                sample::spheroid(5.0, 2.0), 3e-15);
    // A bulge of more than half a circle, centered at r = 1 + sqrt(3)/2.
    const Profile bulge = parse("start 1 -0.5\narc 1 0.5 radius 1 large");
    EXPECT_NEAR(bulge.max_radius(), 2.0 + std::sqrt(0.75), 1e-15);
    EXPECT_NEAR(bulge.max_z(), 1.0, 1e-15);
    // To the right: hollowed.
    const Profile hollow = parse("start 2 -1\narc 2 1 radius 3 right");
    EXPECT_NEAR(hollow.signed_distance({2.0 - (3.0 - std::sqrt(8.0)), 0.0}), 0.0, 1e-15);
}

TEST(ProfileFile, CurvesPassThroughTheirPointsAndMeetTheAxisSquarely) {
    const Profile egg = parse("start 0 -3\ncurve 1.5 -2 2 0 1.2 2 0 3");
    for (const Vec2& point : {Vec2(1.5, -2), Vec2(2, 0), Vec2(1.2, 2)})
        EXPECT_NEAR(egg.signed_distance(point), 0.0, 1e-15);
    EXPECT_TRUE(egg.corners(179.99 * pi / 180.0).empty());
    // Twice differentiable: curvature is continuous over the joints.
    for (std::size_t i = 1; i < egg.segments().size(); ++i)
        EXPECT_NEAR(signed_curvature(evaluate(egg.segments()[i - 1], 1.0)),
                    signed_curvature(evaluate(egg.segments()[i], 0.0)), 1e-12);
    // Points on a circle give a circle nearly.
    std::string circle = "start 0 -1\ncurve";
    for (int i = 1; i <= 16; ++i) {
        const double s = pi * i / 16;
        circle +=
            " " + std::to_string(i == 16 ? 0.0 : std::sin(s)) + " " + std::to_string(-std::cos(s));
    }
    expect_same(parse(circle), sample::sphere(1.0), 2e-5);
    const Profile bezier = parse("start 0 -1\nbezier 1.3333 -1 1.3333 1 0 1");
    EXPECT_NEAR(bezier.max_radius(), 1.0, 1e-4);
}

TEST(ProfileFile, PeanutAndCassiniAreTheSameOval) {
    const Profile peanut = parse("shape = peanut\nlength = 4\nwaist = 1");
    EXPECT_NEAR(peanut.top_z(), 2.0, 1e-15);
    EXPECT_NEAR(peanut.signed_distance({0.5, 0.0}), 0.0, 1e-15);
    const double f = std::sqrt(15.0 / 8.0);
    const double p = std::sqrt(17.0 / 8.0);
    expect_same(peanut, sample::peanut(f, p), 1e-14);
    // The product of the distances from the foci is constant.
    const Vec2 point = evaluate(peanut.segments()[0], 0.3).point;
    EXPECT_NEAR((point - Vec2(0, f)).norm() * (point + Vec2(0, f)).norm(), p * p, 1e-14);
}

TEST(ProfileFile, ShippedProfilesAreBodies) {
    int count = 0;
    for (const auto& entry : std::filesystem::directory_iterator(DEM_SOURCE_DIR "/data/profiles")) {
        const ProfileFile file = read_profile(entry.path().string());
        EXPECT_EQ(file.name, entry.path().stem().string());
        EXPECT_GT(file.profile.major_axis_length(), 3e-3) << file.name;  // written in mm
        EXPECT_LT(file.profile.major_axis_length(), 2e-2) << file.name;
        ++count;
    }
    EXPECT_GE(count, 14);
}

TEST(ProfileFile, AScaleMultipliesLengthsOfEveryKindOfProfileWhateverTheirUnit) {
    for (const char* text :
         {"units = mm\nshape = tablet\nband_radius = 5\nband_height = 4 mm\ncap_height = 0.1 cm\n",
          "units = mm\nshape = superquadric\na = 2\nc = 3\nexponent = 4\n",
          "units = mm\nstart 0 -1.6\narc 0.8 0 radius 1\nline 0.8 2 mm 0.5 2.5\nfillet 0.1\nline 0 "
          "3\n",
          "units = mm\n0 0\n1 0.5\n0 2\n"}) {
        const ProfileFile plain = parse_profile(text, "x.profile");
        const ProfileFile scaled = parse_profile(text, "x.profile", 2.5);
        EXPECT_NEAR(scaled.unit, 2.5 * plain.unit, 1e-18);
        EXPECT_EQ(scaled.hash, plain.hash);
        for (const Vec2& x : {Vec2(0.0, 0.0), Vec2(1e-3, 2e-3), Vec2(4e-3, 0.0), Vec2(0.0, 5e-3)})
            EXPECT_NEAR(scaled.profile.signed_distance(2.5 * x),
                        2.5 * plain.profile.signed_distance(x), 1e-15)
                << text;
    }
}

TEST(ProfileFile, HashChangesWithAnyByte) {
    const std::string text = "shape = sphere\nradius = 1 mm\n";
    EXPECT_NE(parse_profile(text, "a").hash, parse_profile(text + " ", "a").hash);
    EXPECT_EQ(parse_profile(text, "a").hash, parse_profile(text, "b").hash);
}

TEST(ProfileFileErrors, NameWhatIsUnknownAndSuggest) {
    expect_message("start 0 -1\nlin 1 0\nline 0 1", "x.profile:2: unknown command 'lin'",
                   "did you mean 'line'");
    expect_message("shape = tablett\n", "x.profile:1: unknown shape", "did you mean 'tablet'");
    expect_message("shape = sphere\nradus = 1\n", "x.profile:2: unknown parameter 'radus'",
                   "did you mean 'radius'");
    expect_message("units = mn\nshape = sphere\nradius = 1", "x.profile:1:", "mm");
    expect_message("unit = mm\nstart 0 -1\nline 1 0\n", "x.profile:1: unknown setting",
                   "did you mean 'units'");
    expect_message("start 0 -1\narc 1 0 radus 3\n", "x.profile:2:", "did you mean 'radius'");
    expect_message("hello world\n", "x.profile:1: unknown command 'hello'", "start");
}

TEST(ProfileFileErrors, NameWhatIsMissingOrTwice) {
    expect_message("shape = tablet\nband_radius = 1\nband_height = 1",
                   "x.profile:1: 'cap_height' is missing", "tablet");
    expect_message("shape = sphere\nradius = 1\nradius = 2", "x.profile:3: 'radius' given again",
                   "line 2");
    expect_message("shape = sphere\nradius = 1\ndiameter = 2", "x.profile:3:", "either");
    expect_message("line 1 0\n", "x.profile:1:", "'start r z' before");
    expect_message("start 0 -1\nline 1\n", "x.profile:2:", "z of a point");
    expect_message("start 0 -1\narc 1 0\n", "x.profile:2:", "radius a");
    expect_message("start 0 -1\n", "x.profile:1: the path ends at its start", "");
    expect_message("shape =\n", "x.profile:1:", "name = value");
    expect_message("", "x.profile: the file is empty", "");
    expect_message("# only a comment\n\n", "x.profile: the file is empty", "");
    expect_message("units = mm\n", "x.profile: found no profile", "");
    expect_message("1 2\n", "x.profile: found one point", "");
    expect_message("start 0 -1\nline 1 0\nfillet 0.1\n", "x.profile:3:", "after it");
}

TEST(ProfileFileErrors, RefuseValuesThatMakeNoBody) {
    expect_message("shape = sphere\nradius = -1", "x.profile:2:", "above zero");
    expect_message("shape = sphere\nradius = nan", "x.profile:2:", "finite");
    expect_message("shape = sphere\nradius = 1 kg", "x.profile:2:", "kg");
    expect_message("0 -1\n1 nan\n0 1", "x.profile:2:", "finite");
    expect_message("nan -1\n1 0\n0 1", "x.profile:1:", "finite");
    expect_message("0 -1\n-1 0\n0 1", "x.profile:2:", "negative radius");
    expect_message("0 -1 3\n1 0\n", "x.profile:1:", "two numbers");
    expect_message("0 -1\n1 1\n1 -1\n0 1", "x.profile:4: the profile crosses", "x.profile:2");
    expect_message("start 0 -1\nline 1 1\nline 1 -1\nline 0 1", "x.profile:4: the profile crosses",
                   "x.profile:2");
    expect_message("start 0 -1\nline 0 1", "x.profile:2:", "axis");
    expect_message("start 1 0\narc 1 0.5 radius 0.1", "x.profile:2:", "too small");
    expect_message("start 1 0\nline 2 0\nline 2 1\nline 1 0", "x.profile:", "expected");
    expect_message("start 1 0\nline 1 0", "x.profile:2:", "goes nowhere");
    expect_message("start 0 -1\nline 1 -1\nfillet 3\nline 1 1\n", "x.profile:3:", "fillet");
    expect_message("shape = cassini\nfocus = 2\nproduct_root = 1.5", "x.profile:3:", "two parts");
    expect_message("shape = superquadric\na = 1\nc = 1\nexponent = 0.5",
                   "x.profile:4:", "from 1 to 100");
    expect_message("shape = superquadric\na = 1\nc = 1\nexponent = 4 mm", "x.profile:4:", "mm");
    expect_message("shape = tablet\nband_radius = 1\nband_height = 1\ncap_height = 2",
                   "x.profile:4:", "cap");
    expect_message(
        "shape = tablet\nband_radius = 5\nband_height = 1\ncap_height = 1\nedge_radius = 3",
        "x.profile:5:", "edge_radius");
    expect_message("shape = sphere\nradius = 1\nline 2 3", "x.profile:3:", "only parameters");
}

// One of 1/1000 kept the integral of its length from ending.
TEST(ProfileFile, AWaistThinnerThanAnyFieldIsRefused) {
    const auto reads = [](const std::string& waist) {
        return parse_profile("shape = peanut\nlength = 10\nwaist = " + waist, "x.profile");
    };
    EXPECT_NEAR(reads("0.1").profile.major_axis_length(), 10.0, 1e-12);
    expect_message("shape = peanut\nlength = 10\nwaist = 0.0999",
                   "x.profile:3: found waist = '0.0999'", "expected 1/100 of the length or more");
    expect_message("shape = peanut\nlength = 10\nwaist = 1e-6", "x.profile:3:", "1/100");
    expect_message("shape = cassini\nfocus = 1\nproduct_root = 1.00001", "x.profile:3:", "1/100");
}

TEST(ProfileFileErrors, RefuseFilesThatAreNoProfiles) {
    const auto message = [](const std::string& path) -> std::string {
        try {
            read_profile(path);
        } catch (const Error& error) {
            return error.what();
        }
        return "accepted";
    };
    EXPECT_NE(message("/no/such.profile").find("no such file"), std::string::npos);
    EXPECT_NE(message("/tmp").find("is a folder"), std::string::npos);
    EXPECT_NE(message("/dev/zero").find("more than 64 MB"), std::string::npos);
    EXPECT_NE(message_of(std::string("\x7f"
                                     "ELF\0\1\2",
                                     7))
                  .find("expected text"),
              std::string::npos);
    std::string many;
    for (std::size_t i = 0; i <= 1'000'000; ++i) many += "1 2\n";
    expect_message(many, "x.profile: found more than 100000 lines", "");
}

}  // namespace
}  // namespace dem::shapegen
