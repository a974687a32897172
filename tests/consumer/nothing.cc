// SPDX-License-Identifier: BSD-3-Clause
// Links a library and calls nothing of it.
int main() { return 0; }
