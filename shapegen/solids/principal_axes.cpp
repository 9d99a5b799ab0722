// SPDX-License-Identifier: BSD-3-Clause
#include "shapegen/solids/principal_axes.hpp"

#include <array>
#include <cmath>

#include <Eigen/Eigenvalues>

namespace dem::shapegen {
namespace {

/// The rotation nearest to the identity whose columns are the given orthonormal ones in any order
/// and of any sign.
Mat3 nearest_to_identity(const Mat3& axes) {
    constexpr std::array<std::array<int, 3>, 6> orders{
        {{0, 1, 2}, {1, 2, 0}, {2, 0, 1}, {0, 2, 1}, {2, 1, 0}, {1, 0, 2}}};
    Mat3 best = Mat3::Identity();
    double best_trace = -2.0;  // below the trace of any rotation
    for (const auto& order : orders) {
        Mat3 rotation;
        for (int k = 0; k < 3; ++k) {
            rotation.col(k) = axes.col(order[static_cast<std::size_t>(k)]);
            if (rotation(k, k) < 0.0) rotation.col(k) *= -1.0;
        }
        if (rotation.determinant() < 0.0) {
            int smallest = 0;
            rotation.diagonal().minCoeff(&smallest);
            rotation.col(smallest) *= -1.0;
        }
        if (rotation.trace() > best_trace) {
            best_trace = rotation.trace();
            best = rotation;
        }
    }
    return best;
}

/// The rotation nearest to the identity that makes `axis` a coordinate axis.
Mat3 smallest_turn_to(const Vec3& axis) {
    int k = 0;
    axis.cwiseAbs().maxCoeff(&k);
    const Vec3 target = axis[k] < 0.0 ? Vec3(-axis) : axis;
    return Quat::FromTwoVectors(Vec3::Unit(k), target).toRotationMatrix();
}

Mat3 principal_rotation(const Mat3& inertia) {
    const Eigen::SelfAdjointEigenSolver<Mat3> eigen(inertia);
    const Vec3& moments = eigen.eigenvalues();  // ascending
    const double negligible = 1e-9 * moments[2];
    const bool low_pair = moments[1] - moments[0] <= negligible;
    const bool high_pair = moments[2] - moments[1] <= negligible;
    if (low_pair && high_pair) return Mat3::Identity();
    if (low_pair) return smallest_turn_to(eigen.eigenvectors().col(2));
    if (high_pair) return smallest_turn_to(eigen.eigenvectors().col(0));
    return nearest_to_identity(eigen.eigenvectors());
}

}  // namespace

MassProperties principal_mass_properties(double volume, const Vec3& center_of_mass,
                                         const Mat3& inertia_per_density) {
    const Mat3 axes = principal_rotation(inertia_per_density);
    MassProperties result;
    result.volume = volume;
    result.center_of_mass = center_of_mass;
    result.principal_axes = Quat(axes).normalized();
    result.principal_moments_per_density =
        (axes.transpose() * inertia_per_density * axes).diagonal();
    return result;
}

}  // namespace dem::shapegen
