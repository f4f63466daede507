/* SPDX-License-Identifier: MIT */
/* --lines: takes points for runs, which lines join, and prints the parts inside. */
#pragma once

#include "../core/scene/scene.h"

struct document;
struct job;
struct options;

/* Makes the job, whose transform and frustum are set, print the parts of runs from one
 * space to the other. Returns false if the document is refused. */
bool lines_prepare(const struct options *, const struct document *, enum space from,
    enum space to, struct job *);
