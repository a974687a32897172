// SPDX-License-Identifier: BSD-3-Clause
#include "examples/preview_control.h"

int main(int argc, char** argv) { return gaitwright::examples::PreviewControlMain(argc, argv); }
