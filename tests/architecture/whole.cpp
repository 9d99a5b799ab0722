// SPDX-License-Identifier: BSD-3-Clause
// Links every library of both programs whole: a name with two definitions does not link.
int main() {}
