// SPDX-License-Identifier: GPL-3.0-or-later
// A switch without a case
#version 3.7;
#switch (3) "x" #end
