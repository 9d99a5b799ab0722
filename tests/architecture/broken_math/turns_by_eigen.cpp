// SPDX-License-Identifier: BSD-3-Clause
#include <Eigen/Geometry>

Eigen::Quaterniond turns_by_eigen(double x) {
    return Eigen::Quaterniond(Eigen::AngleAxisd(x, Eigen::Vector3d::UnitX()));
}
