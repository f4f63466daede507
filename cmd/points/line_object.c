/* SPDX-License-Identifier: MIT */
#include "line_object.h"

#include <stdlib.h>
#include <string.h>

#include "../json/scan.h"
#include "names.h"

bool json_place_next(struct json_place *p, const char *end)
{
	const char *after = json_next(p->before, end, &p->value.s);

	if (after == NULL)
		return false;
	p->s = json_space(p->before + 1, end);
	p->value.end = p->after = after;
	while ((unsigned char)p->value.end[-1] <= ' ')
		p->value.end--;
	return true;
}

/* Whether the name at s, a string of checked text, is name[0..n). */
static bool is_name(const char *s, const char *end, const char *name, size_t n)
{
	const char *stop = json_string(s, end) - 1, *name_end = name + n;
	char character[4];
	int size;

	for (s++; s < stop && name < name_end; name += size) {
		character[0] = *s;
		size = 1;
		s = *s == '\\' ? json_unescape(s, stop, character, &size) :
				 s + 1;
		if (name_end - name < size ||
		    memcmp(name, character, (size_t)size) != 0)
			return false;
	}
	return s == stop && name == name_end;
}

/* The member of that name in the object at s. */
static int find_member(const char *s, const char *end, const char *name,
    size_t n, struct json_place *found)
{
	struct json_place p = { .before = s };
	int times = 0;

	for (; json_place_next(&p, end); p.before = p.after)
		if (is_name(p.s, end, name, n)) {
			*found = p;
			times++;
		}
	return times;
}

static int find_element(const char *s, const char *end, const char *number,
    size_t n, struct json_place *found)
{
	long k = strtol(number, NULL, 10);

	*found = (struct json_place){ .before = s };
	if (n == 0 || n > 9 || strspn(number, "0123456789") < n ||
	    (n > 1 && *number == '0'))
		return 0;
	while (json_place_next(found, end)) {
		if (k-- == 0)
			return 1;
		found->before = found->after;
	}
	return 0;
}

enum { TOKEN_ROOM = 1024 };

/* The next part of a pointer, without its escapes: ~1 is /, ~0 is ~. NULL where it
 * is too long. */
static const char *next_token(const char *s, char token[TOKEN_ROOM], size_t *n)
{
	for (*n = 0; *s != '\0' && *s != '/'; s++) {
		if (*n == TOKEN_ROOM - 1)
			return NULL;
		token[*n] = *s;
		if (*s == '~' && (s[1] == '0' || s[1] == '1'))
			token[*n] = *++s == '0' ? '~' : '/';
		++*n;
	}
	token[*n] = '\0';
	return s;
}

int json_place_find(struct span object, const char *path, struct json_place *p)
{
	char token[TOKEN_ROOM];
	size_t n;
	int times = 1;

	object.s = json_space(object.s, object.end);
	if (*path != '/')
		return find_member(object.s, object.end, path, strlen(path), p);
	p->value = object;
	while (times == 1 && path != NULL && *path == '/') {
		const char *s = p->value.s;

		path = next_token(path + 1, token, &n);
		if (path == NULL)
			return 0;
		times = *s == '{' ? find_member(s, object.end, token, n, p) :
		    *s == '['     ? find_element(s, object.end, token, n, p) :
				    0;
	}
	return times;
}

struct span json_place_whole(const struct json_place *p)
{
	if (*p->before == ',')
		return (struct span){ p->before, p->value.end };
	return (struct span){ p->s,
		*p->after == ',' ? p->after + 1 : p->value.end };
}

void json_place_names(struct span object, struct names *names)
{
	struct json_place p = { .before = object.s };

	for (; json_place_next(&p, object.end); p.before = p.after)
		names_add(names,
		    (struct span){ p.s + 1, json_string(p.s, object.end) - 1 });
}
