/* SPDX-License-Identifier: MIT */
/* Formats the parts of messages. */
#pragma once

/* Returns text formatted as by printf, cut at TEXT_ROOM bytes. It is valid until the
 * thread's eighth call from now. */
enum { TEXT_ROOM = 4096 };
const char *text(const char *format, ...) __attribute__((format(printf, 1, 2)));
