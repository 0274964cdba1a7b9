// SPDX-License-Identifier: GPL-3.0-or-later
// A version in words
#version unofficial megapov 1.0;
