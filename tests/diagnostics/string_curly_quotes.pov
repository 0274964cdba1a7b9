// SPDX-License-Identifier: GPL-3.0-or-later
// Quotes of a word processor
#version 3.7;
#include “colors.inc”
