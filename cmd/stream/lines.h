/* SPDX-License-Identifier: MIT */
/* --lines: takes points for runs, which lines join, and prints the parts inside. */
#pragma once

#include "../../core/scene/scene.h"

struct job;

/* Makes the job, whose transform and frustum are set, print the parts of runs from one
 * space to the other, in the style of its layout's output. Returns false if the scene
 * is refused. */
bool lines_prepare(const struct scene *, enum space from, enum space to, struct job *,
    struct refusals *faults);
