// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/case/values.hpp"

#include "common/error.hpp"

#include <gtest/gtest.h>

namespace dem::runtime {
namespace {

/// The message of reading `lines` as one section of the given name, or "fine".
template <class Use>
std::string message(const std::string& lines, const Use& use) {
    const CaseFile file = parse_case(lines, "c.ini");
    const CaseSection& section = file.sections.front();
    try {
        use(Values(section, *section_kind(section.name)));
    } catch (const Error& error) {
        return error.what();
    }
    return "fine";
}

const auto nothing = [](const Values&) {};

TEST(Quantities, AUnitHoldsForAllNumbersSinceTheLastUnit) {
    EXPECT_EQ(parse_quantities("0 0 100 mm  0 0 125 mm  20 cm", Dimension::length),
              (std::vector<double>{0.0, 0.0, 0.1, 0.0, 0.0, 0.125, 0.2}));
    EXPECT_EQ(parse_quantities("1mm +2mm\t-3 m", Dimension::length),
              (std::vector<double>{1e-3, 2e-3, -3.0}));
    EXPECT_EQ(parse_quantities("0 0 -9.81", Dimension::acceleration),
              (std::vector<double>{0.0, 0.0, -9.81}));
    EXPECT_EQ(parse_quantities("1 2 3 1/s", Dimension::angular_velocity),
              (std::vector<double>{1.0, 2.0, 3.0}));
}

TEST(Quantities, WhatIsNoListOfQuantitiesIsRefused) {
    for (const char* bad : {"1 mm 2", "0 0 kg", "1 2 x 3", "nan 0 0", "0 inf 0", "1 2 1e999",
                            "1,2,3", "mm 1 2 3", "1e 2 3", "--1 2 3", "1 mm mm", "0x10 1 1"}) {
        EXPECT_THROW(parse_quantities(bad, Dimension::length), Error) << bad;
    }
}

TEST(RegionText, BoxesAndCylindersAreRead) {
    const auto box = std::get<BoxRegion>(parse_region("box 0 0 10 mm 1 2 20 mm"));
    EXPECT_EQ(box.box.lower, Vec3(0.0, 0.0, 0.01));
    EXPECT_EQ(box.box.upper, Vec3(1e-3, 2e-3, 20e-3));
    const auto cylinder = std::get<CylinderRegion>(parse_region("cylinder 0 0 1 0 0 2 0.5"));
    EXPECT_EQ(cylinder.to, Vec3(0.0, 0.0, 2.0));
    EXPECT_EQ(cylinder.radius, 0.5);
    for (const char* bad : {"sphere 0 0 0 1", "box 0 0 0 1 1", "box 0 0 0 1 1 0", "box",
                            "cylinder 0 0 0 0 0 0 1", "cylinder 0 0 0 0 0 1 -1", "12",
                            "box 0 0 0 1e16 1e16 1e16 mm", "cylinder 0 0 0 0 0 1 2e6"}) {
        EXPECT_THROW(parse_region(bad), Error) << bad;
    }
}

TEST(Values, AnUnknownKeyIsNamedWithTheNearestOne) {
    EXPECT_EQ(message("[contact]\nfrictoin = 0.3\n", nothing),
              "c.ini:2: unknown key 'frictoin' in [contact], did you mean 'friction'?");
    EXPECT_EQ(message("[run]\nend_time = 1\nfriction = 0.3\n", nothing),
              "c.ini:3: unknown key 'friction' in [run], it belongs in [contact]");
    // Two of five letters are no slip of the pen.
    EXPECT_EQ(
        message("[particles.x]\nstage = 2\n", nothing)
            .rfind("c.ini:2: unknown key 'stage' in [particles.x], expected one of: template,", 0),
        0U);
    EXPECT_EQ(message("[particles.x]\nscale = 2\n", nothing),
              "c.ini:2: unknown key 'scale' in [particles.x], it belongs in [wall.NAME]");
}

TEST(Values, AMissingKeyIsNamed) {
    EXPECT_EQ(message("[run]\nseed = 3\n", nothing),
              "c.ini:1: no 'end_time' in [run], it is required");
    EXPECT_EQ(message("[wall.a]\nmaterial = m\n", nothing),
              "c.ini:1: no 'shape' in [wall.a], it is required");
    EXPECT_EQ(message("[wall.a]\nmaterial = m\nshape = plane\npoint = 0 0 0\n", nothing),
              "c.ini:1: no 'normal' in [wall.a], it is required for shape=plane");
}

TEST(Values, AKeyOfAnotherChoiceIsRefused) {
    EXPECT_EQ(message("[wall.a]\nmaterial = m\nshape = box\nradius = 1\nlower=0 0 0\nupper=1 1 1\n",
                      nothing),
              "c.ini:4: key 'radius' has no meaning for shape = box, it needs shape=cylinder");
    EXPECT_EQ(
        message("[particles.a]\nmaterial = m\ncount=1\nregion=box 0 0 0 1 1 1\nevery=1\n", nothing),
        "c.ini:5: key 'every' has no meaning for insert = at_once, it needs insert=batches");
}

TEST(Values, EveryWrongValueHasItsLine) {
    const auto end_time = [](const Values& v) { v.number("end_time"); };
    EXPECT_EQ(message("[run]\nend_time = -4 s\n", end_time),
              "c.ini:2: end_time: found '-4 s', expected > 0");
    EXPECT_EQ(message("[run]\nend_time = 0\n", end_time),
              "c.ini:2: end_time: found '0', expected > 0");
    for (const char* bad : {"4 kg", "nan", "inf", "4 mm", "4 s s", "four", "1e999"}) {
        const std::string text = message("[run]\nend_time = " + std::string(bad) + "\n", end_time);
        EXPECT_TRUE(text.starts_with("c.ini:2: end_time: ")) << text;
    }
    const auto seed = [](const Values& v) { v.count("seed"); };
    for (const char* bad : {"-1", "1.5", "x", "99999999999999999999"}) {
        EXPECT_NE(message("[run]\nend_time=1\nseed = " + std::string(bad) + "\n", seed), "fine");
    }
    const auto threads = [](const Values& v) { v.count("threads"); };
    for (const std::string bad : {"-1", "1.5", "5000"}) {
        EXPECT_EQ(
            message("[run]\nend_time=1\nthreads = " + bad + "\n", threads),
            "c.ini:3: threads: found '" + bad + "', expected a whole number >= 0 and <= 4096");
    }
    const auto friction = [](const Values& v) { v.optional_number("friction"); };
    EXPECT_EQ(message("[contact]\nfriction = -0.1\n", friction),
              "c.ini:2: friction: found '-0.1', expected >= 0");
    const auto restitution = [](const Values& v) { v.optional_number("restitution"); };
    EXPECT_EQ(message("[contact]\nrestitution = 1.1\n", restitution),
              "c.ini:2: restitution: found '1.1', expected > 0 and <= 1");
    const auto gravity = [](const Values& v) { v.vector("gravity"); };
    EXPECT_EQ(message("[run]\nend_time=1\ngravity = 0 -9.81\n", gravity),
              "c.ini:3: gravity: found '0 -9.81', expected three numbers x y z");
    EXPECT_EQ(message("[run]\nend_time=1\ngravity = 0 0 +-9.81\n", gravity),
              "c.ini:3: gravity: found '+-9.81', expected an acceleration (m/s^2 or mm/s^2)");
}

TEST(Values, AChoiceThatIsNotThereSuggestsOneThatIs) {
    const auto model = [](const Values& v) { v.choice_index("model"); };
    const auto kind = [](const Values& v) { v.choice_index("kind"); };
    EXPECT_EQ(message("[measure.m]\nkind = order\n", kind)
                  .rfind("c.ini:2: kind: 'order' is not in this version, expected one of: ", 0),
              0U);
    EXPECT_EQ(message("[contact]\nmodel = herz\n", model),
              "c.ini:2: model: unknown choice 'herz', did you mean 'hertz'?");
}

TEST(Values, AChoiceToComeIsSaidBeforeItsKeysAreBlamed) {
    EXPECT_EQ(message("[measure.m]\nradius = 3 mm\nkind = order\n", nothing)
                  .rfind("c.ini:3: kind: 'order' is not in this version, expected one of: ", 0),
              0U);
}

TEST(Values, ASizeIsARadiusOrADiameter) {
    const auto radius = [](const std::string& keys) {
        const CaseFile file = parse_case("[particles.a]\n" + keys, "c.ini");
        const CaseSection& section = file.sections[0];
        return Values(section, *section_kind(section.name)).radius();
    };
    const std::string rest = "material = m\ncount = 1\nregion = box 0 0 0 1 1 1\n";
    EXPECT_EQ(radius("radius = 5 mm\n" + rest), 5e-3);
    EXPECT_EQ(radius("diameter = 10 mm\n" + rest), 5e-3);
    EXPECT_EQ(radius(rest), std::nullopt);
    EXPECT_EQ(message("[particles.a]\nradius = 1\ndiameter = 2\n" + rest,
                      [](const Values& v) { v.radius(); }),
              "c.ini:3: diameter: found beside 'radius', expected one of them");
    EXPECT_EQ(message("[particles.a]\ndiameter = -2\n" + rest, [](const Values& v) { v.radius(); }),
              "c.ini:2: diameter: found '-2', expected > 0");
}

// The table's defaults are read by the same code as what users write.
TEST(Keys, EveryDefaultIsAValidValueAndEveryConditionIsAChoice) {
    for (const SectionKind& kind : section_kinds()) {
        for (const Key& key : kind.keys) {
            EXPECT_FALSE(key.doc.empty()) << key.name;
            EXPECT_FALSE(key.required && !key.standard.empty()) << key.name;
            EXPECT_EQ(kind.find(key.name), &key) << key.name << " declared twice";
            if (!key.when.empty()) {
                const auto parts = split(key.when, '=');
                const Key* control = kind.find(parts[0]);
                ASSERT_NE(control, nullptr) << key.name;
                const auto words = split(control->words, ' ');
                for (const auto choice : split(parts[1], '|')) {
                    EXPECT_NE(std::find(words.begin(), words.end(), choice), words.end())
                        << key.name;
                }
            }
            if (key.standard.empty()) continue;
            const auto words = split(key.words, ' ');
            if (std::find(words.begin(), words.end(), key.standard) != words.end()) continue;
            if (key.type == ValueType::number || key.type == ValueType::count) {
                EXPECT_TRUE(key.range.contains(parse_quantity(key.standard, key.dimension)))
                    << key.name;
            } else if (key.type == ValueType::vector) {
                EXPECT_EQ(parse_quantities(key.standard, key.dimension).size(), 3U) << key.name;
            } else if (key.type == ValueType::orientation) {
                EXPECT_EQ(parse_quantities(key.standard, key.dimension).size(), 4U) << key.name;
            } else {
                EXPECT_EQ(key.type, ValueType::yes_no) << key.name;
            }
        }
    }
}

}  // namespace
}  // namespace dem::runtime
