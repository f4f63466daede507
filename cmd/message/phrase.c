/* SPDX-License-Identifier: MIT */
#include "phrase.h"

#include <stdarg.h>
#include <stdio.h>

const char *text(const char *format, ...)
{
	enum { TEXTS = 8 };
	static _Thread_local char texts[TEXTS][TEXT_ROOM];
	static _Thread_local unsigned next;
	char *const out = texts[next++ % TEXTS];
	va_list args;

	va_start(args, format);
	vsnprintf(out, TEXT_ROOM, format, args);
	va_end(args);
	return out;
}
