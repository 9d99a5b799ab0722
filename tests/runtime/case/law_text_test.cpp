// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/case/law_text.hpp"

#include "runtime/contact/law/pair_law.hpp"
#include "tests/runtime/case/case_text.hpp"

#include <gtest/gtest.h>

namespace dem::runtime {
namespace {

// Y* of two coatings: E / (2 (1 - nu^2)); of coating and steel, of E = 2 G (1 + nu) = 50 MPa as
// well: E / (1 - 0.3^2 + 1 - 0.25^2).
TEST(LawText, HasALineForEveryPairOfMaterialsThatCanMeet) {
    EXPECT_EQ(law_text(scene_of(sphere_case())),
              "laws:\n"
              "  coating on coating: hertz, Y* 2.747e+07 Pa, tangential mindlin, e 0.6, mu 0.38\n"
              "  coating on steel: hertz, Y* 2.706e+07 Pa, tangential mindlin, e 0.6, mu 0.22\n");
}

TEST(LawText, SaysWhatOtherLawsAreMadeOf) {
    const std::string ratio =
        law_text(scene_of(sphere_case(), "contact.tangential=ratio", "contact.stiffness_ratio=0.5",
                          "contact.rolling_friction=0.02", "contact.rolling_model=constant"));
    EXPECT_NE(ratio.find("Pa, k_t 0.5 k_n, e 0.6, mu 0.38, mu_r 0.02 constant\n"),
              std::string::npos)
        << ratio;
    const std::string linear =
        law_text(scene_of(sphere_case(), "contact.model=linear", "contact.normal_stiffness=1e5",
                          "contact.tangential_restitution=0.3", "contact.rolling_friction=0.02"));
    EXPECT_NE(linear.find("linear, k_n 1e+05 N/m, e 0.6, tangential 0.3, mu 0.38, mu_r 0.02 "
                          "elastic_plastic\n"),
              std::string::npos)
        << linear;
}

TEST(LawText, TheRestitutionOfALawIsTheOneItWasMadeWith) {
    for (const double e : {1e-6, 0.1, 0.6, 1.0}) {
        EXPECT_NEAR(restitution(pair_law({1e7, 0.3}, {1e7, 0.3}, e)).normal, e, 1e-9 * e);
        const Restitution both = restitution(linear_law(1e5, e, 0.4));
        EXPECT_NEAR(both.normal, e, 1e-9 * e);
        EXPECT_NEAR(both.tangential, 0.4, 1e-9);
    }
}

}  // namespace
}  // namespace dem::runtime
