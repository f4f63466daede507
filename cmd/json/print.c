/* SPDX-License-Identifier: MIT */
#include "print.h"

#include <math.h>
#include <string.h>

#include "../message/escape.h"

void put_text(struct printer *p, const char *s)
{
	p->at = stpcpy(p->at, s);
}

void put_open(struct printer *p, const char *bracket)
{
	if (p->separator != NULL)
		put_text(p, p->separator);
	put_text(p, bracket);
	p->separator = "";
	p->level++;
}

void put_close(struct printer *p, const char *bracket)
{
	if (--p->level == 0 && *bracket == '}' && !p->compact)
		put_text(p, "\n");
	put_text(p, bracket);
	p->separator = p->compact ? "," : ", ";
}

struct printer *put_name(struct printer *p, const char *name)
{
	if (p->level == 1 && !p->compact)
		p->separator = *p->separator == ',' ? ",\n  " : "\n  ";
	put_string(p, name);
	put_text(p, p->compact ? ":" : ": ");
	p->separator = "";
	return p;
}

void put_string(struct printer *p, const char *s)
{
	const size_t n = s != NULL ? strlen(s) : 0;

	put_open(p, s != NULL ? "\"" : "null");
	if (s != NULL)
		p->at += escape_copy(p->at, JSON_ESCAPE_MAX * n + 1, s, n, true, "");
	put_close(p, s != NULL ? "\"" : "");
}

void put_literal(struct printer *p, const char *word)
{
	put_open(p, word);
	put_close(p, "");
}

void put_number(struct printer *p, double v)
{
	put_open(p, isfinite(v) ? "" : "null");
	if (isfinite(v) && p->floats)
		p->at = number_write_float(p->at, (float)v, p->style);
	else if (isfinite(v))
		p->at = number_write(p->at, v, p->style);
	put_close(p, "");
}

void put_distance(struct printer *p, double v)
{
	if (isinf(v))
		put_string(p, "infinity");
	else
		put_number(p, v);
}

void put_numbers(struct printer *p, const double *v, int n)
{
	if (isnan(*v))
		n = 0;
	if (n > 0)
		put_open(p, "[");
	for (int i = 0; i == 0 || i < n; i++)
		put_number(p, v[i]);
	if (n > 0)
		put_close(p, "]");
}

void put_rows(struct printer *p, const double *v, int rows, int n)
{
	put_open(p, "[");
	for (int i = 0; i < rows; i++)
		put_numbers(p, v + i * n, n);
	put_close(p, "]");
}
