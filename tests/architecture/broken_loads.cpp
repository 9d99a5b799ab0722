// SPDX-License-Identifier: BSD-3-Clause
// A program that loads a library of shapegen: the load check must see it.
int main() {
    return 0;
}
