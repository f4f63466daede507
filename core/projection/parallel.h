/* SPDX-License-Identifier: MIT */
/* Parallel projections along the gaze (ortho), or along another direction (oblique). */
#pragma once

#include "../exact/trig.h"
#include "type.h"

/* The shear of an oblique projection. */
struct projection_shear {
	enum { OBLIQUE_ANGLE, OBLIQUE_CAVALIER, OBLIQUE_CABINET } kind;
	double projector_angle; /* between projectors and the image plane */
	double direction;       /* in the picture, from +x to lines along the gaze */
	enum angle_unit direction_unit;
	double plane; /* points at this distance along the gaze stay put */
};
