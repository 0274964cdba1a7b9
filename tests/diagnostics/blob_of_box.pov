// SPDX-License-Identifier: GPL-3.0-or-later
// A blob has no boxes
#version 3.7;
blob { threshold 0.5 box { 0, 1 } }
