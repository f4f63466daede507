/* SPDX-License-Identifier: MIT */
/* Projections that are given by their view volume: its section at view z = 0, two
 * planes of constant z, and the eye. */
#pragma once

#include "../exact/trig.h"
#include "type.h"

struct projection_volume {
	double half_width, half_height; /* with an aspect, of the smaller side */
	double z_near, z_far;
	/* The member that gives the eye; a view_angle of 0 makes the projection
	 * parallel. */
	enum { EYE_BY_INVERSE_Z, EYE_BY_POINT, EYE_BY_ANGLE } eye_given_by;
	double inverse_eye_z, eye[3], view_angle; /* eye: in view space */
	double tan_skew[2];                       /* x/z, y/z of the axis */
};

/* Computes 1/z of a volume's eye in view space. The denominator is exact. */
void projection_inverse_eye_z(const struct projection *, struct sum *numerator,
    struct sum *denominator);
