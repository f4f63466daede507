#include "names.h"

#include <stddef.h>

const char *const precision_names[] = { "exact", "double", "single", NULL };
const char *const space_names[] = { "model", "world", "view", "clip", "ndc",
	"device", NULL };
