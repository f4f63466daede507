/* SPDX-License-Identifier: MIT */
/* Removes hidden lines from pictures. */
#pragma once

#include "picture.h"

/* Replaces segments by those parts of them that no face hides. Parts and gaps below
 * 1e-5 of the picture are not told apart. Faces change their order. */
void hidden_remove(struct picture *);
