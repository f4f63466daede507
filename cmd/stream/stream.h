/* SPDX-License-Identifier: MIT */
/* Does a job on sources of points, with threads that each work on their own chunks. */
#pragma once

#include "job.h"

/* Does the job on the points of a source, which source_begin has begun. Before it waits
 * for more input, prints the output for all points that were read. Prints errors and
 * ends the program after them. Each call must get the same struct job; its contents may
 * change between calls. */
void stream_points(struct job *, struct point_source);
