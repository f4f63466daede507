/* A sum of products with the sum of their magnitudes, by which its rounding
 * errors are bounded. */
#ifndef SUM_H
#define SUM_H

#include "dd.h"
#include "exact.h"

struct sum {
	dd value;
	double size;
};

struct ex_sum {
	ex value;
	double size;
};

#endif
