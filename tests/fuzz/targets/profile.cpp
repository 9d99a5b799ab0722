// SPDX-License-Identifier: BSD-3-Clause
#include "shapegen/profile/profile_file.hpp"
#include "tests/fuzz/promise.hpp"

#include <array>

namespace dem::fuzz {

using namespace shapegen;

namespace {

void look_at(const ProfileFile& file) {
    const Profile& profile = file.profile;
    promise_positive(file.unit, "the unit of a profile");
    promise_positive(profile.length(), "the length of a profile");
    promise_positive(profile.max_radius(), "the largest radius of a profile");
    promise(profile.major_axis_length() >= 1e-9 && profile.major_axis_length() <= 2e4,
            "a profile is no smaller and no larger than bodies are");
    promise(profile.bottom_z() < profile.top_z(), "a profile ends above its start");
    const double size = profile.major_axis_length();
    const Vec2 middle(0.3 * profile.max_radius(), 0.5 * (profile.min_z() + profile.max_z()));
    for (const Vec2& x : {middle, Vec2(0.0, profile.top_z()), Vec2(10.0 * size, middle.y())})
        promise_finite(profile.signed_distance(x), "the distance from a profile");
    promise(!profile.contains({10.0 * size, middle.y()}), "what is far away is outside");
    for (const Profile::Corner& corner : profile.corners())
        promise_finite(corner.interior_angle, "the angle of a corner");
}

}  // namespace

bool reads_profile(Bytes bytes) {
    static const std::array<std::string, 1> places = {"x.profile:"};
    return accepts(places, [&] { look_at(parse_profile(as_text(bytes), "x.profile")); });
}

}  // namespace dem::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::byte* data, std::size_t size) {
    dem::fuzz::reads_profile({data, size});
    return 0;
}
