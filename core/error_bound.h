/* How wrong a point's image can be. */
#ifndef ERROR_BOUND_H
#define ERROR_BOUND_H

#include "point.h"

/* For each precision, what no coordinate of the image of a point of the view
 * volume exceeds in error, in device or else ndc units, points being given in
 * model space; by the analysis in kernel/plain.h and, for exact, points.h. nan
 * where a number on the way could be beyond the precision's range. Returns
 * NULL, or the member and the reason. */
const char *error_bounds(const struct scene *, double bound[3]);

#endif
