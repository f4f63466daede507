#include "print.h"

#include <math.h>
#include <string.h>

void put_text(struct printer *p, const char *s)
{
	size_t n = strlen(s);

	memcpy(p->at, s, n);
	p->at += n;
}

void enter(struct printer *p, const char *bracket)
{
	put_text(p, p->between);
	put_text(p, bracket);
	p->between = "";
}

void leave(struct printer *p, const char *bracket)
{
	put_text(p, bracket);
	p->between = ", ";
}

void put_name(struct printer *p, const char *name)
{
	enter(p, "\"");
	put_text(p, name);
	put_text(p, "\": ");
}

void member(struct printer *p, const char *name)
{
	p->between = p->between[0] == ',' ? ",\n  " : "\n  ";
	put_name(p, name);
}

void put_word(struct printer *p, const char *word)
{
	enter(p, "\"");
	put_text(p, word);
	leave(p, "\"");
}

void put_number(struct printer *p, double v)
{
	put_text(p, p->between);
	if (isnan(v))
		put_text(p, "null");
	else
		p->at = number_write(p->at, v, p->style);
	p->between = ", ";
}

void put_numbers(struct printer *p, const double *v, int n)
{
	enter(p, "[");
	for (int i = 0; i < n; i++)
		put_number(p, v[i]);
	leave(p, "]");
}
