/* SPDX-License-Identifier: MIT */
#include "phrase.h"

#include <stdarg.h>
#include <stdio.h>

const char *text(const char *format, ...)
{
	static _Thread_local char texts[4][TEXT_ROOM];
	static _Thread_local unsigned next;
	char *const out = texts[next++ % 4];
	va_list args;

	va_start(args, format);
	vsnprintf(out, TEXT_ROOM, format, args);
	va_end(args);
	return out;
}
