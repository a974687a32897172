#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# A node that is too old for the viewer.
echo v16.20.2
