// SPDX-License-Identifier: BSD-3-Clause
// A function that every file with this header would define.
template <class Number>
[[gnu::noinline]] Number shared_by_all(Number x) {
    return x * x;
}

double called_in_lanes(double x);
double called_in_lanes(double x) {
    return shared_by_all(x);
}
