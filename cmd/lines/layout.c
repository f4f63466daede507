/* SPDX-License-Identifier: MIT */
#include "layout.h"

void layout_begin_source(struct layout *l)
{
	l->seen = (struct seen){ .reordered = l->seen.reordered };
	if (l->columns.by_default)
		l->columns.n = 0;
}
