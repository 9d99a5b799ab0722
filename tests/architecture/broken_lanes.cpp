// SPDX-License-Identifier: BSD-3-Clause
// A function that every file with this header would define.
inline double shared_by_all(double x);

double called_in_lanes(double x) {
    return shared_by_all(x);
}

__attribute__((noinline)) inline double shared_by_all(double x) {
    return x * x;
}
