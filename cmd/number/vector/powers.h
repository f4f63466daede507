/* SPDX-License-Identifier: MIT */
/* The powers 10^-11 to 10^20 as hi + lo: hi is the double nearest to the power, lo the
 * double nearest to the power minus hi. From 10^0 on hi is exact. Below, hi + lo has a
 * relative error of at most POWER_ERROR. (digits_test.t recomputes all.) */
#pragma once

enum { POWER_MIN = -11, POWER_MAX = 20, POWERS = 32 };

#define POWER_ERROR 0x1p-106

static const double powers[POWERS][2] = { { 1e-11, 6.0503030718060191e-28 },
	{ 1e-10, -3.6432197315497743e-27 }, { 1e-9, -6.2281591457779853e-26 },
	{ 1e-8, -2.0922560830128471e-25 }, { 1e-7, 4.5251888174113739e-24 },
	{ 1e-6, 4.5251888174113741e-23 }, { 1e-5, -8.1803053914031305e-22 },
	{ 1e-4, -4.7921736023859299e-21 }, { 1e-3, -2.0816681711721686e-20 },
	{ 1e-2, -2.0816681711721684e-19 }, { 1e-1, -5.551115123125783e-18 }, { 1e0, 0 },
	{ 1e1, 0 }, { 1e2, 0 }, { 1e3, 0 }, { 1e4, 0 }, { 1e5, 0 }, { 1e6, 0 },
	{ 1e7, 0 }, { 1e8, 0 }, { 1e9, 0 }, { 1e10, 0 }, { 1e11, 0 }, { 1e12, 0 },
	{ 1e13, 0 }, { 1e14, 0 }, { 1e15, 0 }, { 1e16, 0 }, { 1e17, 0 }, { 1e18, 0 },
	{ 1e19, 0 }, { 1e20, 0 } };
