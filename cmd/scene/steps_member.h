/* SPDX-License-Identifier: MIT */
/* The members that are an affine matrix or a list of steps: world of a scene, pose and
 * matrix of a camera. The steps of a list are kept here until the next document with
 * such a list is read, and struct steps of core/scene points to them; of the world also
 * the value, which is printed as it was given, until the next document is parsed. */
#pragma once

#include "../json/object.h"

/* In the struct a struct steps. */
extern const struct member_type type_steps;

/* The members of a step. */
extern const struct member step_members[];
extern const struct rule step_rules[];
